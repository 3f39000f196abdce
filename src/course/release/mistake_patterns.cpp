// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/mistake_patterns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace {

/// Throws nlohmann's exceptions if the JSON is no pattern.
MistakePattern pattern_of(const nlohmann::json& json) {
  return {.id = json.at("id").get<std::string>(),
          .says = json.at("says").get<std::string>(),
          .exercises = json.at("exercises").get<std::vector<std::string>>(),
          .points = json.at("points").get<std::map<std::string, double>>()};
}

/// Whether a pattern knows every exercise that it names, and each of their checks.
bool is_of(const Assignment& assignment, const MistakePattern& pattern) {
  return std::ranges::all_of(pattern.exercises, [&](const std::string& id) {
    const auto exercise = std::ranges::find(assignment.exercises, id, &Exercise::id);
    if (exercise == assignment.exercises.end()) return false;
    return std::ranges::all_of(exercise->checks, [&](const CheckEntry& check) {
      return pattern.points.contains(check.id);
    });
  });
}

}  // namespace

std::vector<std::string> changed_exercises(const Assignment& assignment,
                                           const WrongSolution& wrong) {
  std::vector<std::string> ids;
  for (const Exercise& exercise : assignment.exercises) {
    if (std::ranges::find(wrong.changes, exercise.file, &Change::file) != wrong.changes.end()) {
      ids.push_back(exercise.id);
    }
  }
  return ids;
}

std::string patterns_json(const std::vector<MistakePattern>& patterns) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const MistakePattern& pattern : patterns) {
    json.push_back({{"id", pattern.id},
                    {"says", pattern.says},
                    {"exercises", pattern.exercises},
                    {"points", pattern.points}});
  }
  return json.dump(2) + "\n";
}

std::vector<MistakePattern> read_patterns(const Assignment& assignment,
                                          const std::filesystem::path& file) {
  std::vector<MistakePattern> patterns;
  const std::string text = sys::read_file(file);
  try {
    for (const auto& json : nlohmann::json::parse(text)) patterns.push_back(pattern_of(json));
  } catch (const nlohmann::json::exception&) {
    throw sys::OutputError(
        fmt::format("'{}' does not hold the patterns of wrong solutions", file.string()));
  }
  for (const MistakePattern& pattern : patterns) {
    if (is_of(assignment, pattern)) continue;
    throw sys::OutputError(
        fmt::format("'{}': wrong solution {} is of another state of the assignment; make course DO=handout "
                    "writes the file anew",
                    file.string(), pattern.id));
  }
  return patterns;
}

}  // namespace course
