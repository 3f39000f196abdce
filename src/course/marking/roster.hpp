// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/marking/lateness.hpp"

namespace course {

/// What the class's file tells of one student.
struct RosterEntry {
  std::optional<Time> submitted = {};
  std::optional<Time> deadline = {};  ///< an extension: instead of the assignment's
};

/// The class, by student.
using Roster = std::map<std::string, RosterEntry>;

/// Reads a CSV file with a header line, whose columns `student` and, where there are such,
/// `submitted` and `deadline` (RFC 3339; empty for unknown) count. Throws sys::SourceError
/// «file:line: …» for a student named twice, an id that is none, and a time that is none.
Roster read_roster(const std::filesystem::path& file);

/// A submission in the folder of all.
struct Entry {
  std::string student;
  std::filesystem::path path;
};

/// What there is to grade, sorted by student, and a line for each thing in the folder that is no
/// submission, is from somebody who is not in the class, or is one of two from the same student.
struct Listing {
  std::vector<Entry> entries;
  std::vector<std::string> problems;
};

/// Throws OutputError for what is no folder, or cannot be read.
Listing list_submissions(const std::filesystem::path& folder, const std::optional<Roster>& roster);

}  // namespace course
