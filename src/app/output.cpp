// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.hpp"

#include <fmt/core.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

#include "literate/figures/gnuplot.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr const char* terminal_name = "-";

// A new folder that is removed at the end of its scope.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "halfspace-plot-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw sys::OutputError(fmt::format("cannot make the folder '{}'", name));
    }
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// What a picture of this name is drawn on; none if its ending is of no kind.
const literate::Canvas* canvas_of(const std::string& picture) {
  static const std::vector<literate::Canvas> canvases = {
      {"svg size 50 * width_cm, 50 * height_cm dynamic background '#ffffff' font 'Helvetica,16'",
       ".svg"},
      {"pngcairo size 60 * width_cm, 60 * height_cm font 'Helvetica,16'", ".png"},
      {"pdfcairo size width_cm cm, height_cm cm", ".pdf"},
      {"dumb noenhanced size 79, 24", terminal_name}};
  const std::string ending =
      picture == terminal_name ? picture : fs::path(picture).extension().string();
  const auto found = std::ranges::find(canvases, ending, &literate::Canvas::ending);
  return found == canvases.end() ? nullptr : &*found;
}

// A gnuplot script of the folder plots beside the program. It is no part of the program, since a
// changed look must compile nothing.
std::string plot_script(const std::string& name) {
  const fs::path file = fs::read_symlink("/proc/self/exe").parent_path() / "plots" / (name + ".gp");
  if (!fs::is_regular_file(file)) {
    throw sys::ToolError(fmt::format(
        "--plot: there is no {}, the script of the picture: run `make report` in the checkout",
        file.string()));
  }
  return sys::read_file(file);
}

}  // namespace

std::optional<parameters::Case> case_of(const std::string& file) {
  if (file.empty()) return std::nullopt;
  return parameters::read_case(file);
}

void require_folder_of(const std::string& flag, const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  std::error_code ignored;
  if (folder.empty() || fs::is_directory(folder, ignored)) return;
  throw sys::InputError(fmt::format("{} {}: folder does not exist", flag, file));
}

double place(int i, int n, double begin, double end) {
  return begin + (end - begin) * i / (n - 1);
}

literate::FigureData curve(const std::string& of_places, const std::string& of_values, int n,
                           double begin, double end, const std::function<double(double)>& value) {
  std::vector<double> places, values;
  for (int i = 0; i < n; ++i) {
    places.push_back(place(i, n, begin, end));
    values.push_back(value(places.back()));
  }
  return {{of_places, places}, {of_values, values}};
}

void Output::add_to(CLI::App& command) {
  add_choice(command, "--format", format_, {"table", "csv", "json"}, "How to print");
  add_text(
      command, "--units", units_, "NAME",
      "Units of the numbers given, for the headings of a table: in-lbf (default), mm-N or m-N");
  add_text(command, "--plot", plot_, "FILE.svg|FILE.png|FILE.pdf|-",
           "Draw the result in the report's style; - draws it in the terminal");
}

config::UnitSystem Output::units(const std::optional<parameters::Case>& from_file) const {
  if (from_file && !units_.empty() && units_ != from_file->units.name) {
    throw sys::InputError("--units " + units_ + ": the case is in " + from_file->units.name);
  }
  require_drawable();
  if (from_file) return from_file->units;
  return units_.empty() ? config::unit_systems().front() : config::unit_system(units_);
}

void Output::require_drawable() const {
  if (plot_.empty()) return;
  if (plot_ == terminal_name) {
    if (format_ == "table") return;
    throw sys::InputError("--plot -: needs --format table, which it stands below");
  }
  if (canvas_of(plot_) == nullptr) {
    throw sys::InputError(
        fmt::format("--plot {}: must end with .svg, .png or .pdf, or be -", plot_));
  }
  require_folder_of("--plot", plot_);
}

ExitCode Output::print(const Result& result) const {
  require_finite(result);
  for (const std::string& warning : result.warnings) {
    fmt::print(stderr, "{}: warning: {}\n", program_name(), warning);
  }
  fmt::print("{}", format_ == "csv"    ? csv_text(result.tables.front())
                   : format_ == "json" ? json_of(result)
                                       : text_for_people(result));
  if (!plot_.empty() && result.figure) draw(result.script, result.figure());
  return ExitCode::success;
}

void Output::draw(const std::string& script, literate::Figure figure) const {
  const bool is_terminal = plot_ == terminal_name;
  if (is_terminal) figure.numbers["in_terminal"] = 1;
  literate::require_drawable(figure);
  const literate::Canvas& canvas = *canvas_of(plot_);

  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "figure";
  literate::write_figure(folder, script, figure, canvas);
  sys::write_file_atomically(scratch.path() / "style.gp", plot_script("style"));
  sys::write_file_atomically(folder / "script.gp", plot_script(script));

  const sys::ProcessResult result = literate::run_gnuplot(folder, script);
  const fs::path drawn = folder / (script + canvas.ending);
  std::error_code ignored;
  const bool is_there = fs::is_regular_file(drawn, ignored) && fs::file_size(drawn, ignored) > 0;
  if (result.exit_status != 0 || !is_there) {
    throw sys::ToolError(fmt::format("gnuplot could not draw {}: {}", plot_,
                                     std::string(sys::stripped(result.output))));
  }
  std::string picture = sys::read_file(drawn);
  if (is_terminal) {
    std::erase(picture, '\f');  // gnuplot begins a page with a form feed
    fmt::print("{}", picture);
  } else {
    sys::write_file_atomically(plot_, picture);
  }
}

}  // namespace app
