// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/results.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

namespace course {
namespace {

using Json = nlohmann::ordered_json;

/// The message of a check for students; of a hidden check they are told the points only.
std::string message_for_student(const CheckEntry& entry, const CheckResult& result) {
  return entry.visibility == Visibility::visible ? result.message : "";
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

std::string junit_xml(const Assignment& assignment, const Graded& graded) {
  pugi::xml_document document;
  pugi::xml_node suites = document.append_child("testsuites");
  suites.append_attribute("name") = assignment.title.c_str();
  for (const Exercise& exercise : assignment.exercises) {
    pugi::xml_node suite = suites.append_child("testsuite");
    suite.append_attribute("name") = exercise.title.c_str();
    suite.append_attribute("tests") = exercise.checks.size();
    std::size_t n_failed = 0;
    for (const CheckEntry& entry : exercise.checks) {
      const CheckResult& result = result_of(graded, entry.id);
      pugi::xml_node test = suite.append_child("testcase");
      test.append_attribute("classname") = exercise.id.c_str();
      test.append_attribute("name") = entry.says.c_str();
      if (is_passed(entry, result)) continue;
      ++n_failed;
      pugi::xml_node failure = test.append_child("failure");
      failure.append_attribute("message") =
          fmt::format("{} of {} points", result.points, entry.points).c_str();
      failure.text().set(message_for_student(entry, result).c_str());
    }
    suite.append_attribute("failures") = n_failed;
    const auto error = graded.compile_errors.find(exercise.id);
    if (error != graded.compile_errors.end()) {
      suite.append_child("system-err").text().set(error->second.c_str());
    }
  }
  std::ostringstream stream;
  document.save(stream, "  ", pugi::format_default, pugi::encoding_utf8);
  return stream.str();
}

}  // namespace course
