// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/feedback.hpp"

#include <fmt/core.h>

#include <pugixml.hpp>
#include <sstream>
#include <string>

namespace course {
namespace {

constexpr const char* page_style = R"(
body { max-width: 46rem; margin: 0 auto; padding: 1rem; font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.4rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
pre { overflow-x: auto; padding: .6rem; background: #f3f3f3; font-size: .8rem; }
table { width: 100%; border-collapse: collapse; }
th { text-align: left; font-weight: 600; padding: .35rem .5rem .35rem 0; }
td { padding: .35rem .5rem .35rem 0; border-top: 1px solid #ddd; vertical-align: top; }
td:last-child, th:last-child { text-align: right; white-space: nowrap; }
.lost { color: #9a1c1c; } .note { color: #555; font-size: .9rem; }
figure { margin: 1rem 0; } svg { width: 100%; height: auto; }
)";

/// Adds an element with a text to a page.
pugi::xml_node add_element(pugi::xml_node parent, const char* name, const std::string& text) {
  pugi::xml_node node = parent.append_child(name);
  node.text().set(text.c_str());
  return node;
}

/// The same with a class.
pugi::xml_node add_element(pugi::xml_node parent, const char* name, const std::string& text,
                           const char* css_class) {
  pugi::xml_node node = add_element(parent, name, text);
  node.append_attribute("class") = css_class;
  return node;
}

/// Begins a page of the course, one file that a phone can show, and returns its body.
pugi::xml_node begin_page(pugi::xml_document& document, const std::string& title) {
  document.append_child(pugi::node_doctype).set_value("html");
  pugi::xml_node html = document.append_child("html");
  html.append_attribute("lang") = "en";
  pugi::xml_node head = html.append_child("head");
  head.append_child("meta").append_attribute("charset") = "utf-8";
  pugi::xml_node viewport = head.append_child("meta");
  viewport.append_attribute("name") = "viewport";
  viewport.append_attribute("content") = "width=device-width, initial-scale=1";
  add_element(head, "title", title);
  add_element(head, "style", page_style);
  return html.append_child("body");
}

/// The page as a text.
std::string page_text(const pugi::xml_document& document) {
  std::ostringstream stream;
  // The raw format adds no spaces to the lines of <pre>, which a browser would show. Elements
  // without content get an end tag, since HTML would take <p/> for an open element.
  document.save(stream, "",
                pugi::format_raw | pugi::format_no_declaration | pugi::format_no_empty_element_tags,
                pugi::encoding_utf8);
  return stream.str() + "\n";
}

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
             fmt::format("Reached {}, deducted {}.", total(graded.results), deduction_of(graded)));
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
