// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// What a student or group wrote.
struct Written {
  std::string unit;
  Files files;  ///< those of the exercises
};

/// Two submissions that have much of an exercise in common.
struct LikePair {
  std::string exercise;
  std::string first, second;  ///< of which `first` has the greater part of its text in common
  int percent_of_first = 0;   ///< of the tokens of what the first wrote
  int percent_of_second = 0;
};

/// The pairs that are alike, and a line for each text that was not compared.
struct Likeness {
  std::vector<LikePair> pairs;  ///< the most alike first
  std::vector<std::string> problems;
};

/// The lines of some texts without blanks, by which what everybody has, or may well write, is told
/// from what somebody wrote.
std::set<std::string> known_lines(const std::vector<Files>& files);

/// The lines of a text that are not known.
std::string own_lines(std::string_view text, const std::set<std::string>& known);

/// Compares what students wrote, exercise by exercise, without the known lines, by sim_c++ of the
/// package similarity-tester: layout, comments, names and numbers do not count, and runs of fewer
/// than its 24 tokens neither. Finds the pairs with at least `percent` of the tokens of one of them
/// in common. What is left of a text may have 32 kB, many times as much as an honest solution, and
/// may not keep sim_c++ busy for seconds, or it is not compared. `work` is an empty folder.
/// Throws sys::ToolError if sim_c++ is missing.
Likeness likeness_of(const Assignment& assignment, const std::vector<Written>& all,
                     const std::set<std::string>& known, int percent,
                     const std::filesystem::path& work, Isolation isolation);

/// A table with a line for each pair.
std::string pairs_csv(const std::vector<LikePair>& pairs);

}  // namespace course
