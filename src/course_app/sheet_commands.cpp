// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "assignment/sheet.hpp"
#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "course_app/commands.hpp"
#include "literate/document/document.hpp"
#include "literate/figures/draw.hpp"
#include "literate/main/stages.hpp"

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

// The sheet with nominal numbers, as a paper of the engine: its stages, beside the command `sheet`,
// which writes the sheet of one student.
void compute(literate::Document& document, const literate::Inputs& inputs) {
  CourseOptions options;
  options.assignment = inputs.case_file.parent_path().string();
  options.source = inputs.source.string();
  const course::Assignment assignment = read_assignment(options);
  assignment::register_sheet(document, assignment, variant_of(options, assignment));
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

void add_sheet_stages(CLI::App& program, ExitCode& exit_code) {
  static const literate::Compute computation = compute;
  literate::add_stages(program, exit_code, literate::this_paper(), computation);
}

}  // namespace course_app
