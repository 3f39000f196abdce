// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/feedback.hpp"

#include <fmt/core.h>

#include <pugixml.hpp>

#include "course/marking/page.hpp"

namespace course {
namespace {

void add_note(pugi::xml_node parent, const std::string& text) {
  if (!text.empty()) add_element(parent, "p", text, "note");
}

void add_summary(pugi::xml_node body, const Assignment& assignment, const Graded& graded) {
  add_element(body, "h1", assignment.title);
  add_element(
      body, "p",
      fmt::format("{}: {} of {} points", graded.student, mark_of(graded), assignment.points));
  add_note(body, "Handed in " + lateness_text(graded) + ".");
  if (deduction_of(graded) > 0) {
    add_note(body,
             fmt::format("Reached {}, deducted {}.", points_of(graded), deduction_of(graded)));
  }
  add_note(body, graded.submission.has_report ? "The report is marked by a person."
                                              : "There is no report/report.tex.");
  for (const std::string& problem : graded.submission.problems) {
    add_element(body, "p", problem, "lost");
  }
  if (graded.link_error.empty()) return;
  add_element(body, "p", "The program does not link:");
  add_element(body, "pre", graded.link_error);
}

void add_check(pugi::xml_node table, const CheckEntry& entry, const CheckResult& result) {
  pugi::xml_node row = table.append_child("tr");
  if (!is_passed(entry, result)) row.append_attribute("class") = "lost";
  pugi::xml_node what = row.append_child("td");
  add_element(what, "div", entry.says);
  if (entry.visibility != Visibility::hidden) {
    if (!result.message.empty()) add_element(what, "div", result.message, "note");
  } else {
    add_element(what, "div", "hidden check", "note");
  }
  add_element(row, "td", fmt::format("{} / {}", result.points, entry.points));
}

void add_exercise(pugi::xml_node body, const Exercise& exercise, const Graded& graded) {
  add_element(body, "h2", exercise.title);
  const auto error = graded.compile_errors.find(exercise.id);
  if (error != graded.compile_errors.end()) {
    add_element(body, "p", exercise.file + " is not compiled:");
    add_element(body, "pre", error->second);
  }
  pugi::xml_node table = body.append_child("table");
  for (const CheckEntry& entry : exercise.checks) {
    add_check(table, entry, result_of(graded, entry.id));
  }
}

void add_pictures(pugi::xml_node body, const std::vector<std::string>& pictures) {
  if (pictures.empty()) return;
  add_element(body, "h2", "What your program computes");
  for (const std::string& picture : pictures) {
    pugi::xml_document svg;
    if (svg.load_string(picture.c_str())) {
      body.append_child("figure").append_copy(svg.document_element());
    }
  }
}

}  // namespace

std::string feedback_html(const Assignment& assignment, const Graded& graded,
                          const std::vector<std::string>& pictures) {
  pugi::xml_document document;
  pugi::xml_node body = begin_page(document, assignment.title);
  add_summary(body, assignment, graded);
  for (const Exercise& exercise : assignment.exercises) add_exercise(body, exercise, graded);
  add_pictures(body, pictures);
  return page_text(document);
}

}  // namespace course
