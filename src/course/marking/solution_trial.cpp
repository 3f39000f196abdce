// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/solution_trial.hpp"

#include <fmt/core.h>

#include <cmath>

#include "course/sandbox/scratch_folder.hpp"

namespace course {
namespace {

// Of a compiler's or a check's message, so that a fault stays one line.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

bool are_same_points(double a, double b) {
  constexpr double half_a_hundredth = 0.005;
  return std::abs(a - b) < half_a_hundredth;
}

SolutionTrial try_solution(const Assignment& assignment, const Built& built, const Checks& checks,
                           const Variant& variant, Isolation isolation) {
  SolutionTrial trial;
  for (const auto& [exercise, message] : built.compile_errors) {
    trial.losses.push_back(fmt::format("{} does not compile: {}", exercise, first_line(message)));
  }
  if (!built.link_error.empty()) {
    trial.losses.push_back("it does not link: " + first_line(built.link_error));
  }
  ProgramRun run(assignment, built, isolation);
  const std::vector<CheckResult> results = try_checks(assignment, checks, built, variant, run);
  trial.points = total(results);
  auto result = results.begin();
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& check : exercise.checks) {
      if (!are_same_points(result->points, check.points)) {
        trial.losses.push_back(fmt::format("{}: {} of {} points: {}", check.id, result->points,
                                           check.points, first_line(result->message)));
      }
      ++result;
    }
  }
  return trial;
}

SolutionTrial try_solution(const Assignment& assignment, const std::filesystem::path& toolkit,
                           const Files& solution, const Checks& checks, const Variant& variant,
                           Isolation isolation) {
  const ScratchFolder scratch;
  const Built built = build(assignment, toolkit, solution, scratch.path(), isolation);
  return try_solution(assignment, built, checks, variant, isolation);
}

}  // namespace course
