// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/feedback.hpp"

#include <fmt/core.h>

#include "course/sandbox/scratch_folder.hpp"
#include "system/files.hpp"
#include "system/process.hpp"

namespace course {
namespace {

std::string script_of(const Curve& curve, bool has_style) {
  std::string script = fmt::format(
      "set encoding utf8\n"
      "set terminal svg size 440,280 dynamic font 'sans-serif,13' name '{3}'\n"
      "set output 'curve.svg'\n"
      "set title '{0}' noenhanced\nset xlabel '{1}' noenhanced\nset ylabel '{2}' noenhanced\n"
      "{4}"
      "unset key\nset format '%.3g'\n"
      "plot '-' using 1:2 with linespoints linestyle 1 pt 7 ps 0.4\n",
      curve.title, curve.x_label, curve.y_label, sys::sha256_of_text(curve.title).substr(0, 8),
      has_style ? "load 'style.gp'\n" : "set grid\n");
  for (std::size_t i = 0; i < curve.x.size() && i < curve.y.size(); ++i) {
    script += fmt::format("{} {}\n", curve.x[i], curve.y[i]);
  }
  return script + "e\n";
}

}  // namespace

std::filesystem::path style_of(const Assignment& assignment) {
  return assignment.folder / "figures/style.gp";
}

std::string svg_of(const Curve& curve, const std::filesystem::path& style) {
  if (curve.x.empty() || curve.x.size() != curve.y.size()) return "";
  const ScratchFolder scratch;
  const bool has_style = std::filesystem::exists(style);
  if (has_style) std::filesystem::copy_file(style, scratch.path() / "style.gp");
  sys::write_file_atomically(scratch.path() / "curve.gp", script_of(curve, has_style));
  const sys::ProcessResult result =
      sys::run({.program = "gnuplot",
                .arguments = {"--default-settings", "curve.gp"},
                .working_directory = scratch.path(),
                .environment = {{"LC_ALL", "C.UTF-8"}, {"SOURCE_DATE_EPOCH", "0"}},
                .ends_with_caller = true});
  const std::filesystem::path picture = scratch.path() / "curve.svg";
  if (result.exit_status != 0 || !std::filesystem::exists(picture)) return "";
  return sys::read_file(picture);
}

}  // namespace course
