// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "assignment/assignment.hpp"
#include "course_app/commands.hpp"
#include "system/files.hpp"

namespace course_app {

void add_assignment(CLI::App& command, CourseOptions& options) {
  add_text(command, "--assignment", options.assignment, "DIR", "Folder of assignment.toml");
}

void add_source(CLI::App& command, CourseOptions& options) {
  add_text(command, "--source", options.source, "DIR", "The checkout");
}

void add_student(CLI::App& command, CourseOptions& options) {
  add_text(command, "--student", options.student, "ID",
           "Use this student's numbers; by default the nominal ones");
  add_seed(command, options);
}

void add_seed(CLI::App& command, CourseOptions& options) {
  add_text(command, "--seed", options.seed, "TEXT",
           "The variants are drawn from it; by default everybody has the nominal numbers");
  add_text(command, "--seed-file", options.seed_file, "FILE",
           "File of the seed, which keeps it out of the list of processes");
}

void add_submissions(CLI::App& command, CourseOptions& options) {
  add_required_text(command, "submissions", options.submissions, "DIR",
                    "Folder with a folder or archive a student");
}

void add_roster(CLI::App& command, CourseOptions& options) {
  add_text(
      command, "--roster", options.roster, "FILE",
      "CSV of the class: the column `student` and, as they are known, `submitted`, `deadline`, "
      "`slip_days` and `group`");
}

void add_toolkit(CLI::App& command, CourseOptions& options) {
  add_required_text(command, "--toolkit", options.toolkit, "DIR", "Folder that `toolkit` wrote");
}

void add_output(CLI::App& command, CourseOptions& options) {
  add_required_text(command, "--output", options.output, "DIR",
                    "Folder to write; replaced as a whole");
}

long number_of(const NumberOption& option, long otherwise, long most) {
  const long number = option.integer().value_or(otherwise);
  if (number < 1 || number > most) {
    throw sys::InputError(fmt::format("{}: {} is not from 1 to {}", option.flag(), number, most));
  }
  return number;
}

std::optional<course::Roster> roster_of(const std::string& file) {
  if (file.empty()) return std::nullopt;
  return course::read_roster(file);
}

std::string seed_of(const CourseOptions& options) {
  if (options.seed_file.empty()) return options.seed;
  if (!options.seed.empty()) throw sys::InputError("--seed and --seed-file exclude each other");
  std::string seed = sys::read_file(options.seed_file);
  while (seed.ends_with('\n') || seed.ends_with('\r')) seed.pop_back();
  if (seed.empty()) throw sys::InputError(fmt::format("'{}' holds no seed", options.seed_file));
  return seed;
}

course::Assignment read_assignment(const CourseOptions& options) {
  course::Assignment assignment = course::read_assignment(options.assignment);
  course::all_checks(assignment, assignment::public_checks(), assignment::hidden_checks());
  return assignment;
}

course::Variant variant_of(const CourseOptions& options, const course::Assignment& assignment) {
  const std::string seed = seed_of(options);
  if (options.student.empty() != seed.empty()) {
    throw sys::InputError("--student and --seed need each other");
  }
  if (options.student.empty()) return course::nominal_variant(assignment);
  return course::variant_of(assignment, options.student, seed, assignment::is_valid);
}

}  // namespace course_app
