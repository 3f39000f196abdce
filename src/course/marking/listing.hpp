// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/marking/roster.hpp"

namespace course {

/// A submission in the folder of all.
struct Entry {
  std::string student;  ///< or group
  std::filesystem::path path;
};

/// The submissions to grade, sorted by student, and a line for each entry of the folder that is
/// no submission, is from somebody who is not in the class or hands in with a group, or is one of
/// several from the same student.
struct Listing {
  std::vector<Entry> entries;
  std::vector<std::string> problems;
};

/// Lists the submissions in a folder. Throws OutputError if it is no folder or cannot be read.
Listing list_submissions(const std::filesystem::path& folder, const std::optional<Roster>& roster);

}  // namespace course
