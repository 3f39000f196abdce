// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/try_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "course/sandbox/scratch_folder.hpp"
#include "system/require.hpp"

namespace course {
namespace {

double points_of(double share, double points) {
  return share > 0 ? in_hundredths(std::min(share, 1.0) * points) : 0;
}

/// The outcome if the program answered numbers for which the check throws; the exception's text
/// is not for the student. Any other exception is an error of the grader and costs the student
/// nothing.
const Outcome without_judgement{
    0, "the program's answer cannot be judged: too few numbers, or meaningless ones"};

Outcome outcome_of(const Check& check, const Program& program, const Variant& variant) {
  try {
    return check(program, variant);
  } catch (const ProgramFailure& failure) {
    return {0, failure.what()};
  } catch (const sys::InvalidQuantity&) {
    return without_judgement;
  } catch (const std::logic_error&) {
    return without_judgement;
  }
}

/// The share of the points of an exercise's hidden checks that was reached; 1 if it has none.
double hidden_share(const Exercise& exercise, const std::map<std::string, CheckResult>& results) {
  double reached = 0;
  double possible = 0;
  for (const CheckEntry& entry : exercise.checks) {
    if (entry.visibility != Visibility::hidden) continue;
    reached += results.at(entry.id).points;
    possible += entry.points;
  }
  return possible > 0 ? reached / possible : 1;
}

/// Takes from a public check what goes beyond the share that the hidden ones reached, and says so.
void limit(CheckResult& result, const CheckEntry& entry, double share) {
  const double most = points_of(share, entry.points);
  if (result.points <= most) return;
  if (!result.message.empty()) result.message += "; ";
  result.message += fmt::format(
      "{} of {} points, but it counts only as far as the hidden checks of the exercise hold",
      result.points, entry.points);
  result.points = most;
}

void require_code(const Assignment& assignment, const Checks& checks) {
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) {
      if (!checks.contains(entry.id)) throw std::logic_error("no code of the check " + entry.id);
    }
  }
}

/// Why the checks of an exercise cannot be run; empty if they can. Students' own tests try programs
/// of the instructor, whatever their own file is like.
std::string obstacle(const Exercise& exercise, const Built& built, Visibility visibility) {
  if (visibility == Visibility::tests) return "";
  if (built.compile_errors.contains(exercise.id)) {
    return exercise.file + " was not taken or does not compile";
  }
  return built.link_error.empty() ? "" : "the program does not link";
}

}  // namespace

std::vector<CheckResult> try_checks(const Assignment& assignment, const Checks& checks,
                                    const Built& built, const Variant& variant, ProgramRun& run,
                                    const std::function<void()>& after_public) {
  require_code(assignment, checks);
  const Program program = [&](const std::string& task, const Numbers& inputs) {
    return run.answer(task, inputs);
  };
  std::map<std::string, CheckResult> results;
  const auto try_all = [&](Visibility visibility) {
    for (const Exercise& exercise : assignment.exercises) {
      const std::string why_not = obstacle(exercise, built, visibility);
      run.use(built.program_of(exercise));
      for (const CheckEntry& entry : exercise.checks) {
        if (entry.visibility != visibility) continue;
        const Outcome outcome = why_not.empty() ? outcome_of(checks.at(entry.id), program, variant)
                                                : Outcome{0, why_not};
        results[entry.id] = {entry.id, points_of(outcome.share, entry.points), outcome.message};
      }
    }
  };
  try_all(Visibility::visible);
  run.use(built.program);
  if (after_public) after_public();
  try_all(Visibility::hidden);
  try_all(Visibility::tests);
  std::vector<CheckResult> in_order;
  for (const Exercise& exercise : assignment.exercises) {
    const double share = hidden_share(exercise, results);
    for (const CheckEntry& entry : exercise.checks) {
      CheckResult& result = results.at(entry.id);
      if (entry.visibility == Visibility::visible) limit(result, entry, share);
      in_order.push_back(result);
    }
  }
  return in_order;
}

double in_hundredths(double number) {
  return std::round(number * 100) / 100;
}

double total(const std::vector<CheckResult>& results) {
  double sum = 0;
  for (const CheckResult& result : results) sum += result.points;
  return in_hundredths(sum);
}

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
  for (const auto& [task, n_single] : assignment.single_numbers) {
    if (run.was_asked(task)) continue;
    trial.losses.push_back(fmt::format("single_numbers: no check asks the task '{}'", task));
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
