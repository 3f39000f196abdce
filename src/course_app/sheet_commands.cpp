// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <string>

#include "assignment/sheet.hpp"
#include "command_line/stage.hpp"
#include "course_app/commands.hpp"
#include "literate/document/document.hpp"
#include "literate/main/stages.hpp"

namespace course_app {
namespace {

void register_sheet(literate::Document& document, const CourseOptions& options) {
  const course::Assignment assignment = read_assignment(options);
  assignment::register_sheet(document, assignment, variant_of(options, assignment));
}

ExitCode run(const CourseOptions& options) {
  const Stage writing("sheet");
  literate::Document document;
  register_sheet(document, options);
  document.write(options.output);
  writing.done(
      fmt::format("{} values, {} tables", document.values().size(), document.tables().size()));
  return ExitCode::success;
}

// The sheet with nominal numbers, as a paper of the engine: its stages, beside the command `sheet`,
// which writes the sheet of one student.
void compute(literate::Document& document, const literate::Inputs& inputs) {
  CourseOptions options;
  options.assignment = inputs.case_file.parent_path().string();
  register_sheet(document, options);
}

}  // namespace

void add_sheet_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "sheet", "Write what the assignment sheet is typeset from", exit_code,
              [](CLI::App& command) {
                auto options = std::make_shared<CourseOptions>();
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
