// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/collect.hpp"

#include <fmt/core.h>

#include <map>
#include <nlohmann/json.hpp>

#include "course/assignment/student.hpp"
#include "course/assignment/student_text.hpp"
#include "course/marking/csv.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

using Rows = std::map<std::string, std::string>;  ///< the line behind the id, by student

std::vector<std::string> check_ids(const Assignment& assignment) {
  std::vector<std::string> ids;
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) ids.push_back(entry.id);
  }
  return ids;
}

std::string header(const Assignment& assignment) {
  std::string line = "student,state,points,deduction,mark,report,no file,not compiling";
  for (const std::string& id : check_ids(assignment)) line += "," + csv_field(id);
  return line + "\r\n";
}

std::string empty_row(const Assignment& assignment, const std::string& state) {
  return csv_field(state) + std::string(6 + check_ids(assignment).size(), ',') + "\r\n";
}

std::string joined(const nlohmann::json& texts) {
  std::string all;
  for (const auto& text : texts) all += (all.empty() ? "" : " ") + text.get<std::string>();
  return all;
}

/// Throws nlohmann's exceptions if the JSON is no mark.
std::string row_of(const Assignment& assignment, const nlohmann::json& mark) {
  std::string row = fmt::format(
      "{},{},{},{},{},{},{}", csv_field(mark.at("state").get<std::string>()),
      mark.at("points").get<double>(), mark.at("deduction").get<double>(),
      mark.at("mark").get<double>(), mark.at("has_report").get<bool>() ? "yes" : "no",
      csv_field(joined(mark.at("missing"))), csv_field(joined(mark.at("not_compiling"))));
  for (const std::string& id : check_ids(assignment)) {
    row += fmt::format(",{}", mark.at("checks").at(id).get<double>());
  }
  return row + "\r\n";
}

void read_mark(const Assignment& assignment, const fs::path& folder, Rows& rows, Grades& grades) {
  const std::string student = folder.filename().string();
  try {
    require_student_id(student);
    const auto mark = nlohmann::json::parse(sys::read_file(folder / "mark.json"));
    if (mark.at("student").get<std::string>() != student) {
      throw sys::OutputError("it is the mark of another student");
    }
    rows[student] = row_of(assignment, mark);
  } catch (const nlohmann::json::exception&) {
    grades.problems.push_back(fmt::format("'{}' is no mark of this assignment",
                                          shown_name((folder / "mark.json").string())));
  } catch (const std::exception& error) {
    grades.problems.push_back(fmt::format("'{}': {}", shown_name(folder.string()), error.what()));
  }
}

/// Everybody who handed something in, even if it was more than one submission.
std::vector<std::string> students_with_submission(const fs::path& submissions) {
  std::vector<std::string> students;
  for (const auto& entry : fs::directory_iterator(submissions)) {
    const bool is_folder = fs::is_directory(entry.symlink_status());
    if (!is_folder && !names_archive(entry.path())) continue;
    const std::string student = student_of(entry.path());
    try {
      require_student_id(student);
      students.push_back(student);
    } catch (const sys::SourceError&) {
      // The command `list` reports it.
    }
  }
  return students;
}

std::vector<fs::path> folders_in(const fs::path& grades) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(grades, error)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && !name.ends_with(".part")) folders.push_back(entry.path());
  }
  if (error) {
    throw sys::OutputError(fmt::format("cannot list '{}': {}", grades.string(), error.message()));
  }
  return folders;
}

}  // namespace

Grades collect_grades(const Assignment& assignment, const fs::path& folder,
                      const std::optional<Roster>& roster,
                      const std::optional<fs::path>& submissions) {
  Grades grades;
  Rows rows;
  for (const fs::path& one : folders_in(folder)) read_mark(assignment, one, rows, grades);
  if (submissions) {
    for (const std::string& student : students_with_submission(*submissions)) {
      const bool is_known = !roster || roster->contains(student);
      rows.emplace(student, empty_row(assignment, is_known ? "not graded" : "not in the class"));
    }
  }
  if (roster) {
    for (const auto& [student, entry] : *roster) {
      rows.emplace(student, empty_row(assignment, "missing"));
    }
  }
  grades.csv = header(assignment);
  for (const auto& [student, row] : rows) grades.csv += csv_field(student) + "," + row;
  return grades;
}

}  // namespace course
