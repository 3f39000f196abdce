// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "literate/document/names.hpp"

namespace literate {

inline constexpr const char* chosen_after = "chosen after the result";
inline constexpr const char* older_than_verdict = "older than its verdict";

/// What the record beside the prose, results.json, says of the age of a claim's limits, in the
/// order of its criteria; empty where it is not known, as without a record, with one of another
/// limit, or of another case unless that limit was chosen after a result.
class RecordedAges {
 public:
  /// Throws sys::OutputError for a record that cannot be read.
  RecordedAges(const std::filesystem::path& document, const Names& names);

  const std::vector<std::string>& of(const std::string& claim) const { return ages_.at(claim); }

  /// For LaTeX: «\LiterateLimitAge{claim}{2}{chosen after the result}» for each that is known.
  std::string latex() const;

 private:
  std::map<std::string, std::vector<std::string>> ages_;
};

}  // namespace literate
