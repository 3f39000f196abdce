// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of the marks of a whole class.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "assignment/valid_variant.hpp"
#include "command_line/options.hpp"
#include "course/assignment/variants.hpp"
#include "course/marking/collect.hpp"
#include "course/marking/listing.hpp"
#include "course/marking/submission.hpp"
#include "course/reporting/feedback_release.hpp"
#include "course/reporting/gradebook.hpp"
#include "course/reporting/marked_report.hpp"
#include "course/reporting/mistakes.hpp"
#include "course/reporting/regrades.hpp"
#include "course/reporting/report_typesetting.hpp"
#include "course/reporting/results_page.hpp"
#include "course/reporting/rubric.hpp"
#include "course/reporting/statistics.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "course_app/commands.hpp"
#include "course_app/options.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"
#include "system/staging.hpp"

namespace course_app {
namespace fs = std::filesystem;
namespace {

struct MarkingOptions : CourseOptions {
  std::string submissions, output, roster, toolkit;
  bool is_unsafe = false;
  bool is_nominal = false;
};

/// Whether a form of an earlier run, which would be replaced, holds points.
bool is_filled_in(const fs::path& form) {
  if (!fs::exists(form)) return false;
  const std::string text = sys::read_file(form);
  for (const std::string_view line : sys::lines_of(text)) {
    const bool is_header = line.starts_with("student,");
    if (!is_header && !sys::stripped(line).empty() && !sys::stripped(line).ends_with(",,,")) {
      return true;
    }
  }
  return false;
}

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
  task.isolation = options.is_unsafe ? course::Isolation::none : course::Isolation::sandbox;
  task.report =
      course::take_report(assignment, entry.path, scratch.path() / "report", task.isolation);
  const course::Submission submission =
      course::take_submission(assignment, entry.path, scratch.path() / "exercises", task.isolation);
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

/// Makes the reports ready in folders whose names do not tell whose they are, and writes the form
/// that markers fill in.
ExitCode marking(const MarkingOptions& options) {
  const course::Assignment assignment = read_assignment(options);
  const std::string seed = seed_of(options);
  if (seed.empty())
    throw sys::InputError("the names of the reports are drawn: --seed-file is missing");
  const fs::path form = fs::path(options.output) / "marks.csv";
  if (is_filled_in(form)) {
    throw sys::InputError(fmt::format("'{}' holds points; move it away first", form.string()));
  }
  course::Listing listing =
      course::list_submissions(options.submissions, roster_of(options.roster));
  std::vector<std::string> units;
  for (const course::Entry& entry : listing.entries) units.push_back(entry.student);
  const auto names = course::anonymous_names(units, seed);
  const auto isolation = options.is_unsafe ? course::Isolation::none : course::Isolation::sandbox;
  const std::vector<std::string> former = fs::is_directory(options.output)
                                              ? sys::files_below(options.output)
                                              : std::vector<std::string>{};
  const course::ScratchFolder work;
  const course::ReportTypesetting typesetting(assignment, work.path(), isolation);
  sys::Staging staging(options.output);
  std::vector<std::string> with_report;
  for (const course::Entry& entry : listing.entries) {
    const course::Files files =
        report_of(options, assignment, typesetting, entry, listing.problems);
    const std::string& name = names.at(entry.student);
    if (!files.empty()) with_report.push_back(name);
    for (const auto& [file, text] : files) {
      sys::write_file_atomically(staging.path() / name / file, text);
    }
  }
  std::ranges::sort(with_report);  // in an order that does not tell either
  sys::write_file_atomically(staging.path() / "marks.csv",
                             course::rubric_form(assignment, with_report));
  staging.publish(former);
  return answer_faults(listing.problems);
}

struct ClassOptions : CourseOptions {
  std::string grades, output, roster, submissions, patterns, canvas, column, regrades, marks;
};

void add_class_options(CLI::App& command, ClassOptions& options) {
  add_required_text(command, "grades", options.grades, "DIR",
                    "Folder of the folders that `grade` wrote, each named for its student");
  add_assignment(command, options);
  add_text(command, "--roster", options.roster, "FILE",
           "CSV of the class; students without a mark get a line");
  add_text(command, "--submissions", options.submissions, "DIR",
           "Folder of the submissions; those without a mark get a line");
  add_text(command, "--regrades", options.regrades, "DIR",
           "Folder of the requests to mark a check again, a .toml file each");
  add_text(command, "--marks", options.marks, "FILE", "What persons gave for the report, CSV");
  add_seed(command, options);
}

std::vector<course::Regrade> regrades_of(const ClassOptions& options,
                                         const course::Assignment& assignment) {
  if (options.regrades.empty()) return {};
  return course::read_regrades(assignment, options.regrades);
}

/// The markers' lines. With a seed they may name the students by names that do not tell them.
std::vector<course::RubricLine> rubric_lines_of(const ClassOptions& options,
                                                const course::Assignment& assignment,
                                                const course::ClassMarks& marks) {
  if (assignment.criteria.empty()) {
    throw sys::InputError(fmt::format("--marks: there is no [[criterion]] in {}/assignment.toml",
                                      options.assignment));
  }
  std::set<std::string> units;
  for (const course::StudentMark& student : marks.students) units.insert(student.unit());
  const std::string seed = seed_of(options);
  return course::read_rubric_lines(
      assignment, options.marks,
      seed.empty() ? std::map<std::string, std::string>{}
                   : course::anonymous_names({units.begin(), units.end()}, seed));
}

course::ClassMarks marks_of(const ClassOptions& options, const course::Assignment& assignment) {
  course::ClassMarks marks = course::class_marks(
      assignment, options.grades, roster_of(options.roster),
      options.submissions.empty() ? std::nullopt : std::optional<fs::path>(options.submissions));
  course::apply_regrades(regrades_of(options, assignment), marks);
  if (!options.marks.empty()) {
    course::apply_rubric(assignment, rubric_lines_of(options, assignment, marks), marks);
  }
  return marks;
}

/// What is said if there is a rubric and --marks is not given; empty otherwise.
std::string missing_marks(const ClassOptions& options, const course::Assignment& assignment) {
  return options.marks.empty() ? course::without_markers_file(assignment) : "";
}

void warn_of_missing_marks(const ClassOptions& options, const course::Assignment& assignment) {
  const std::string missing = missing_marks(options, assignment);
  if (!missing.empty()) fmt::print(stderr, "{}: warning: {}\n", program_name(), missing);
}

ExitCode collect(const ClassOptions& options) {
  const course::Assignment assignment = read_assignment(options);
  const course::ClassMarks marks = marks_of(options, assignment);
  sys::write_file_atomically(options.output, course::marks_csv(assignment, marks));
  warn_of_missing_marks(options, assignment);
  return answer_faults(marks.problems);
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
  const auto patterns = options.patterns.empty()
                            ? std::vector<course::MistakePattern>{}
                            : course::read_patterns(assignment, options.patterns);
  const auto met = course::met_mistakes(assignment, patterns, marks);
  const course::ClassStatistics statistics = course::statistics_of(assignment, marks);
  const auto put = [&](const char* name, const std::string& text) {
    sys::write_file_atomically(fs::path(options.output) / name, text);
  };
  put("results.html", course::results_html(assignment, marks, statistics, met));
  put("checks.csv", course::items_csv(statistics));
  put("mistakes.csv", course::mistakes_csv(met));
  put("moodle.csv", course::moodle_csv(assignment, marks));
  std::error_code none;  // an old one must not look like a new one
  fs::remove(fs::path(options.output) / "canvas.csv", none);
  if (canvas) put("canvas.csv", canvas->csv);
  warn_of_missing_marks(options, assignment);
  return answer_faults(marks.problems);
}

ExitCode release_feedback(const ClassOptions& options) {
  const course::Assignment assignment = read_assignment(options);
  const course::ClassMarks marks = marks_of(options, assignment);
  std::vector<std::string> reasons = course::reasons_to_wait(marks);
  const std::string missing = missing_marks(options, assignment);
  if (!missing.empty()) reasons.push_back(missing);
  if (!reasons.empty()) return answer_faults(reasons);
  course::release_feedback(assignment, options.grades, marks, regrades_of(options, assignment),
                           options.output);
  return ExitCode::success;
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
                add_required_text(command, "submissions", options->submissions, "DIR",
                                  "Folder with a folder or archive a student");
                add_assignment(command, *options);
                add_seed(command, *options);
                add_text(command, "--roster", options->roster, "FILE", "CSV of the class");
                add_required_text(command, "--output", options->output, "DIR",
                                  "Folder to write; replaced as a whole");
                add_required_text(command, "--toolkit", options->toolkit, "DIR",
                                  "Folder that `toolkit` wrote");
                add_switch(command, "--nominal", options->is_nominal,
                           "Everybody has the nominal numbers; the seed draws names only");
                add_switch(command, "--unsafe", options->is_unsafe,
                           "Work without bubblewrap: with limits, but with no walls");
                return [options] { return marking(*options); };
              });
}

void add_release_feedback_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "release-feedback",
              "Write each student's page as it may go out, if every submission is graded",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<ClassOptions>();
                add_class_options(command, *options);
                add_required_text(command, "--output", options->output, "DIR",
                                  "Folder to write; replaced as a whole");
                return [options] { return release_feedback(*options); };
              });
}

void add_results_command(CLI::App& program, ExitCode& exit_code) {
  add_command(
      program, "results", "Write the statistics of a class, and its marks for Moodle and Canvas",
      exit_code, [](CLI::App& command) {
        auto options = std::make_shared<ClassOptions>();
        add_class_options(command, *options);
        add_required_text(command, "--output", options->output, "DIR", "Folder to write to");
        add_text(command, "--patterns", options->patterns, "FILE",
                 "What wrong solutions score, which `prove` wrote");
        add_text(command, "--canvas", options->canvas, "FILE",
                 "The gradebook that Canvas exported, to be filled in");
        add_text(command, "--column", options->column, "NAME",
                 "The column of --canvas for the marks; by default the one that begins "
                 "with the assignment's title");
        return [options] { return results(*options); };
      });
}

}  // namespace course_app
