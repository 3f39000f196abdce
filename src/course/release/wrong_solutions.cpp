// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/wrong_solutions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "config/table.hpp"
#include "course/release/comment_lines.hpp"
#include "system/lines.hpp"

namespace course {
namespace {

int n_occurrences(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

void require_once(const config::Table& table, const WrongSolution& wrong, const std::string& text) {
  if (wrong.before.empty()) table.fail("before", "must not be empty");
  const int n = n_occurrences(text, wrong.before);
  if (n != 1) {
    table.fail("before",
               fmt::format("stands {} times in the solution's {}, not once", n, wrong.file));
  }
  if (wrong.after == wrong.before) table.fail("after", "is the same as before");
}

WrongSolution read(const config::Table& table, const Assignment& assignment,
                   const Files& solution) {
  WrongSolution wrong{.id = table.text("id"),
                      .says = table.text("says"),
                      .file = table.text("file"),
                      .before = table.text("before"),
                      .after = table.text("after"),
                      .points = table.number("points")};
  if (wrong.id.empty()) table.fail("id", "must not be empty");
  if (wrong.says.empty()) table.fail("says", "must not be empty");
  const auto& exercises = assignment.exercises;
  if (std::ranges::find(exercises, wrong.file, &Exercise::file) == exercises.end()) {
    table.fail("file", fmt::format("{} is no exercise's file", wrong.file));
  }
  require_once(table, wrong, solution.at(wrong.file));
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
  std::string& text = solution.at(wrong.file);
  text.replace(text.find(wrong.before), wrong.before.size(), wrong.after);
  return solution;
}

}  // namespace course
