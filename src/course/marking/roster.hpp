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
};

/// The class, by student.
using Roster = std::map<std::string, RosterEntry>;

/// Reads a CSV file (RFC 4180, but no field may hold a line end) with a header line. It uses
/// the column `student` and, if they exist, `submitted` and `deadline` (RFC 3339; empty if
/// unknown); a column `name` is for people. Throws sys::SourceError «file:line: …» for any other
/// column, a column that stands there twice, a student listed twice, an id that is not allowed, a
/// time that cannot be read, and a line that does not fit the header.
Roster read_roster(const std::filesystem::path& file);

/// A line that says for how many students the class knows when they handed in, so that nobody
/// overlooks that it knows none.
std::string lateness_source(const Roster& roster);

/// A submission in the folder of all.
struct Entry {
  std::string student;
  std::filesystem::path path;
};

/// The submissions to grade, sorted by student, and a line for each entry of the folder that is
/// no submission, is from somebody who is not in the class, or is one of several from the same
/// student.
struct Listing {
  std::vector<Entry> entries;
  std::vector<std::string> problems;
};

/// Lists the submissions in a folder. Throws OutputError if it is no folder or cannot be read.
Listing list_submissions(const std::filesystem::path& folder, const std::optional<Roster>& roster);

}  // namespace course
