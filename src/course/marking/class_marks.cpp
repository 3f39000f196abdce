// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/class_marks.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "course/assignment/student.hpp"
#include "system/csv.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// The students and groups who have a line, with what is known of them.
using Known = std::map<std::string, StudentMark>;

/// Throws nlohmann's exceptions if the JSON is no mark.
Mark parsed_mark(const Assignment& assignment, const nlohmann::json& json) {
  Mark mark;
  mark.state = json.at("state").get<std::string>();
  mark.slip_days = json.at("slip_days").get<int>();
  mark.points = json.at("points").get<double>();
  mark.deduction = json.at("deduction").get<double>();
  mark.mark = json.at("mark").get<double>();
  mark.has_report = json.at("has_report").get<bool>();
  mark.missing = json.at("missing").get<std::vector<std::string>>();
  mark.not_compiling = json.at("not_compiling").get<std::vector<std::string>>();
  for (const std::string& id : check_ids(assignment)) {
    mark.checks[id] = json.at("checks").at(id).get<double>();
  }
  return mark;
}

void read_mark(const Assignment& assignment, const fs::path& folder, Known& known,
               std::vector<std::string>& problems) {
  const std::string student = folder.filename().string();
  try {
    require_student_id(student);
    const auto json = nlohmann::json::parse(sys::read_file(folder / "mark.json"));
    if (json.at("student").get<std::string>() != student) {
      throw sys::OutputError("it is the mark of another student");
    }
    const Mark mark = parsed_mark(assignment, json);
    known[student] = {.student = student, .state = mark.state, .mark = mark};
  } catch (const nlohmann::json::exception&) {
    problems.push_back(fmt::format("'{}' is no mark of this assignment",
                                   shown_name((folder / "mark.json").string())));
  } catch (const std::exception& error) {
    problems.push_back(fmt::format("'{}': {}", shown_name(folder.string()), error.what()));
  }
}

/// Who handed in a file that is no archive, by the roster: whose name it begins with.
std::string student_of_file(const std::string& name, const std::optional<Roster>& roster) {
  if (!roster) return name.substr(0, name.find('.'));
  const auto units = units_of(*roster);
  const auto unit =
      std::ranges::find_if(units, [&](const auto& one) { return name.starts_with(one + "."); });
  return unit == units.end() ? "" : *unit;
}

/// Everybody who handed something in, even if it was more than one submission or cannot be read.
/// Who hands in with a group and did so alone is told by `list`, and has the group's mark.
std::vector<std::string> students_with_submission(const fs::path& submissions,
                                                  const std::optional<Roster>& roster) {
  std::vector<std::string> students;
  for (const auto& entry : fs::directory_iterator(submissions)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.')) continue;
    const bool is_folder = fs::is_directory(entry.symlink_status());
    const std::string student = is_folder || names_archive(entry.path())
                                    ? student_of(entry.path())
                                    : student_of_file(name, roster);
    if (roster && roster->contains(student) && members_of(*roster, student).empty()) continue;
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

void add_without_mark(Known& known, const std::string& student, const char* state) {
  known.emplace(student, StudentMark{.student = student, .state = state});
}

}  // namespace

std::vector<std::string> check_ids(const Assignment& assignment) {
  std::vector<std::string> ids;
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) ids.push_back(entry.id);
  }
  return ids;
}

ClassMarks class_marks(const Assignment& assignment, const fs::path& grades,
                       const std::optional<Roster>& roster,
                       const std::optional<fs::path>& submissions) {
  ClassMarks marks;
  Known known;
  for (const fs::path& one : folders_in(grades)) read_mark(assignment, one, known, marks.problems);
  if (submissions) {
    const std::vector<std::string> handed_in = students_with_submission(*submissions, roster);
    std::erase_if(known, [&](const auto& one) {
      const bool is_of_earlier = std::ranges::find(handed_in, one.first) == handed_in.end();
      if (is_of_earlier) {
        marks.problems.push_back(fmt::format(
            "'{}' is left out, since nothing of this name was handed in: it is of an earlier run",
            shown_name((grades / one.first).string())));
      }
      return is_of_earlier;
    });
    for (const std::string& student : handed_in) {
      const bool is_known = !roster || !members_of(*roster, student).empty();
      add_without_mark(known, student, is_known ? "not graded" : "not in the class");
    }
  }
  if (roster) {
    for (const std::string& unit : units_of(*roster)) add_without_mark(known, unit, "missing");
  }
  for (const auto& [unit, mark] : known) {
    std::vector<std::string> members = {unit};
    if (roster && !roster->contains(unit)) members = members_of(*roster, unit);
    if (members.empty()) members = {unit};  // of somebody who is not in the class
    for (const std::string& student : members) {
      marks.students.push_back(mark);
      marks.students.back().student = student;
      if (student != unit) marks.students.back().group = unit;
    }
  }
  std::ranges::sort(marks.students, {}, &StudentMark::student);
  return marks;
}

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
