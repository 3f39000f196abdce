// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/wrong_solutions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "config/table.hpp"
#include "course/release/markers.hpp"
#include "system/text.hpp"

namespace course {
namespace {

int n_occurrences(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

void require_once(const config::Table& table, const Change& change, const std::string& text) {
  if (change.before.empty()) table.fail("before", "must not be empty");
  const int n = n_occurrences(text, change.before);
  if (n != 1) {
    table.fail("before",
               fmt::format("stands {} times in the solution's {}, not once", n, change.file));
  }
  if (change.after == change.before) table.fail("after", "is the same as before");
}

Change read_change(const config::Table& table, const Assignment& assignment,
                   const Files& solution) {
  Change change{
      .file = table.text("file"), .before = table.text("before"), .after = table.text("after")};
  const auto& exercises = assignment.exercises;
  if (std::ranges::find(exercises, change.file, &Exercise::file) == exercises.end()) {
    table.fail("file", fmt::format("{} is no exercise's file", change.file));
  }
  require_once(table, change, solution.at(change.file));
  return change;
}

WrongSolution read(const config::Table& table, const Assignment& assignment,
                   const Files& solution) {
  WrongSolution wrong{.id = table.text("id"),
                      .says = table.text("says"),
                      .changes = {},
                      .points = table.number("points")};
  if (wrong.id.empty()) table.fail("id", "must not be empty");
  if (wrong.id.find('/') != std::string::npos) {
    table.fail("id", fmt::format("\"{}\" cannot name a program, because of its '/'", wrong.id));
  }
  if (wrong.says.empty()) table.fail("says", "must not be empty");
  const auto places = table.tables("change");
  if (places.empty()) wrong.changes.push_back(read_change(table, assignment, solution));
  for (const config::Table& place : places) {
    wrong.changes.push_back(read_change(place, assignment, solution));
    const std::string& file = wrong.changes.back().file;
    if (std::ranges::count(wrong.changes, file, &Change::file) > 1) {
      place.fail("file", fmt::format("{} is changed twice", file));
    }
  }
  if (wrong.points < 0 || wrong.points > assignment.points) {
    table.fail("points", fmt::format("{} is not from 0 to {}", wrong.points, assignment.points));
  }
  return wrong;
}

}  // namespace

std::vector<WrongSolution> read_wrong_solutions(const Assignment& assignment,
                                                const Files& solution) {
  const auto root = config::Table::parse_file(assignment.folder / "wrong_solutions.toml");
  std::vector<WrongSolution> list;
  std::set<std::string> ids;
  for (const config::Table& table : root.tables("wrong")) {
    list.push_back(read(table, assignment, solution));
    const std::string& id = list.back().id;
    if (!ids.insert(id).second) table.fail("id", fmt::format("\"{}\" stands here again", id));
  }
  root.reject_unknown_keys();
  return list;
}

std::string with_points(std::string_view text, const std::vector<double>& points) {
  std::string result;
  std::size_t n_tables = 0;
  bool is_inside_text = false;  // a text of several lines, which may hold anything
  for (const LineWithEnd& line : lines_with_ends(text)) {
    if (!is_inside_text && sys::stripped(line.text) == "[[wrong]]") ++n_tables;
    const bool is_points = !is_inside_text && n_tables > 0 && line.text.starts_with("points = ");
    if (is_points) {
      result += fmt::format("points = {}", points.at(n_tables - 1));
    } else {
      result += line.text;
    }
    result += line.end;
    if (n_occurrences(std::string(line.text), "\"\"\"") == 1) is_inside_text = !is_inside_text;
  }
  return result;
}

Files with_mistake(Files solution, const WrongSolution& wrong) {
  for (const auto& [file, before, after] : wrong.changes) {
    std::string& text = solution.at(file);
    text.replace(text.find(before), before.size(), after);
  }
  return solution;
}

}  // namespace course
