// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/feedback_release.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <pugixml.hpp>

#include "course/marking/page.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/staging.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// What a check tries, in the words that students know.
std::string says(const Assignment& assignment, const std::string& check) {
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) {
      if (entry.id == check) return fmt::format("{}: {}", exercise.title, entry.says);
    }
  }
  return check;
}

std::string outcome_text(const Regrade& regrade) {
  switch (regrade.outcome) {
    case RegradeOutcome::open:
      return "It is not decided yet.";
    case RegradeOutcome::granted:
      return fmt::format("It now gives {} points. {} ({})", regrade.points, regrade.answer,
                         regrade.marker);
    case RegradeOutcome::refused:
      break;
  }
  return fmt::format("It stays as it is. {} ({})", regrade.answer, regrade.marker);
}

/// The child of that name, counted from 0; none if there are fewer.
pugi::xml_node nth_child(pugi::xml_node parent, const char* name, std::size_t n) {
  pugi::xml_node child = parent.child(name);
  while (n-- > 0) child = child.next_sibling(name);
  return child;
}

/// Writes what a check gives that was marked again into its row. Throws OutputError if there is no
/// such row.
void write_regraded(pugi::xml_node row, const CheckEntry& check, double points) {
  if (!row || row.first_child() == row.last_child()) {
    throw sys::OutputError(fmt::format("there is no row of {}", check.id));
  }
  row.remove_attribute("class");
  if (points < check.points) row.append_attribute("class") = "lost";
  add_element(row.first_child(), "div", "marked again", "note");
  row.last_child().text().set(fmt::format("{} / {}", points, check.points).c_str());
}

/// Makes the rows add up to the mark. The page does not hold the ids of checks, since students do
/// not know those of hidden ones, but it has a table for each exercise and a row for each check.
void write_all_regraded(pugi::xml_node body, const Assignment& assignment, const Mark& mark) {
  for (std::size_t i = 0; i < assignment.exercises.size(); ++i) {
    const std::vector<CheckEntry>& checks = assignment.exercises[i].checks;
    const pugi::xml_node table = nth_child(body, "table", i);
    for (std::size_t k = 0; k < checks.size(); ++k) {
      const std::string& id = checks[k].id;
      if (std::ranges::find(mark.regraded, id) == mark.regraded.end()) continue;
      write_regraded(nth_child(table, "tr", k), checks[k], mark.checks.at(id));
    }
  }
}

void add_regrades(pugi::xml_node body, const Assignment& assignment,
                  const std::vector<Regrade>& regrades) {
  if (regrades.empty()) return;
  add_element(body, "h2", "Marked again");
  for (const Regrade& regrade : regrades) {
    add_element(body, "p", says(assignment, regrade.check));
    add_element(body, "p", "You wrote: " + regrade.reason, "note");
    add_element(body, "p", outcome_text(regrade));
  }
}

/// What persons gave for the report.
void add_report(pugi::xml_node body, const Assignment& assignment, const Mark& mark) {
  if (mark.criteria.empty()) return;
  add_element(body, "h2", "The report");
  pugi::xml_node table = body.append_child("table");
  for (const Criterion& criterion : assignment.criteria) {
    const auto found = mark.criteria.find(criterion.id);
    if (found == mark.criteria.end()) continue;
    const CriterionMark& given = found->second;
    pugi::xml_node row = table.append_child("tr");
    if (given.points < criterion.points) row.append_attribute("class") = "lost";
    pugi::xml_node what = row.append_child("td");
    add_element(what, "div", fmt::format("{}: {}", criterion.title, criterion.says));
    if (!given.comment.empty()) add_element(what, "div", given.comment, "note");
    add_element(row, "td", fmt::format("{} / {}", given.points, criterion.points));
  }
}

void write_mark(pugi::xml_node paragraph, double most, const StudentMark& student) {
  const Mark& mark = *student.mark;
  std::string text = fmt::format("{}: {} of {} points", student.student, mark.mark, most);
  if (mark.deduction > 0) {
    text += fmt::format(" (reached {}, deducted {})", mark.points, mark.deduction);
  }
  paragraph.text().set(text.c_str());
}

}  // namespace

std::string final_feedback(const Assignment& assignment, const std::string& page, double most,
                           const StudentMark& student, const std::vector<Regrade>& regrades) {
  pugi::xml_document document;
  const bool is_read = document.load_buffer(
      page.data(), page.size(), pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata,
      pugi::encoding_utf8);
  pugi::xml_node body = document.child("html").child("body");
  const pugi::xml_node mark = body.find_child_by_attribute("p", "id", "mark");
  if (!is_read || !mark) throw sys::OutputError("it is no feedback that `grade` wrote");
  write_mark(mark, most, student);
  body.remove_child(body.find_child_by_attribute("p", "id", "deduction"));  // the mark tells it
  if (!student.mark->criteria.empty()) {
    body.remove_child(body.find_child_by_attribute("p", "id", "report"));  // the criteria tell it
  }
  write_all_regraded(body, assignment, *student.mark);
  add_report(body, assignment, *student.mark);
  add_regrades(body, assignment, regrades);
  return page_text(document);
}

void release_feedback(const Assignment& assignment, const fs::path& grades, const ClassMarks& marks,
                      const std::vector<Regrade>& regrades, const fs::path& output) {
  const std::vector<std::string> former =
      fs::is_directory(output) ? sys::files_below(output) : std::vector<std::string>{};
  sys::Staging staging(output);
  for (const StudentMark& student : marks.students) {
    if (!student.mark) continue;
    const fs::path page = grades / student.unit() / "feedback.html";
    try {
      sys::write_file_atomically(staging.path() / (student.student + ".html"),
                                 final_feedback(assignment, sys::read_file(page), marks.most,
                                                student, regrades_of(regrades, student)));
    } catch (const sys::OutputError& error) {
      throw sys::OutputError(fmt::format("'{}': {}", page.string(), error.what()));
    }
  }
  staging.publish(former);
}

std::vector<std::string> reasons_to_wait(const ClassMarks& marks) {
  std::vector<std::string> reasons = marks.problems;
  for (const StudentMark& student : marks.students) {
    if (student.state != "not graded") continue;
    reasons.push_back(
        fmt::format("student {} handed something in that is not graded", student.student));
  }
  return reasons;
}

}  // namespace course
