// SPDX-License-Identifier: GPL-3.0-or-later
// The assignment's sheet with nominal numbers, as a paper of the engine: its stages, beside the
// command `sheet`, which writes the sheet of one student.
#include "assignment/sheet.hpp"
#include "course_app/commands.hpp"
#include "course_app/options.hpp"
#include "literate/main/stages.hpp"

namespace course_app {
namespace {

void compute(literate::Document& document, const literate::Inputs& inputs) {
  CourseOptions options;
  options.assignment = inputs.case_file.parent_path().string();
  options.source = inputs.source.string();
  const course::Assignment assignment = read_assignment(options);
  assignment::register_sheet(document, assignment, variant_of(options, assignment));
}

}  // namespace

void add_sheet_stages(CLI::App& program, ExitCode& exit_code) {
  static const literate::Compute computation = compute;
  literate::add_stages(program, exit_code, literate::this_paper(), computation);
}

}  // namespace course_app
