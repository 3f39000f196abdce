// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "assignment/sheet.hpp"
#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "course_app/commands.hpp"
#include "course_app/options.hpp"
#include "literate/document/document.hpp"
#include "literate/figures/draw.hpp"

namespace course_app {
namespace {

struct SheetOptions : CourseOptions {
  std::string output;
};

ExitCode run(const SheetOptions& options) {
  const Stage writing("sheet");
  const course::Assignment assignment = read_assignment(options);
  literate::Document document;
  assignment::register_sheet(document, assignment, variant_of(options, assignment));
  document.write(options.output);
  const auto scripts = std::filesystem::path(options.assignment) / "figures";
  literate::draw_figures(options.output, scripts, document.figure_places());
  writing.done(
      fmt::format("{} values, {} tables", document.values().size(), document.tables().size()));
  return ExitCode::success;
}

}  // namespace

void add_sheet_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "sheet", "Write what the assignment sheet is typeset from", exit_code,
              [](CLI::App& command) {
                auto options = std::make_shared<SheetOptions>();
                add_required_text(command, "--output", options->output, "DIR",
                                  "Folder to write to");
                add_student(command, *options);
                add_assignment(command, *options);
                return [options] { return run(*options); };
              });
}

}  // namespace course_app
