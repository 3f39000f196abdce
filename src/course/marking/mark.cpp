// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/mark.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace course {
namespace {

std::string indented(const std::string& text) {
  std::string result = "    ";
  for (const char character : text) {
    result += character;
    if (character == '\n') result += "    ";
  }
  return result + "\n";
}

}  // namespace

double deduction_of(const Graded& graded) {
  return in_hundredths(total(graded.results) * graded.late.percent / 100);
}

double mark_of(const Graded& graded) {
  return in_hundredths(total(graded.results) - deduction_of(graded));
}

std::string state_of(const Graded& graded) {
  if (graded.late.is_refused) return "too late";
  return graded.late.days == graded.late.slip_days ? "on time" : "late";
}

std::string lateness_text(const Graded& graded) {
  const Lateness& late = graded.late;
  if (late.days == 0) return "on time";
  const auto days = [](int n) { return fmt::format("{} {}", n, n == 1 ? "day" : "days"); };
  const std::string begin = days(late.days) + " late";
  if (late.is_refused) return begin + ": nothing counts any more";
  if (late.slip_days == 0) {
    return fmt::format("{}: {} % of the points are deducted", begin, late.percent);
  }
  const std::string slip = fmt::format("{}, {} slip {} used", begin, late.slip_days,
                                       late.slip_days == 1 ? "day" : "days");
  if (late.slip_days == late.days) return slip + ": nothing is deducted";
  return fmt::format("{}: {} % of the points are deducted", slip, late.percent);
}

const CheckResult& result_of(const Graded& graded, const std::string& check) {
  const auto result = std::ranges::find(graded.results, check, &CheckResult::id);
  if (result == graded.results.end()) throw std::out_of_range("no result of the check " + check);
  return *result;
}

bool is_passed(const CheckEntry& entry, const CheckResult& result) {
  return result.points >= entry.points;
}

std::string mark_json(const Assignment& assignment, const Graded& graded) {
  nlohmann::ordered_json json = {{"student", graded.student},
                                 {"state", state_of(graded)},
                                 {"slip_days", graded.late.slip_days},
                                 {"points", total(graded.results)},
                                 {"deduction", deduction_of(graded)},
                                 {"mark", mark_of(graded)},
                                 {"has_report", graded.submission.has_report},
                                 {"missing", nlohmann::ordered_json::array()},
                                 {"not_compiling", nlohmann::ordered_json::array()},
                                 {"checks", nlohmann::ordered_json::object()}};
  for (const Exercise& exercise : assignment.exercises) {
    if (!graded.compile_errors.contains(exercise.id)) continue;
    const bool is_there = graded.submission.files.contains(exercise.file);
    json[is_there ? "not_compiling" : "missing"].push_back(exercise.id);
  }
  for (const CheckResult& result : graded.results) json["checks"][result.id] = result.points;
  return json.dump(2) + "\n";
}

std::string log_text(const Assignment& assignment, const Graded& graded) {
  std::string text = fmt::format("{}, {}: {} of {} points, {}\n", assignment.title, graded.student,
                                 mark_of(graded), assignment.points, lateness_text(graded));
  for (const std::string& problem : graded.submission.problems) text += "taken: " + problem + "\n";
  if (!graded.link_error.empty()) text += "link:\n" + indented(graded.link_error);
  for (const auto& [exercise, message] : graded.compile_errors) {
    text += fmt::format("compile {}:\n{}", exercise, indented(message));
  }
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) {
      const CheckResult& result = result_of(graded, entry.id);
      text += fmt::format("{:<24} {:>6} of {:<6} {}\n", entry.id, result.points, entry.points,
                          result.message);
    }
  }
  for (const std::string& missed : graded.missed) text += missed + "\n";
  return text;
}

}  // namespace course
