// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/score.hpp"

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

Score score_of(const Assignment& assignment, const Built& built, const Checks& checks,
               const Variant& variant, Isolation isolation) {
  Score score;
  for (const auto& [exercise, message] : built.compile_errors) {
    score.losses.push_back(fmt::format("{} does not compile: {}", exercise, first_line(message)));
  }
  if (!built.link_error.empty()) {
    score.losses.push_back("it does not link: " + first_line(built.link_error));
  }
  const auto results = evaluate(assignment, checks, built, variant, isolation);
  score.points = total(results);
  auto result = results.begin();
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& check : exercise.checks) {
      if (!are_same_points(result->points, check.points)) {
        score.losses.push_back(fmt::format("{}: {} of {} points: {}", check.id, result->points,
                                           check.points, first_line(result->message)));
      }
      ++result;
    }
  }
  return score;
}

Score score_of(const Assignment& assignment, const std::filesystem::path& toolkit,
               const Files& submission, const Checks& checks, const Variant& variant,
               Isolation isolation) {
  const ScratchFolder scratch;
  const Built built = build(assignment, toolkit, submission, scratch.path(), isolation);
  return score_of(assignment, built, checks, variant, isolation);
}

}  // namespace course
