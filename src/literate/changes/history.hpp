// SPDX-License-Identifier: GPL-3.0-or-later
// What git knows of a document: who wrote its lines, and which results were recorded beside them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "literate/provenance/manifest.hpp"

namespace literate {

/// What git says, run in a folder, whoever owns the checkout; none if it fails. Throws
/// sys::ToolError where there is no git.
std::optional<std::string> git(const std::filesystem::path& folder,
                               std::vector<std::string> arguments);

/// A commit that wrote lines of a file.
struct Commit {
  std::string id;
  std::int64_t authored = 0, committed = 0;
  bool is_first = false;  ///< of the history that there is

  bool is_made() const { return id.find_first_not_of('0') != std::string::npos; }
};

/// The commit of each line of a file, from what `git blame --porcelain` says.
std::vector<Commit> commits_of_lines(const std::string& blame);

/// The text of a paper's case file at a commit; none if it was not there.
std::optional<std::string> case_at(const std::string& commit, const std::filesystem::path& document,
                                   const std::filesystem::path& case_file);

/// The results.json of a commit.
struct RecordedResults {
  std::string commit;
  Manifest results;
};

/// All records of a document in the history of the commit that is checked out, the oldest first;
/// none if one of them cannot be read.
std::vector<RecordedResults> records_in(const std::filesystem::path& document,
                                        const std::string& project);

}  // namespace literate
