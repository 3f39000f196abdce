// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/feedback.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace course {
namespace {

using Json = nlohmann::ordered_json;

/// The message of a check for students; of a hidden check they are told the points only.
std::string message_for_student(const CheckEntry& entry, const CheckResult& result) {
  return entry.visibility == Visibility::hidden ? "" : result.message;
}

/// The text that concerns the whole submission.
std::string general_output(const Graded& graded) {
  std::string text = "Handed in " + lateness_text(graded) + ".\n";
  for (const std::string& problem : graded.submission.problems) text += problem + "\n";
  if (!graded.link_error.empty()) text += "The program does not link:\n" + graded.link_error + "\n";
  for (const auto& [exercise, message] : graded.compile_errors) {
    text += fmt::format("Exercise {} is not compiled:\n{}\n", exercise, message);
  }
  return text;
}

/// When students see it, in Gradescope's words.
const char* visibility_of(const Assignment& assignment) {
  return assignment.holds_feedback_back ? "after_published" : "visible";
}

Json test_of(const Assignment& assignment, const Exercise& exercise, const CheckEntry& entry,
             const CheckResult& result) {
  return {{"name", fmt::format("{}: {}", exercise.title, entry.says)},
          {"score", result.points},
          {"max_score", entry.points},
          {"status", is_passed(entry, result) ? "passed" : "failed"},
          {"output", message_for_student(entry, result)},
          {"visibility", visibility_of(assignment)}};
}

}  // namespace

std::string gradescope_json(const Assignment& assignment, const Graded& graded) {
  Json json = {{"score", mark_of(graded)},      {"output", general_output(graded)},
               {"output_format", "text"},       {"visibility", visibility_of(assignment)},
               {"stdout_visibility", "hidden"}, {"tests", Json::array()}};
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) {
      json["tests"].push_back(test_of(assignment, exercise, entry, result_of(graded, entry.id)));
    }
  }
  return json.dump(2) + "\n";
}

}  // namespace course
