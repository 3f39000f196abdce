// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "course/assignment/check.hpp"
#include "course/assignment/variant.hpp"

namespace course {

/// Who decides a check, and what students are told of it: code of which they have a copy; code of
/// which they are told nothing but points; or their own tests, by the wrong programs that they
/// catch.
enum class Visibility { visible, hidden, tests };

/// One line of the marking scheme.
struct CheckEntry {
  std::string id;  ///< names the code that decides
  double points = 0;
  Visibility visibility = Visibility::hidden;
  std::string says;   ///< what is tried, in words for students
  std::string place;  ///< where the id stands: «file:line:column»
};

/// What students write one file for.
struct Exercise {
  std::string id;
  std::string title;
  std::string file;                    ///< in the student's project, such as "src/closed_form.cpp"
  std::vector<std::string> builds_on;  ///< ids of earlier exercises whose functions it calls
  std::vector<CheckEntry> checks;
  /// The student's own tests, such as "src/tests/influence.cpp"; empty if none are asked for. If
  /// they are, one of the checks is theirs.
  std::string tests = {};

  double points() const;
  /// The name of its file without folder and ending, for which the files of its checks are named.
  std::string name() const;
};

/// What a person marks: one line of the rubric of the report.
struct Criterion {
  std::string id;
  std::string title;
  std::string says;  ///< what is looked for, in words for students and markers
  double points = 0;
};

/// A number that variants differ in: from + k·step with whole k ≥ 0, up to `to`.
struct Quantity {
  std::string name;
  std::string unit;  ///< as printed; the number is in this unit
  double from = 0;
  double to = 0;
  double step = 0;
  double nominal = 0;  ///< the value in the handout that is for nobody in particular
};

struct LatePolicy {
  double percent_per_day = 0;  ///< percentage of the points reached, for each day begun
  int days = 0;                ///< later than this counts nothing
  int grace_minutes = 0;       ///< by which a deadline may be missed, and each further day's end
  int slip_days = 0;           ///< days late that cost nothing, unless the student has fewer left
  /// Later than this counts nothing, whatever `days` says.
  std::optional<std::chrono::sys_seconds> until = {};
};

/// What a submission may use at most.
struct Limits {
  // Of processor time; in those for all together counts, too, what passes while none is wanted.
  int compile_seconds = 20;      ///< for one file
  int run_seconds = 5;           ///< for one answer
  int submission_seconds = 120;  ///< for compiling, linking and all answers together
  int report_seconds = 30;       ///< for a report's numbers and drawings, and as much for LaTeX
  int memory_mb = 1024;
  int processes = 32;
  int output_kb = 256;
  int file_kb = 256;       ///< size of one submitted file
  int submission_mb = 20;  ///< size of the whole submission
};

/// The assignment as `assignment.toml` describes it.
struct Assignment {
  std::filesystem::path folder;  ///< holds assignment.toml and template/
  std::string title;
  std::chrono::sys_seconds deadline;
  double points = 0;
  double floor = 0;  ///< points that the untouched handout reaches
  /// Whether Gradescope shows points and feedback only when the instructor publishes the grades.
  bool holds_feedback_back = false;
  /// Files below src/ that the handout gets a copy of. In assignment.toml a file whose path holds
  /// `@name@` stands for one of each exercise.
  std::vector<std::string> provided;
  LatePolicy late;
  Limits limits;
  /// Of a task, how many numbers of its answer stand before those that are of one kind: of a
  /// contact the approach and the half-width, before the pressures.
  std::map<std::string, std::size_t> single_numbers;
  std::vector<Exercise> exercises;
  std::vector<Criterion> criteria;  ///< besides `points`, which are those of the checks
  std::vector<Quantity> quantities;

  double report_points() const;  ///< of all criteria
};

/// Reads folder/assignment.toml. Throws config::Error «file:line:column: …» for an entry that
/// is malformed or contradicts another.
Assignment read_assignment(const std::filesystem::path& folder);

/// The texts of a project's files, by path, such as "src/closed_form.cpp".
using Files = std::map<std::string, std::string>;

/// The files of an exercise and of all that it builds on.
std::set<std::string> files_behind(const Assignment& assignment, const Exercise& exercise);

/// The code of every check that the assignment lists, but of those that students' own tests decide
/// (course/marking/own_tests.hpp). Throws config::Error for a listed check, with its place, that
/// has no code of its visibility, and for code of a check that is not listed.
Checks all_checks(const Assignment& assignment, const Checks& visible, const Checks& hidden);

/// The value from + k·step of a quantity, rounded to 12 digits, so that it is 0.28 and not
/// 0.28000000000000003.
double on_grid(const Quantity& quantity, std::uint64_t k);

/// The number of values that a quantity may have.
std::uint64_t n_values(const Quantity& quantity);

/// The variant with each quantity at its nominal value, for the handout that is for nobody in
/// particular.
Variant nominal_variant(const Assignment& assignment);

/// Draws a student's own variant. The value of each quantity is the one on its grid that
/// SHA-256 of seed, student, name of the quantity and number of the attempt selects; all are drawn
/// again until `is_valid` accepts them. The variant is the same on every platform, and nobody can
/// tell it from the student's id without the seed.
///
/// Throws sys::SourceError for an id that is not allowed, for an empty seed, and after 1000
/// attempts.
Variant variant_of(const Assignment& assignment, const std::string& student,
                   const std::string& seed, const std::function<bool(const Variant&)>& is_valid);

}  // namespace course
