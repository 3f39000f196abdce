// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/collect.hpp"
#include "system/csv.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace course {
namespace {

std::string header(const Assignment& assignment) {
  std::string line =
      "student,state,points,deduction,mark,report,no file,not compiling,slip days,group";
  for (const std::string& id : check_ids(assignment)) line += "," + sys::spreadsheet_field(id);
  return line + "\r\n";
}

std::string row_of(const Mark& mark) {
  return fmt::format(",{},{},{},{},{},{},{}", mark.points, mark.deduction, mark.mark,
                     mark.has_report ? "yes" : "no",
                     sys::spreadsheet_field(fmt::format("{}", fmt::join(mark.missing, " "))),
                     sys::spreadsheet_field(fmt::format("{}", fmt::join(mark.not_compiling, " "))),
                     mark.slip_days);
}

/// The points of each check.
std::string parts_of(const Assignment& assignment, const Mark& mark) {
  std::string row;
  for (const std::string& id : check_ids(assignment)) {
    row += fmt::format(",{}", mark.checks.at(id));
  }
  return row;
}

}  // namespace

std::string marks_csv(const Assignment& assignment, const ClassMarks& marks) {
  const std::string no_mark(7, ',');
  const std::string no_parts(check_ids(assignment).size(), ',');
  std::string csv = header(assignment);
  for (const StudentMark& student : marks.students) {
    csv += sys::spreadsheet_field(student.student) + "," + sys::spreadsheet_field(student.state) +
           (student.mark ? row_of(*student.mark) : no_mark) + "," +
           sys::spreadsheet_field(student.group) +
           (student.mark ? parts_of(assignment, *student.mark) : no_parts) + "\r\n";
  }
  return csv;
}

}  // namespace course
