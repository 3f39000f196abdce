// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of the marks of a whole class.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assignment/assignment.hpp"
#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"
#include "course/marking/submission.hpp"
#include "course/reporting/gradebook.hpp"
#include "course/reporting/marked_report.hpp"
#include "course/reporting/report_typesetting.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "course_app/commands.hpp"
#include "system/files.hpp"
#include "system/staging.hpp"

namespace course_app {
namespace fs = std::filesystem;
namespace {

struct MarkingOptions : CourseOptions {
  std::string names;
  bool is_nominal = false;
};

/// Makes the report of one submission ready for markers. Nothing if there is none; why a submission
/// cannot be read is a problem.
course::Files report_of(const MarkingOptions& options, const course::Assignment& assignment,
                        const course::ReportTypesetting& typesetting, const course::Entry& entry,
                        std::vector<std::string>& problems) {
  const course::ScratchFolder scratch;
  for (const char* part : {"report", "exercises", "making"}) {
    fs::create_directory(scratch.path() / part);
  }
  course::ReportTask task;
  task.report =
      course::take_report(assignment, entry.path, scratch.path() / "report", task.isolation);
  course::Submission submission;
  try {
    submission = course::take_submission(assignment, entry.path, scratch.path() / "exercises",
                                         task.isolation);
  } catch (const sys::OutputError& error) {
    problems.emplace_back(error.what());
    return {};
  }
  if (!task.report.is_there()) {
    for (const std::string& problem : submission.problems) {
      problems.push_back(fmt::format("{}: there is no report: {}", entry.student, problem));
    }
    return {};
  }
  task.exercises = submission.files;
  task.variant = options.is_nominal ? course::nominal_variant(assignment)
                                    : course::variant_of(assignment, entry.student,
                                                         seed_of(options), assignment::is_valid);
  task.toolkit = options.toolkit;
  return course::marked_report(assignment, typesetting, task, scratch.path() / "making");
}

/// Makes the reports ready in folders whose names do not tell whose they are. A table for the
/// instructor alone says whose each is.
ExitCode marking(const MarkingOptions& options) {
  const course::Assignment assignment = read_assignment(options);
  const std::string seed = seed_of(options);
  if (seed.empty())
    throw sys::InputError("the names of the reports are drawn: --seed-file is missing");
  course::Listing listing =
      course::list_submissions(options.submissions, roster_of(options.roster));
  std::vector<std::string> units;
  for (const course::Entry& entry : listing.entries) units.push_back(entry.student);
  const auto names = course::anonymous_names(units, seed);
  constexpr auto isolation = course::Isolation::sandbox;
  const course::ScratchFolder work;
  const course::ReportTypesetting typesetting(assignment, work.path(), isolation);
  sys::Staging staging(options.output);
  std::string table = "student,report\r\n";
  for (const course::Entry& entry : listing.entries) {
    const course::Files files =
        report_of(options, assignment, typesetting, entry, listing.problems);
    const std::string& name = names.at(entry.student);
    if (!files.empty()) table += fmt::format("{},{}\r\n", entry.student, name);
    for (const auto& [file, text] : files) {
      sys::write_file_atomically(staging.path() / name / file, text);
    }
  }
  staging.replace();
  sys::write_file_atomically(options.names, table);
  return answer_faults(listing.problems);
}

struct ClassOptions : CourseOptions {
  std::string grades, canvas, column;
};

void add_class_options(CLI::App& command, ClassOptions& options) {
  add_required_text(command, "grades", options.grades, "DIR",
                    "Folder of the folders that `grade` wrote, each named for its student");
  add_assignment(command, options);
  add_roster(command, options);
  add_text(command, "--submissions", options.submissions, "DIR",
           "Folder of the submissions; those without a mark get a line");
}

course::ClassMarks marks_of(const ClassOptions& options, const course::Assignment& assignment) {
  return course::class_marks(
      assignment, options.grades, roster_of(options.roster),
      options.submissions.empty() ? std::nullopt : std::optional<fs::path>(options.submissions));
}

ExitCode collect(const ClassOptions& options) {
  const course::Assignment assignment = read_assignment(options);
  const course::ClassMarks marks = marks_of(options, assignment);
  sys::write_file_atomically(options.output, course::marks_csv(assignment, marks));
  return answer_faults(marks.problems);
}

/// Writes the page of each student who has a mark to `folder`, which it replaces as a whole.
void write_feedback(const ClassOptions& options, const course::ClassMarks& marks,
                    const fs::path& folder) {
  sys::Staging staging(folder);
  for (const course::StudentMark& student : marks.students) {
    if (!student.mark) continue;
    sys::write_file_atomically(
        staging.path() / (student.student + ".html"),
        sys::read_file(fs::path(options.grades) / student.unit() / "feedback.html"));
  }
  staging.replace();
}

ExitCode results(const ClassOptions& options) {
  const course::Assignment assignment = read_assignment(options);
  course::ClassMarks marks = marks_of(options, assignment);
  if (options.canvas.empty() && !options.column.empty()) {
    throw sys::InputError("--column needs --canvas");
  }
  std::optional<course::FilledGradebook> canvas;
  if (!options.canvas.empty()) {
    canvas = course::canvas_csv(assignment, marks, sys::read_file(options.canvas), options.canvas,
                                options.column);
    marks.problems.insert(marks.problems.end(), canvas->problems.begin(), canvas->problems.end());
  }
  for (const course::StudentMark& student : marks.students) {
    if (student.state != "not graded") continue;
    marks.problems.push_back(
        fmt::format("student {} handed something in that is not graded", student.student));
  }
  const fs::path output = options.output;
  write_feedback(options, marks, output / "feedback");
  sys::write_file_atomically(output / "moodle.csv", course::moodle_csv(assignment, marks));
  std::error_code none;  // an old one must not look like a new one
  fs::remove(output / "canvas.csv", none);
  if (canvas) sys::write_file_atomically(output / "canvas.csv", canvas->csv);
  return answer_faults(marks.problems);
}

}  // namespace

void add_collect_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "collect", "Merge the folders that `grade` wrote into one table", exit_code,
              [](CLI::App& command) {
                auto options = std::make_shared<ClassOptions>();
                add_class_options(command, *options);
                add_required_text(command, "--output", options->output, "FILE", "CSV to write");
                return [options] { return collect(*options); };
              });
}

void add_marking_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "marking",
              "Typeset the reports under names that do not tell whose they are, for markers",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<MarkingOptions>();
                add_submissions(command, *options);
                add_assignment(command, *options);
                add_seed(command, *options);
                add_roster(command, *options);
                add_output(command, *options);
                add_required_text(command, "--names", options->names, "FILE",
                                  "CSV to write for you alone: whose each report is");
                add_toolkit(command, *options);
                add_switch(command, "--nominal", options->is_nominal,
                           "Everybody has the nominal numbers; the seed draws names only");
                return [options] { return marking(*options); };
              });
}

void add_results_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "results",
              "Write the marks of a class for Moodle and Canvas, and each student's feedback",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<ClassOptions>();
                add_class_options(command, *options);
                add_required_text(command, "--output", options->output, "DIR",
                                  "Folder to write to");
                add_text(command, "--canvas", options->canvas, "FILE",
                         "The gradebook that Canvas exported, to be filled in");
                add_text(command, "--column", options->column, "NAME",
                         "The column of --canvas for the marks; by default the one that begins "
                         "with the assignment's title");
                return [options] { return results(*options); };
              });
}

}  // namespace course_app
