// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output.hpp"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <cstdio>
#include <filesystem>
#include <map>

#include "command_line/exit_codes.hpp"
#include "system/error.hpp"
#include "system/tool.hpp"

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr const char* group = "Input and output";

const std::map<std::string, std::string>& terminals() {
  static const std::map<std::string, std::string> by_ending = {
      {"-", "dumb noenhanced size 79, 25"},
      {".svg", "svg noenhanced size 700, 450 dynamic background '#ffffff' font 'Helvetica,16'"},
      {".png", "pngcairo noenhanced size 1050, 675 font 'Helvetica,18'"},
      {".pdf", "pdfcairo noenhanced size 14 cm, 9 cm font 'Helvetica,12'"}};
  return by_ending;
}

std::string ending_of(const std::string& where) {
  return where == "-" ? where : fs::path(where).extension().string();
}

// Quotes a text for gnuplot.
std::string quoted(const std::string& text) {
  std::string quoted;
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return "'" + quoted + "'";
}

void set_up(Gnuplot& gnuplot, const Picture& picture, const std::string& terminal, bool is_text) {
  gnuplot << "set terminal " << terminal << "\n"
          << "set encoding utf8\n"
          << "set grid\n"
          << "set xlabel " << quoted(picture.x_label) << "\n"
          << "set key outside top center horizontal\n"
          << "set style line 1 linewidth 2 linecolor rgb '#1f5f99'\n"
          << "set style line 2 linewidth 2 linecolor rgb '#b5541c'\n"
          << "set style line 3 linewidth 2 linecolor rgb '#3a7d44'\n";
  if (is_text) {
    // A terminal cannot print vertical text, so the label of the y axis goes above it.
    gnuplot << "set label 1 " << quoted(picture.y_label) << " at graph 0, screen 0.95\n"
            << "set tmargin 4\nset key width 4\n";
  } else {
    gnuplot << "set ylabel " << quoted(picture.y_label) << "\n";
  }
}

void plot(Gnuplot& gnuplot, const std::vector<Curve>& curves, bool is_text) {
  int i = 0;
  for (const Curve& curve : curves) {
    ++i;
    gnuplot << (i == 1 ? "plot " : ", ") << "'-' with "
            << (curve.is_line ? fmt::format("lines linestyle {}", i)
                : is_text     ? std::string("points pointtype '*'")
                              : fmt::format("points linestyle {} pointtype 6 pointsize 0.6", i))
            << " title " << quoted(curve.title);
  }
  gnuplot << "\n";
  for (const Curve& curve : curves) gnuplot.send1d(std::make_pair(curve.x, curve.y));
}

// Rejects a picture that cannot be drawn, before anything is computed.
void require_drawable(const Flag& where) {
  if (!terminals().contains(ending_of(where.text()))) {
    where.refuse("must end with .svg, .png or .pdf, or be -");
  }
  const fs::path folder = fs::path(where.text()).parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) where.refuse("folder does not exist");
}

// Draws the picture.
void draw(const Picture& picture, const std::string& where) {
  const bool is_text = where == "-";
  std::error_code ignored;
  if (!is_text) fs::remove(where, ignored);
  std::fflush(stdout);  // gnuplot writes to the same terminal
  {
    // Default settings ignore the user's ~/.gnuplot. The dumb terminal starts with a form feed and
    // does not end its last line.
    const std::string program =
        "LC_ALL=C.UTF-8 '" + sys::find_tool("gnuplot").string() + "' --default-settings";
    Gnuplot gnuplot(is_text ? program + " | tr -d '\\f'; echo" : program);
    set_up(gnuplot, picture, terminals().at(ending_of(where)), is_text);
    if (!is_text) gnuplot << "set output " << quoted(where) << "\n";
    plot(gnuplot, picture.curves, is_text);
  }
  if (!is_text && !fs::exists(where, ignored)) {
    throw sys::ToolError(fmt::format("gnuplot could not draw {}", where));
  }
}

}  // namespace

Output::Output(CLI::App& command, const std::string& tables)
    : case_(command, "--case", "FILE", group,
            "A case file (TOML) with " + tables + "; flags override it"),
      units_(command, "--units", {"mm-N", "m-N", "in-lbf"}, group,
             "System of units of the result and of plain numbers: mm, N, MPa; m, N, Pa; in, lbf, "
             "psi [mm-N, or the case's]"),
      format_(command, "--format", {"table", "csv", "json"}, group,
              "Output format: a rounded table, or CSV or JSON with all digits [table]"),
      plot_(command, "--plot", "FILE", group,
            "Draw the result in a .svg, .png or .pdf file; - draws it in the terminal") {}

Given Output::given() const {
  Given given{std::nullopt, config::unit_system(units_.text_or("mm-N"))};
  if (plot_.text() == "-" && format() != "table") {
    plot_.refuse("needs --format table; the plot is printed below the table");
  }
  if (plot_.is_given()) require_drawable(plot_);
  if (!case_.is_given()) return given;
  given.file.emplace(case_.text());
  const config::UnitSystem& of_case = given.file->units();
  if (units_.is_given() && units_.text() != of_case.name)
    units_.refuse("the case is in " + of_case.name);
  given.units = of_case;
  return given;
}

void Output::print(const Result& result, const std::function<Picture()>& picture) const {
  const std::string text = format() == "csv"    ? csv_of(result.table)
                           : format() == "json" ? json_of(result)
                                                : text_of(result);
  for (const std::string& warning : result.warnings) {
    fmt::print(stderr, "{}: warning: {}\n", command_line::program_name(), warning);
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (plot_.is_given()) draw(picture(), plot_.text());
}

Curve line(const std::string& title, double begin, double end,
           const std::function<double(double)>& value) {
  constexpr int n = 400;
  Curve curve{title, true, {}, {}};
  for (int i = 0; i <= n; ++i) {
    curve.x.push_back(begin + (end - begin) * i / n);
    curve.y.push_back(value(curve.x.back()));
  }
  return curve;
}

}  // namespace app
