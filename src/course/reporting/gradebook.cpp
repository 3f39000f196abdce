// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/gradebook.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>

#include "course/assignment/student.hpp"
#include "system/csv.hpp"
#include "system/error.hpp"

namespace course {
namespace {

std::string feedback_of(const Assignment& assignment, const Mark& mark) {
  std::string text;
  for (const Exercise& exercise : assignment.exercises) {
    double points = 0;
    for (const CheckEntry& check : exercise.checks) points += mark.checks.at(check.id);
    text += fmt::format("{}: {:.6g} of {:.6g}. ", exercise.title, points, exercise.points());
  }
  if (mark.deduction > 0) text += fmt::format("Deducted for lateness: {}. ", mark.deduction);
  return text.substr(0, text.size() - 1);
}

/// The gradebook that Canvas exported.
class CanvasExport {
 public:
  CanvasExport(std::string_view text, const std::string& file)
      : file_(file), rows_(sys::parse_csv(text, file)) {
    if (rows_.empty()) throw sys::SourceError(file + ":1:1: the gradebook is empty");
    for (const char* wanted : {"Student", "ID", "Section"}) {
      if (find(wanted)) continue;
      throw sys::SourceError(
          fmt::format("{}:1:1: there is no column '{}'; a gradebook that Canvas exported is wanted",
                      file, wanted));
    }
  }

  std::optional<std::size_t> find(std::string_view name) const {
    const auto found = std::ranges::find(rows_[0], name, &sys::CsvField::text);
    if (found == rows_[0].end()) return std::nullopt;
    return static_cast<std::size_t>(found - rows_[0].begin());
  }

  /// The only column of this name or, if it is empty, whose name begins so.
  std::size_t assignment_column(const std::string& name, const std::string& begin) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < rows_[0].size(); ++i) {
      const std::string& head = rows_[0][i].text;
      if (name.empty() ? head.starts_with(begin) : head == name) found.push_back(i);
    }
    if (found.size() == 1) return found.front();
    throw sys::SourceError(
        fmt::format("{}:1:1: there are {} columns {} '{}', not one; COLUMN='name' says which",
                    file_, found.size(), name.empty() ? "that begin with" : "named",
                    shown_name(name.empty() ? begin : name)));
  }

  const std::vector<sys::CsvRow>& rows() const { return rows_; }

  /// The ids of a row's student; none in lines that are about the columns.
  std::vector<std::string> ids_of(const sys::CsvRow& row) const {
    std::vector<std::string> ids;
    for (const char* name : {"SIS Login ID", "SIS User ID"}) {
      const auto column = find(name);
      if (column && !row[*column].text.empty()) ids.push_back(row[*column].text);
    }
    return ids;
  }

 private:
  std::string file_;
  std::vector<sys::CsvRow> rows_;
};

}  // namespace

std::string moodle_csv(const Assignment& assignment, const ClassMarks& marks) {
  std::string csv = "student,grade,feedback\r\n";
  for (const StudentMark& student : marks.students) {
    if (!student.mark) continue;
    csv += fmt::format("{},{},{}\r\n", sys::spreadsheet_field(student.student), student.mark->mark,
                       sys::spreadsheet_field(feedback_of(assignment, *student.mark)));
  }
  return csv;
}

FilledGradebook canvas_csv(const Assignment& assignment, const ClassMarks& marks,
                           std::string_view exported, const std::string& file,
                           const std::string& column) {
  const CanvasExport gradebook(exported, file);
  const std::size_t mark_column = gradebook.assignment_column(column, assignment.title + " (");
  std::vector<std::size_t> kept;
  for (const char* name : {"Student", "ID", "SIS User ID", "SIS Login ID", "Section"}) {
    if (const auto found = gradebook.find(name)) kept.push_back(*found);
  }
  std::map<std::string, double> open;
  for (const StudentMark& student : marks.students) {
    if (student.mark) open[student.student] = student.mark->mark;
  }

  FilledGradebook filled;
  const auto add_line = [&](const sys::CsvRow& row, const std::string& last) {
    for (const std::size_t i : kept) filled.csv += sys::spreadsheet_field(row[i].text) + ",";
    filled.csv += last + "\r\n";
  };
  add_line(gradebook.rows()[0], sys::spreadsheet_field(gradebook.rows()[0][mark_column].text));
  for (std::size_t i = 1; i < gradebook.rows().size(); ++i) {
    const sys::CsvRow& row = gradebook.rows()[i];
    const std::vector<std::string> ids = gradebook.ids_of(row);
    if (ids.empty()) continue;
    const auto id = std::ranges::find_if(ids, [&](const auto& one) { return open.contains(one); });
    add_line(row, id == ids.end() ? "" : fmt::format("{}", open.extract(*id).mapped()));
  }
  for (const auto& [student, mark] : open) {
    filled.problems.push_back(
        fmt::format("{}: there is no line for student {}, whose mark is {}", file, student, mark));
  }
  return filled;
}

}  // namespace course
