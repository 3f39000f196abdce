// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture.hpp"

#include <fmt/core.h>
#include <stdlib.h>

#include <filesystem>
#include <system_error>

#include "app/output_file.hpp"
#include "command_line/options.hpp"
#include "literate/figures/gnuplot.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"

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

std::string terminal_for(const std::string& ending) {
  if (ending == ".svg") {
    return "set terminal svg size 50 * width_cm, 50 * height_cm dynamic background '#ffffff' "
           "font 'Helvetica,16'";
  }
  if (ending == ".png") {
    return "set terminal pngcairo size 60 * width_cm, 60 * height_cm font 'Helvetica,16'";
  }
  if (ending == ".pdf") return "set terminal pdfcairo size width_cm cm, height_cm cm";
  return "set terminal dumb noenhanced size 79, 24";
}

// The script that the engine writes for LaTeX, with this terminal and output instead.
std::string with_terminal(const std::string& script, const std::string& ending,
                          const std::string& output) {
  std::string text;
  for (const std::string_view line : sys::lines_of(script)) {
    if (line.starts_with("set terminal ")) {
      text += terminal_for(ending);
    } else if (line.starts_with("set output ")) {
      text += fmt::format("set output '{}'", output);
    } else {
      text += line;
    }
    text += '\n';
  }
  return text;
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

void PlotOption::add_to(CLI::App& command) {
  command_line::add_text(command, "--plot", file_, "FILE.svg|FILE.png|FILE.pdf|-",
                         "Draw the result in the report's style; - draws it in the terminal");
}

void PlotOption::require_drawable(const OutputOptions& output) const {
  if (file_.empty()) return;
  if (file_ == terminal_name) {
    if (output.format() == OutputFormat::table) return;
    throw sys::InputError("--plot -: needs --format table, which it stands below");
  }
  const std::string ending = fs::path(file_).extension().string();
  if (ending != ".svg" && ending != ".png" && ending != ".pdf") {
    throw sys::InputError(
        fmt::format("--plot {}: must end with .svg, .png or .pdf, or be -", file_));
  }
  require_folder_of("--plot", file_);
}

void PlotOption::draw(const std::string& script, literate::Figure figure) const {
  if (file_.empty()) return;
  const bool is_terminal = file_ == terminal_name;
  if (is_terminal) figure.numbers["in_terminal"] = 1;
  literate::require_drawable(figure);
  const std::string ending = is_terminal ? ".txt" : fs::path(file_).extension().string();

  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "figure";
  literate::write_figure(folder, script, figure);
  const fs::path main_script = folder / (script + ".gp");
  sys::write_file_atomically(main_script,
                             with_terminal(sys::read_file(main_script), ending, script + ending));
  sys::write_file_atomically(scratch.path() / "style.gp", plot_script("style"));
  sys::write_file_atomically(folder / "script.gp", plot_script(script));

  const sys::ProcessResult result = literate::run_gnuplot(folder, script);
  const fs::path drawn = folder / (script + ending);
  std::error_code ignored;
  const bool is_there = fs::is_regular_file(drawn, ignored) && fs::file_size(drawn, ignored) > 0;
  if (result.exit_status != 0 || !is_there) {
    throw sys::ToolError(fmt::format("gnuplot could not draw {}: {}", file_,
                                     std::string(sys::stripped(result.output))));
  }
  std::string picture = sys::read_file(drawn);
  if (is_terminal) {
    std::erase(picture, '\f');  // gnuplot begins a page with a form feed
    fmt::print("{}", picture);
  } else {
    sys::write_file_atomically(file_, picture);
  }
}

}  // namespace app
