// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plot.hpp"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <cstdio>
#include <filesystem>
#include <map>

#include "app/output.hpp"
#include "system/error.hpp"
#include "system/process.hpp"

namespace app {
namespace fs = std::filesystem;
namespace {

const std::map<std::string, std::string>& terminals() {
  static const std::map<std::string, std::string> by_ending = {
      {"-", "dumb nofeed noenhanced size 79, 25"},
      {".svg", "svg noenhanced size 700, 450 dynamic background '#ffffff' font 'Helvetica,16'"},
      {".png", "pngcairo noenhanced size 1050, 675 font 'Helvetica,18'"},
      {".pdf", "pdfcairo noenhanced size 14 cm, 9 cm font 'Helvetica,12'"}};
  return by_ending;
}

std::string ending_of(const std::string& where) {
  return where == "-" ? where : fs::path(where).extension().string();
}

// A text within gnuplot's single quotes.
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
    // Characters cannot stand upright, so the label of the y axis stands above it.
    gnuplot << "set label 1 " << quoted(picture.y_label) << " at graph 0, screen 0.95\n"
            << "set tmargin 4\n";
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

}  // namespace

void require_drawable(const Flag& where) {
  if (!terminals().contains(ending_of(where.text()))) {
    where.refuse("must end with .svg, .png or .pdf, or be -");
  }
  require_folder_of(where);
}

void draw(const Picture& picture, const std::string& where) {
  const std::string gnuplot_file = sys::find_tool("gnuplot").string();
  const bool is_text = where == "-";
  const std::string part = where + ".part";
  std::fflush(stdout);  // gnuplot writes on the same terminal
  {
    // With default settings it does not read the user's ~/.gnuplot.
    Gnuplot gnuplot("LC_ALL=C.UTF-8 '" + gnuplot_file + "' --default-settings");
    set_up(gnuplot, picture, terminals().at(ending_of(where)), is_text);
    if (!is_text) gnuplot << "set output " << quoted(part) << "\n";
    plot(gnuplot, picture.curves, is_text);
  }
  if (is_text) {
    fmt::print("\n");  // gnuplot does not end its last line
    return;
  }
  std::error_code error;
  if (!fs::is_regular_file(part, error) || fs::file_size(part, error) == 0) {
    fs::remove(part, error);
    throw sys::ToolError(fmt::format("gnuplot could not draw {}", where));
  }
  fs::rename(part, where, error);
  if (error) throw sys::InputError(fmt::format("--plot {}: {}", where, error.message()));
}

}  // namespace app
