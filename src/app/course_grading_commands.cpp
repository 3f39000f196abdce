// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "app/course_commands.hpp"
#include "app/course_options.hpp"
#include "app/options.hpp"
#include "assignment/curves.hpp"
#include "assignment/hidden_checks.hpp"
#include "assignment/public_checks.hpp"
#include "assignment/valid_variant.hpp"
#include "course/check_list.hpp"
#include "course/collect.hpp"
#include "course/grade.hpp"
#include "course/roster.hpp"
#include "course/toolkit.hpp"
#include "course/variants.hpp"
#include "literate/files.hpp"

namespace app {
namespace {

std::optional<course::Roster> roster_of(const std::string& file) {
  if (file.empty()) return std::nullopt;
  return course::read_roster(file);
}

/// Says each problem on standard error: bad_input if there is any.
ExitCode answer_problems(const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) fmt::print(stderr, "halfspace: {}\n", problem);
  return problems.empty() ? ExitCode::success : ExitCode::bad_input;
}

struct ToolkitOptions : CourseOptions {
  std::string output;
};

void add_toolkit(CLI::App& course, ExitCode& exit_code) {
  add_command(course, "toolkit",
              "Compile once what students do not write, for `grade`; no solution is in it",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<ToolkitOptions>();
                add_assignment(command, *options);
                add_source(command, *options);
                add_required_text(command, "--output", options->output, "DIR", "Folder to write");
                return [options] {
                  course::make_toolkit(read_assignment(*options), options->source, options->output);
                  return ExitCode::success;
                };
              });
}

struct GradeOptions : CourseOptions {
  std::string submission, toolkit, output, submitted, deadline, roster;
  bool is_unsafe = false;
};

std::optional<course::Time> time_of(const GradeOptions& options, const std::string& student) {
  if (!options.submitted.empty()) return course::parse_time(options.submitted);
  const std::optional<course::Roster> roster = roster_of(options.roster);
  if (!roster) return std::nullopt;
  const auto found = roster->find(student);
  if (found == roster->end()) {
    throw InputError(fmt::format("there is no student {} in '{}'", student, options.roster));
  }
  return found->second;
}

ExitCode grade(const GradeOptions& options) {
  course::Assignment assignment = read_assignment(options);
  if (!options.deadline.empty()) assignment.deadline = course::parse_time(options.deadline);
  course::GradingTask task;
  task.submission = options.submission;
  task.student = options.student.empty() ? course::student_of(task.submission) : options.student;
  course::require_student_id(task.student);
  task.submitted = time_of(options, task.student);
  task.variant = options.seed.empty() ? course::nominal_variant(assignment)
                                      : course::variant_of(assignment, task.student, options.seed,
                                                           assignment::is_valid);
  task.toolkit = options.toolkit;
  task.checks =
      course::all_checks(assignment, assignment::public_checks(), assignment::hidden_checks());
  task.curves = assignment::curves;
  task.isolation = options.is_unsafe ? course::Isolation::none : course::Isolation::sandbox;
  const course::Graded graded = course::grade_submission(assignment, task, options.output);
  fmt::print("{}: {} of {} points, {}\n", task.student, course::mark_of(graded), assignment.points,
             course::lateness_text(graded));
  return ExitCode::success;
}

void add_grade(CLI::App& course, ExitCode& exit_code) {
  add_command(course, "grade", "Grade one submission: results, feedback and mark in one folder",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<GradeOptions>();
                add_required_text(command, "submission", options->submission, "FOLDER|ARCHIVE",
                                  "A folder, .zip, .tar, .tar.gz, .tgz or .tar.xz");
                add_assignment(command, *options);
                add_required_text(command, "--toolkit", options->toolkit, "DIR",
                                  "What `toolkit` wrote");
                add_required_text(command, "--output", options->output, "DIR", "Folder to write");
                add_text(command, "--student", options->student, "ID",
                         "Whose it is; else the submission's name without its ending");
                add_text(command, "--seed", options->seed, "TEXT",
                         "The seed of the variants; without it everybody has the nominal numbers");
                add_text(command, "--submitted", options->submitted, "TIME",
                         "When, as 2027-01-15T23:59:00+01:00");
                add_text(command, "--deadline", options->deadline, "TIME",
                         "For this student, instead of the assignment's");
                add_text(command, "--roster", options->roster, "FILE",
                         "CSV of the class, whose column `submitted` tells when");
                add_switch(command, "--unsafe", options->is_unsafe,
                           "Grade without bubblewrap: with limits, but with no walls");
                return [options] { return grade(*options); };
              });
}

struct ListOptions {
  std::string submissions, roster;
  bool has_null = false;
};

ExitCode list(const ListOptions& options) {
  const course::Listing listing =
      course::list_submissions(options.submissions, roster_of(options.roster));
  for (const course::Entry& entry : listing.entries) {
    const std::string path = entry.path.string();
    std::fwrite(path.data(), 1, path.size(), stdout);
    std::fputc(options.has_null ? '\0' : '\n', stdout);
  }
  return answer_problems(listing.problems);
}

void add_list(CLI::App& course, ExitCode& exit_code) {
  add_command(course, "list", "List what there is to grade, a line each", exit_code,
              [](CLI::App& command) {
                auto options = std::make_shared<ListOptions>();
                add_required_text(command, "submissions", options->submissions, "DIR",
                                  "Folder with a folder or archive a student");
                add_text(command, "--roster", options->roster, "FILE", "CSV of the class");
                add_switch(command, "--null", options->has_null,
                           "End each with a zero byte instead of a line end");
                return [options] { return list(*options); };
              });
}

struct CollectOptions : CourseOptions {
  std::string grades, output, roster, submissions;
};

ExitCode collect(const CollectOptions& options) {
  const course::Grades grades = course::collect_grades(
      read_assignment(options), options.grades, roster_of(options.roster),
      options.submissions.empty() ? std::nullopt
                                  : std::optional<std::filesystem::path>(options.submissions));
  literate::write_file_atomically(options.output, grades.csv);
  return answer_problems(grades.problems);
}

void add_collect(CLI::App& course, ExitCode& exit_code) {
  add_command(course, "collect", "Merge the folders that `grade` wrote into one table", exit_code,
              [](CLI::App& command) {
                auto options = std::make_shared<CollectOptions>();
                add_required_text(command, "grades", options->grades, "DIR",
                                  "Folder of those folders, each named for its student");
                add_assignment(command, *options);
                add_required_text(command, "--output", options->output, "FILE", "CSV to write");
                add_text(command, "--roster", options->roster, "FILE",
                         "CSV of the class: who is missing gets a line");
                add_text(command, "--submissions", options->submissions, "DIR",
                         "What was handed in: what has no mark gets a line");
                return [options] { return collect(*options); };
              });
}

}  // namespace

void add_course_grading_commands(CLI::App& course, ExitCode& exit_code) {
  add_toolkit(course, exit_code);
  add_grade(course, exit_code);
  add_list(course, exit_code);
  add_collect(course, exit_code);
}

}  // namespace app
