// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/plotted.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "literate/figures/gnuplot.hpp"
#include "system/decimal.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view frame_mark = "literate-frame";
constexpr const char* table_name = "points.table";

/// Says frame, axes and labels. GPVAL_X_LOG is 10 whether or not the axis is logarithmic, so that
/// `show` has to tell.
constexpr const char* tell_frame =
    "print sprintf('literate-frame %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g', "
    "GPVAL_TERM_XMIN * GPVAL_TERM_SCALE / (1.0 * GPVAL_TERM_XSIZE), "
    "GPVAL_TERM_XMAX * GPVAL_TERM_SCALE / (1.0 * GPVAL_TERM_XSIZE), "
    "GPVAL_TERM_YMIN * GPVAL_TERM_SCALE / (1.0 * GPVAL_TERM_YSIZE), "
    "GPVAL_TERM_YMAX * GPVAL_TERM_SCALE / (1.0 * GPVAL_TERM_YSIZE), "
    "GPVAL_X_MIN, GPVAL_X_MAX, GPVAL_Y_MIN, GPVAL_Y_MAX)\n"
    "show xlabel\nshow ylabel\nshow logscale\n";

bool begins_with_word(std::string_view line, std::string_view word) {
  const std::string_view text = sys::stripped(line);
  return text.starts_with(word) && (text.size() == word.size() || text[word.size()] == ' ');
}

bool is_plot(std::string_view line) {
  return begins_with_word(line, "plot") || begins_with_word(line, "splot");
}

bool goes_on(std::string_view line) {
  return sys::stripped(line).ends_with('\\');
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    line = sys::stripped(line);
    if (line.empty()) return words;
    const auto end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

/// What stands between the first and the last quotation mark of a line, without the backslashes by
/// which gnuplot protects a quotation mark or a backslash.
std::string quoted_in(std::string_view line) {
  const auto first = line.find('"');
  const auto last = line.rfind('"');
  if (first == std::string_view::npos || first == last) return {};
  std::string text;
  for (std::size_t i = first + 1; i < last; ++i) {
    if (line[i] == '\\' && i + 1 < last && (line[i + 1] == '"' || line[i + 1] == '\\')) ++i;
    text += line[i];
  }
  return text;
}

/// A title as the script gives it. The one that gnuplot makes of a curve without, such as
/// «curve using 1:2», is none.
std::string title_in(std::string_view line) {
  constexpr std::string_view between = " using ";
  std::string title = quoted_in(line);
  const auto at = title.find(between);
  if (at == std::string::npos) return title;
  const std::string columns = title.substr(at + between.size());
  const bool is_own = columns.find_first_of("(\"0123456789") == 0;
  return is_own ? std::string() : title;
}

/// The frames and axes that a script said, one a plot; none if a line is not as expected.
std::vector<PlottedPanel> panels_in(const std::string& said) {
  std::vector<PlottedPanel> panels;
  for (const std::string_view line : sys::lines_of(said)) {
    if (line.starts_with(frame_mark)) {
      std::vector<double> n;
      for (const std::string_view word : words_of(line.substr(frame_mark.size()))) {
        if (const auto number = sys::parsed<double>(word)) n.push_back(*number);
      }
      if (n.size() != 8) return {};
      panels.push_back({.left = n[0],
                        .right = n[1],
                        .bottom = n[2],
                        .top = n[3],
                        .x = {.label = "", .at_start = n[4], .at_end = n[5]},
                        .y = {.label = "", .at_start = n[6], .at_end = n[7]},
                        .curves = {}});
    } else if (!panels.empty() && begins_with_word(line, "xlabel")) {
      panels.back().x.label = quoted_in(line);
    } else if (!panels.empty() && begins_with_word(line, "ylabel")) {
      panels.back().y.label = quoted_in(line);
    } else if (!panels.empty() && begins_with_word(line, "logscaling")) {
      const auto words = words_of(line);
      panels.back().x.is_logarithmic = std::ranges::count(words, "x") > 0;
      panels.back().y.is_logarithmic = std::ranges::count(words, "y") > 0;
    }
  }
  return panels;
}

/// Puts the curves of gnuplot's table into the panels, in order: «# Curve 0 of 3, 40 points» begins
/// the first curve of a plot. Returns whether all of it was understood.
bool add_curves(const std::string& table, std::vector<PlottedPanel>& panels) {
  std::size_t n_plots = 0;
  PlottedCurve* curve = nullptr;
  for (const std::string_view line : sys::lines_of(table)) {
    const auto words = words_of(line);
    if (line.starts_with("# Curve ") && words.size() > 2 && words[2] != "title:") {
      if (words[2] == "0") ++n_plots;
      if (n_plots == 0 || n_plots > panels.size()) return false;
      curve = &panels[n_plots - 1].curves.emplace_back();
    } else if (line.starts_with("# Curve title:") && curve != nullptr) {
      curve->title = title_in(line);
    } else if (line.starts_with("# Surface")) {
      return false;
    } else if (!line.starts_with("#") && words.size() >= 3 && words.back() == "i") {
      if (curve == nullptr) return false;
      const auto x = sys::parsed<double>(words[0]), y = sys::parsed<double>(words[1]);
      if (!x || !y) return false;
      curve->points.emplace_back(*x, *y);
    }
  }
  return n_plots == panels.size();
}

/// Whether a script draws against the axes above or at the right, of which frames tell nothing.
bool has_second_axes(const std::string& script) {
  constexpr std::array<std::string_view, 3> others = {"x1y2", "x2y1", "x2y2"};
  return std::ranges::any_of(
      others, [&](std::string_view axes) { return script.find(axes) != std::string::npos; });
}

/// Runs another form of a figure's script on its data, in a folder of its own.
sys::ProcessResult run_as(const fs::path& folder, const std::string& name, const fs::path& copy,
                          const std::string& script, const std::string& settings) {
  copy_computed(folder, name, copy);
  fs::copy_file(folder.parent_path() / "style.gp", copy.parent_path() / "style.gp");
  sys::write_file_atomically(copy / "script.gp", script);
  return run_gnuplot(copy, name, settings);
}

/// All points of a script's plots as gnuplot lists them; none if it cannot.
std::optional<std::string> table_of_points(const fs::path& folder, const std::string& name,
                                           const fs::path& scratch, const std::string& script) {
  const fs::path copy = scratch / "points" / name;
  const auto points =
      run_as(folder, name, copy, script, std::string("set table '") + table_name + "'");
  if (points.exit_status != 0 || !fs::is_regular_file(copy / table_name)) return std::nullopt;
  return sys::read_file(copy / table_name);
}

}  // namespace

std::string telling_axes(const std::string& script) {
  std::string text;
  bool is_plotting = false;
  for (const std::string_view line : sys::lines_of(script)) {
    text += std::string(line) + "\n";
    is_plotting = is_plotting || is_plot(line);
    if (is_plotting && !goes_on(line)) {
      text += tell_frame;
      is_plotting = false;
    }
  }
  return text;
}

std::string telling_points(const std::string& script, const std::string& before_plots) {
  std::string text;
  bool goes_on_left_out = false;
  for (const std::string_view line : sys::lines_of(script)) {
    const bool is_page = begins_with_word(line, "set multiplot") ||
                         begins_with_word(line, "unset multiplot") || goes_on_left_out;
    goes_on_left_out = is_page && goes_on(line);
    if (is_page) continue;
    if (is_plot(line)) text += "set format '%.10g'\n" + before_plots;
    text += std::string(line) + "\n";
  }
  return text;
}

std::vector<PlottedPanel> plotted_panels(const fs::path& folder, const std::string& name,
                                         const fs::path& scratch) {
  const std::string script = sys::read_file(folder / "script.gp");
  if (has_second_axes(script)) return {};
  const auto frames = run_as(folder, name, scratch / "frames" / name, telling_axes(script), {});
  std::vector<PlottedPanel> panels = panels_in(frames.output);
  if (frames.exit_status != 0 || panels.empty()) return {};

  const auto table = table_of_points(folder, name, scratch, telling_points(script));
  if (!table || !add_curves(*table, panels)) return {};
  return panels;
}

std::size_t n_points_outside(const fs::path& folder, const std::string& name,
                             const fs::path& scratch) {
  // A function has as many points as there are samples, so they are more than any data have.
  std::ptrdiff_t n_samples = 2;
  for (const std::string& file : sys::files_below(folder)) {
    if (file.ends_with(".csv"))
      n_samples += std::ranges::count(sys::read_file(folder / file), '\n');
  }
  const auto table =
      table_of_points(folder, name, scratch,
                      telling_points(sys::read_file(folder / "script.gp"),
                                     "set samples " + std::to_string(n_samples) + "\n"));
  if (!table) return 0;
  const std::string of_function = ", " + std::to_string(n_samples) + " points";
  std::size_t n_outside = 0;
  bool is_data = true;
  for (const std::string_view line : sys::lines_of(*table)) {
    if (line.find(" points") != line.npos && line.starts_with("#")) {
      is_data = !line.ends_with(of_function);
    } else if (is_data && !line.starts_with("#")) {
      // On a logarithmic axis a negative number is undefined, as a gap is, which is no number.
      const std::string_view point = sys::stripped(line);
      const bool is_number = point.find("NaN") == point.npos;
      if (point.ends_with(" o") || (point.ends_with(" u") && is_number)) ++n_outside;
    }
  }
  return n_outside;
}

std::vector<std::string> unread_blocks(const fs::path& folder) {
  const std::string text = sys::read_file(folder / "script.gp");
  std::string script;
  for (const std::string_view line : sys::lines_of(text)) {
    if (!sys::stripped(line).starts_with('#')) script.append(line) += '\n';
  }
  if (script.find("value(") != script.npos) return {};
  std::vector<std::string> unread;
  for (const std::string& file : sys::files_below(folder)) {
    const fs::path path(file);
    // The name of a block is an identifier, and so needs no escape in the pattern.
    const std::string block = path.stem().string();
    if (path.extension() == ".csv" && !sys::Pattern("\\b" + block + "\\b").is_in(script))
      unread.push_back(block);
  }
  return unread;
}

}  // namespace literate
