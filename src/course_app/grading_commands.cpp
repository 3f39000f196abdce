// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "assignment/assignment.hpp"
#include "course/assignment/assignment.hpp"
#include "course/assignment/student.hpp"
#include "course/marking/grade.hpp"
#include "course/marking/roster.hpp"
#include "course/marking/submission.hpp"
#include "course/release/make_toolkit.hpp"
#include "course_app/commands.hpp"
#include "system/files.hpp"

namespace course_app {
namespace {

struct GradeOptions : CourseOptions {
  std::string submission, submitted, deadline, late_until;
  bool is_in_container = false;
};

/// What the roster says of a student; times that options give replace those in it.
course::RosterEntry times_of(const GradeOptions& options, const std::string& student) {
  course::RosterEntry times;
  if (const std::optional<course::Roster> roster = roster_of(options.roster)) {
    if (course::members_of(*roster, student).empty()) {
      throw sys::InputError(
          fmt::format("there is no student or group {} in '{}'", student, options.roster));
    }
    times = course::entry_of(*roster, student);
  }
  if (!options.submitted.empty()) times.submitted = course::parse_time(options.submitted);
  if (!options.deadline.empty()) times.deadline = course::parse_time(options.deadline);
  return times;
}

ExitCode grade(const GradeOptions& options) {
  course::Assignment assignment = read_assignment(options);
  course::GradingTask task;
  task.submission = options.submission;
  task.student = options.student.empty() ? course::student_of(task.submission) : options.student;
  course::require_student_id(task.student);
  const course::RosterEntry times = times_of(options, task.student);
  task.submitted = times.submitted;
  task.slip_days = times.slip_days;
  assignment.deadline = times.deadline.value_or(assignment.deadline);
  if (!options.late_until.empty()) assignment.late.until = course::parse_time(options.late_until);
  const std::string seed = seed_of(options);
  task.variant = seed.empty()
                     ? course::nominal_variant(assignment)
                     : course::variant_of(assignment, task.student, seed, assignment::is_valid);
  task.toolkit = options.toolkit;
  task.checks =
      course::all_checks(assignment, assignment::public_checks(), assignment::hidden_checks());
  task.curves = assignment::curves;
  task.isolation = options.is_in_container ? course::Isolation::none : course::Isolation::sandbox;
  const course::Graded graded = course::grade_submission(assignment, task, options.output);
  fmt::print("{}: {} of {} points, {}\n", task.student, course::mark_of(graded), assignment.points,
             course::lateness_text(graded));
  return ExitCode::success;
}

struct ListOptions : CourseOptions {
  bool has_null = false;
};

ExitCode list(const ListOptions& options) {
  const std::optional<course::Roster> roster = roster_of(options.roster);
  const course::Listing listing = course::list_submissions(options.submissions, roster);
  if (roster) fmt::print(stderr, "list: {}\n", course::lateness_source(*roster));
  for (const course::Entry& entry : listing.entries) {
    const std::string path = entry.path.string();
    std::fwrite(path.data(), 1, path.size(), stdout);
    std::fputc(options.has_null ? '\0' : '\n', stdout);
  }
  return answer_faults(listing.problems);
}

}  // namespace

void add_toolkit_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "toolkit", "Compile for `grade`, once, what students do not write",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<CourseOptions>();
                add_assignment(command, *options);
                add_source(command, *options);
                add_required_text(command, "--output", options->output, "DIR", "Folder to write");
                return [options] {
                  course::make_toolkit(read_assignment(*options), options->source, options->output);
                  return ExitCode::success;
                };
              });
}

void add_grade_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "grade", "Grade one submission: results, feedback and mark in one folder",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<GradeOptions>();
                add_required_text(command, "submission", options->submission, "FOLDER|ARCHIVE",
                                  "A folder, .zip, .tar, .tar.gz, .tgz or .tar.xz");
                add_assignment(command, *options);
                add_toolkit(command, *options);
                add_required_text(command, "--output", options->output, "DIR", "Folder to write");
                add_text(command, "--student", options->student, "ID",
                         "The student; by default the submission's name without its ending");
                add_seed(command, *options);
                add_text(command, "--submitted", options->submitted, "TIME",
                         "When it was handed in, as 2027-01-15T23:59:00+01:00");
                add_text(command, "--deadline", options->deadline, "TIME",
                         "For this student, instead of the assignment's");
                add_text(command, "--late-until", options->late_until, "TIME",
                         "When nothing counts any more, instead of after the assignment's days");
                add_roster(command, *options);
                add_switch(command, "--container", options->is_in_container,
                           "Grade with limits and without walls, in a container that holds nothing "
                           "but this submission and its grader");
                return [options] { return grade(*options); };
              });
}

void add_list_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "list", "List the submissions in a folder, a line each", exit_code,
              [](CLI::App& command) {
                auto options = std::make_shared<ListOptions>();
                add_submissions(command, *options);
                add_roster(command, *options);
                add_switch(command, "--null", options->has_null,
                           "End each with a zero byte instead of a line end");
                return [options] { return list(*options); };
              });
}

void add_student_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "student", "Print the student from whom a submission is, by its name",
              exit_code, [](CLI::App& command) {
                auto submission = std::make_shared<std::string>();
                add_required_text(command, "submission", *submission, "FOLDER|ARCHIVE",
                                  "A folder or archive that `list` lists");
                return [submission] {
                  const std::string student = course::student_of(*submission);
                  course::require_student_id(student);
                  fmt::print("{}\n", student);
                  return ExitCode::success;
                };
              });
}

void add_class_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "class", "List who hands in, a student or group a line", exit_code,
              [](CLI::App& command) {
                auto roster = std::make_shared<std::string>();
                add_required_text(command, "roster", *roster, "FILE", "CSV of the class");
                return [roster] {
                  for (const std::string& unit : course::units_of(course::read_roster(*roster))) {
                    fmt::print("{}\n", unit);
                  }
                  return ExitCode::success;
                };
              });
}

}  // namespace course_app
