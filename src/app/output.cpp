// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "system/error.hpp"

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr const char* group = "Input and output";
enum class Format { table, csv, json };

}  // namespace

Output::Output(CLI::App& command, const std::string& tables)
    : case_(command, "--case", "FILE", group,
            "A case file (TOML) with " + tables + "; flags override it"),
      units_(command, "--units", "mm-N|m-N|in-lbf", group,
             "System of all numbers without a unit, and of the result: mm, N, MPa; m, N, Pa; in, "
             "lbf, psi [mm-N, or the case's]"),
      format_(command, "--format", "table|csv|json", group,
              "How to print: for people, or with all digits for programs [table]"),
      plot_(command, "--plot", "FILE", group,
            "Draw the result in a .svg, .png or .pdf file; - draws it in the terminal") {}

Given Output::given() const {
  const std::string units = units_.choice_or<std::string>(
      "mm-N", {{"mm-N", "mm-N"}, {"m-N", "m-N"}, {"in-lbf", "in-lbf"}});
  Given given{std::nullopt, config::unit_system(units)};
  const auto format = format_.choice_or(
      Format::table, {{"table", Format::table}, {"csv", Format::csv}, {"json", Format::json}});
  if (plot_.text() == "-" && format != Format::table) {
    plot_.refuse("needs --format table, below which it is drawn");
  }
  if (plot_.is_given()) require_drawable(plot_);
  if (!case_.is_given()) return given;
  given.file.emplace(case_.text());
  const config::UnitSystem& of_case = given.file->units();
  if (units_.is_given() && units != of_case.name) units_.refuse("the case is in " + of_case.name);
  given.units = of_case;
  return given;
}

command_line::ExitCode Output::print(const Result& result,
                                     const std::function<Picture()>& picture) const {
  require_finite(result);
  const std::string text = is_csv()                   ? csv_of(result.table)
                           : format_.text() == "json" ? json_of(result)
                                                      : text_of(result);
  for (const std::string& warning : result.warnings) {
    fmt::print(stderr, "{}: warning: {}\n", command_line::program_name(), warning);
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (plot_.is_given()) draw(picture(), plot_.text());
  return command_line::ExitCode::success;
}

void require_folder_of(const Flag& flag) {
  const fs::path folder = fs::path(flag.text()).parent_path();
  std::error_code ignored;
  if (!folder.empty() && !fs::is_directory(folder, ignored)) flag.refuse("folder does not exist");
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
