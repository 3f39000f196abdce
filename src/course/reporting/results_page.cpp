// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/results_page.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <pugixml.hpp>

#include "course/marking/page.hpp"

namespace course {
namespace {

using Row = std::vector<std::string>;

void add_row(pugi::xml_node table, const char* cell, const Row& texts) {
  pugi::xml_node row = table.append_child("tr");
  for (const std::string& text : texts) add_element(row, cell, text);
}

pugi::xml_node add_table(pugi::xml_node body, const Row& heads) {
  pugi::xml_node table = body.append_child("table");
  add_row(table, "th", heads);
  return table;
}

std::string number_or_dash(const std::optional<double>& number) {
  return number ? fmt::format("{:.2f}", *number) : "–";
}

/// How many students are in each state, and who has no mark.
void add_states(pugi::xml_node body, const ClassMarks& marks) {
  std::map<std::string, Row> by_state;
  for (const StudentMark& one : marks.students) by_state[one.state].push_back(one.student);
  for (const auto& [state, students] : by_state) {
    const bool is_marked = state == "on time" || state == "late";
    const std::string who = is_marked ? "" : fmt::format(": {}", fmt::join(students, ", "));
    add_element(body, "p", fmt::format("{}: {}{}", state, students.size(), who),
                is_marked ? "note" : "lost");
  }
}

/// A bar for each tenth of the points, as high as its share of the tallest, with its count above.
void add_histogram(pugi::xml_node body, double most, const ClassStatistics& statistics) {
  constexpr int bar = 56;
  constexpr int height = 160;
  constexpr int margin = 24;
  const std::size_t tallest = std::max<std::size_t>(1, std::ranges::max(statistics.histogram));
  const auto n_bars = static_cast<int>(statistics.histogram.size());
  pugi::xml_node svg = body.append_child("figure").append_child("svg");
  svg.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
  svg.append_attribute("role") = "img";
  svg.append_attribute("aria-label") = "histogram of the marks";
  svg.append_attribute("viewBox") =
      fmt::format("0 0 {} {}", bar * n_bars + bar, height + 2 * margin).c_str();
  const auto add_label = [&](int x, int y, const std::string& text) {
    pugi::xml_node label = add_element(svg, "text", text);
    label.append_attribute("x") = x;
    label.append_attribute("y") = y;
    label.append_attribute("text-anchor") = "middle";
    label.append_attribute("font-size") = "13";
  };
  for (int i = 0; i < n_bars; ++i) {
    const std::size_t count = statistics.histogram[static_cast<std::size_t>(i)];
    const int tall = static_cast<int>(static_cast<std::size_t>(height) * count / tallest);
    const int left = bar / 2 + i * bar;
    pugi::xml_node box = svg.append_child("rect");
    box.append_attribute("x") = left + 2;
    box.append_attribute("y") = margin + height - tall;
    box.append_attribute("width") = bar - 4;
    box.append_attribute("height") = tall;
    box.append_attribute("fill") = "#4a6fa5";
    if (count > 0) add_label(left + bar / 2, margin + height - tall - 5, fmt::format("{}", count));
  }
  for (int i = 0; i <= n_bars; ++i) {
    add_label(bar / 2 + i * bar, height + 2 * margin - 6, fmt::format("{:g}", most * i / n_bars));
  }
}

void add_summary_of_marks(pugi::xml_node body, const ClassStatistics& statistics) {
  add_element(body, "p",
              fmt::format("{} marks: mean {:.1f}, standard deviation {:.1f}, least {:g}, median "
                          "{:g}, most {:g}.",
                          statistics.n_graded, statistics.mean, statistics.standard_deviation,
                          statistics.least, statistics.median, statistics.most));
  if (!statistics.reliability) return;
  add_element(
      body, "p",
      fmt::format("Reliability of the points, Cronbach's α: {:.2f}.", *statistics.reliability),
      "note");
}

void add_items(pugi::xml_node body, const ClassStatistics& statistics) {
  add_element(body, "h2", "Checks");
  add_element(body, "p",
              "Facility is the mean share of a check's points: 1 if everybody has all of them. "
              "Discrimination is the correlation of its points with all others: a check near zero, "
              "or below, is passed by good and by bad solutions alike.",
              "note");
  pugi::xml_node table =
      add_table(body, {"check", "exercise", "points", "all", "none", "facility", "discrimination"});
  for (const ItemStatistics& item : statistics.items) {
    const bool is_hidden = item.check.visibility == Visibility::hidden;
    add_row(table, "td",
            {item.check.id + (is_hidden ? " (hidden)" : ""), item.exercise,
             fmt::format("{}", item.check.points), fmt::format("{}", item.n_full),
             fmt::format("{}", item.n_none), fmt::format("{:.2f}", item.facility),
             number_or_dash(item.discrimination)});
  }
}

void add_mistakes(pugi::xml_node body, const std::vector<Met>& met) {
  add_element(body, "h2", "Mistakes that were met");
  if (met.empty()) {
    add_element(body, "p", "Nothing is known of wrong solutions; make course DO=handout tries them.", "note");
    return;
  }
  add_element(
      body, "p",
      "Who lost points in the same checks as a wrong solution. Those with one pattern "
      "cannot be told apart. Who has no point in an exercise has not done it, and made none of "
      "its mistakes.",
      "note");
  pugi::xml_node table = add_table(body, {"wrong solution", "students", "how many"});
  Row never;
  for (const Met& one : met) {
    if (one.students.empty()) {
      never.push_back(one.pattern.id);
      continue;
    }
    add_row(
        table, "td",
        {fmt::format("{}: {}", one.pattern.id, one.pattern.says),
         fmt::format("{}", fmt::join(one.students, ", ")), fmt::format("{}", one.students.size())});
  }
  if (never.empty()) return;
  add_element(body, "p", fmt::format("Nobody made these: {}.", fmt::join(never, ", ")), "note");
}

}  // namespace

std::string results_html(const Assignment& assignment, const ClassMarks& marks,
                         const ClassStatistics& statistics, const std::vector<Met>& met) {
  pugi::xml_document document;
  pugi::xml_node body = begin_page(document, assignment.title + ": results");
  add_element(body, "h1", assignment.title + ": results");
  add_states(body, marks);
  if (statistics.n_graded > 0) {
    add_summary_of_marks(body, statistics);
    add_histogram(body, marks.most, statistics);
    add_items(body, statistics);
    add_mistakes(body, met);
  }
  return page_text(document);
}

}  // namespace course
