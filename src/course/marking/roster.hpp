// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/marking/lateness.hpp"

namespace course {

/// What the file of the class says about one student.
struct RosterEntry {
  std::optional<Time> submitted = {};
  std::optional<Time> deadline = {};  ///< an extension, which replaces the assignment's deadline
  std::optional<int> slip_days = {};  ///< that the student has left
  std::string group = {};             ///< with which the student hands in; empty: alone
};

/// The class, by student.
using Roster = std::map<std::string, RosterEntry>;

/// Reads a CSV file with a header line. It uses the column `student` and, if they exist,
/// `submitted` and `deadline` (RFC 3339; empty if unknown), `slip_days` (a whole number; empty for
/// as many as the assignment allows) and `group` (empty for who hands in alone); a column `name` is
/// for people. Throws sys::SourceError «file:line:column: …» for any other column, a column that
/// stands there twice, a student listed twice, an id of a student or group that is not allowed, a
/// group that is named as a student is, a time or number that cannot be read, members of one group
/// with different times, and what is no CSV.
Roster read_roster(const std::filesystem::path& file);

/// A line that says for how many students the class knows when they handed in, so that nobody
/// overlooks that it knows none.
std::string lateness_source(const Roster& roster);

/// Who hands in, sorted: each group and each student who is in none. Handouts, variants and
/// submissions are theirs.
std::vector<std::string> units_of(const Roster& roster);

/// The students who hand in under a name: a group's members, or the student alone who is in none.
/// Empty if nobody does.
std::vector<std::string> members_of(const Roster& roster, const std::string& unit);

/// What holds for a unit: the times that its members have in common, and the fewest slip days that
/// one of them has left. Throws std::out_of_range if nobody hands in under this name.
RosterEntry entry_of(const Roster& roster, const std::string& unit);

}  // namespace course
