// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/grade.hpp"

#include "course/marking/feedback.hpp"
#include "course/marking/own_tests.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/staging.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> pictures_of(const Assignment& assignment, const GradingTask& task,
                                     ProgramRun& run) {
  if (!task.curves) return {};
  const Program program = [&](const std::string& name, const Numbers& inputs) {
    return run.answer(name, inputs);
  };
  std::vector<std::string> pictures;
  for (const Curve& curve : task.curves(program, task.variant)) {
    std::string svg = svg_of(curve, style_of(assignment));
    if (!svg.empty()) pictures.push_back(std::move(svg));
  }
  return pictures;
}

void write(const Assignment& assignment, const Graded& graded,
           const std::vector<std::string>& pictures, const fs::path& output) {
  sys::Staging staging(output);
  const auto put = [&](const char* name, const std::string& text) {
    sys::write_file_atomically(staging.path() / name, text);
  };
  put("results.json", gradescope_json(assignment, graded));
  put("feedback.html", feedback_html(assignment, graded, pictures));
  put("log.txt", log_text(assignment, graded));
  put("mark.json", mark_json(assignment, graded));
  staging.publish({});
}

}  // namespace

Graded grade_submission(const Assignment& assignment, const GradingTask& task,
                        const fs::path& output) {
  const ScratchFolder scratch;
  const fs::path taking = scratch.path() / "taking";
  fs::create_directory(taking);
  Graded graded;
  graded.student = task.student;
  graded.late = lateness(assignment, task.submitted, task.slip_days);
  graded.submission = take_submission(assignment, task.submission, taking, task.isolation);

  const Built built = build(assignment, task.toolkit, graded.submission.files,
                            scratch.path() / "build", task.isolation);
  graded.compile_errors = built.compile_errors;
  graded.link_error = built.link_error;
  ProgramRun run(assignment, built, task.isolation);
  std::vector<std::string> pictures;
  const auto draw = [&] {
    if (built.link_error.empty()) pictures = pictures_of(assignment, task, run);
  };
  const Checks checks = with_own_tests(task.checks,
                                       {.assignment = assignment,
                                        .toolkit = task.toolkit,
                                        .files = graded.submission.files,
                                        .scratch = scratch.path() / "own tests",
                                        .seconds_so_far = [&run] { return run.seconds(); },
                                        .isolation = task.isolation},
                                       graded.missed);
  graded.results = try_checks(assignment, checks, built, task.variant, run, draw);
  write(assignment, graded, pictures, output);
  return graded;
}

}  // namespace course
