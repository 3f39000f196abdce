// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/roster.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "course/assignment/student.hpp"
#include "system/csv.hpp"
#include "system/decimal.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace {

constexpr std::array<const char*, 6> columns = {"student",  "name",      "submitted",
                                                "deadline", "slip_days", "group"};

std::optional<Time> parsed_time(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(parse_time(text));
}

std::optional<int> parsed_days(const std::string& text) {
  constexpr int year = 366;
  if (text.empty()) return std::nullopt;
  const int days = sys::parsed<int>(text).value_or(-1);
  if (days < 0 || days > year) {
    throw sys::SourceError(
        fmt::format("slip_days: '{}' is no whole number from 0 to {}", shown_name(text), year));
  }
  return days;
}

[[noreturn]] void fail(const sys::CsvField& field, const std::string& message) {
  throw sys::SourceError(field.place + ": " + message);
}

/// The file of a class while it is read.
class RosterReader {
 public:
  explicit RosterReader(const std::filesystem::path& file)
      : file_(file.string()), rows_(sys::parse_csv(sys::read_file(file), file_)) {}

  Roster read() {
    read_header();
    for (std::size_t i = 1; i < rows_.size(); ++i) read_student(rows_[i]);
    for (std::size_t i = 1; i < rows_.size(); ++i) require_group_of_its_own(rows_[i]);
    return std::move(roster_);
  }

 private:
  // A column that nobody reads is refused: it could be a misspelt one, and lateness would be off
  // without a word.
  void read_header() {
    if (rows_.empty()) {
      throw sys::SourceError(file_ +
                             ":1:1: the class is empty; a header line with 'student' is wanted");
    }
    for (std::size_t i = 0; i < rows_[0].size(); ++i) {
      const sys::CsvField& head = rows_[0][i];
      if (std::ranges::find(columns, head.text) == columns.end()) {
        fail(head, fmt::format("there is a column '{}'; the columns are student, name, submitted, "
                               "deadline, slip_days and group",
                               shown_name(head.text)));
      }
      if (!at_.emplace(head.text, i).second) {
        fail(head, fmt::format("there are two columns '{}'", head.text));
      }
    }
    if (!at_.contains("student")) fail(rows_[0][0], "there is no column 'student'");
  }

  /// What `parse` makes of a field; that of an empty text if there is no such column.
  template <class Parse>
  auto parsed(const sys::CsvRow& row, const char* column, const Parse& parse) const {
    const auto at = at_.find(column);
    if (at == at_.end()) return parse(std::string());
    const sys::CsvField& field = row[at->second];
    try {
      return parse(field.text);
    } catch (const sys::SourceError& error) {
      fail(field, error.what());
    }
  }

  static std::string id(const std::string& text) {
    require_student_id(text);
    return text;
  }

  void read_student(const sys::CsvRow& row) {
    const std::string student = parsed(row, "student", id);
    const RosterEntry entry{.submitted = parsed(row, "submitted", parsed_time),
                            .deadline = parsed(row, "deadline", parsed_time),
                            .slip_days = parsed(row, "slip_days", parsed_days),
                            .group = parsed(row, "group", [](const std::string& text) {
                              return text.empty() ? text : id(text);
                            })};
    if (!roster_.emplace(student, entry).second) {
      fail(row[at_["student"]], fmt::format("student {} is listed twice", student));
    }
    if (!entry.group.empty()) require_agreement(row, entry);
  }

  /// The members of a group hand in once, and so at one time.
  void require_agreement(const sys::CsvRow& row, const RosterEntry& entry) {
    const auto [first, is_first] = groups_.emplace(entry.group, entry);
    if (is_first) return;
    const auto require = [&](const char* column, bool agrees) {
      if (agrees) return;
      fail(row[at_[column]],
           fmt::format("members of group {} differ in '{}'", entry.group, column));
    };
    require("submitted", first->second.submitted == entry.submitted);
    require("deadline", first->second.deadline == entry.deadline);
  }

  /// Under one name only one unit can hand in.
  void require_group_of_its_own(const sys::CsvRow& row) {
    const auto at = at_.find("group");
    if (at == at_.end() || !roster_.contains(row[at->second].text)) return;
    fail(row[at->second], fmt::format("group {} is named as a student is", row[at->second].text));
  }

  std::string file_;
  std::vector<sys::CsvRow> rows_;
  std::map<std::string, std::size_t> at_;      ///< columns by name
  std::map<std::string, RosterEntry> groups_;  ///< the first member of each
  Roster roster_;
};

const std::string& unit_of(const Roster::value_type& student) {
  return student.second.group.empty() ? student.first : student.second.group;
}

}  // namespace

Roster read_roster(const std::filesystem::path& file) {
  return RosterReader(file).read();
}

std::string lateness_source(const Roster& roster) {
  const auto n_known = std::ranges::count_if(
      roster, [](const auto& entry) { return entry.second.submitted.has_value(); });
  return n_known == 0 ? "the class has no time in a column 'submitted': nobody is late"
                      : fmt::format("lateness from column 'submitted': {} of {} students", n_known,
                                    roster.size());
}

std::vector<std::string> units_of(const Roster& roster) {
  std::set<std::string> units;
  for (const auto& student : roster) units.insert(unit_of(student));
  return {units.begin(), units.end()};
}

std::vector<std::string> members_of(const Roster& roster, const std::string& unit) {
  std::vector<std::string> members;
  for (const auto& student : roster) {
    if (unit_of(student) == unit) members.push_back(student.first);
  }
  return members;
}

RosterEntry entry_of(const Roster& roster, const std::string& unit) {
  const std::vector<std::string> members = members_of(roster, unit);
  if (members.empty()) throw std::out_of_range("nobody hands in as " + unit);
  RosterEntry entry = roster.at(members.front());
  for (const std::string& member : members) {
    const std::optional<int>& left = roster.at(member).slip_days;
    if (left) entry.slip_days = std::min(*left, entry.slip_days.value_or(*left));
  }
  return entry;
}

}  // namespace course
