// SPDX-License-Identifier: GPL-3.0-or-later
// Which limits are older than the first result that they judged, and which were chosen after it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "literate/document/names.hpp"
#include "literate/provenance/manifest.hpp"

namespace literate {

/// What is known of the age of limits.
struct DatedLimits {
  /// «claim x: quantity»: chosen_after or older_than_verdict; the others are not known.
  Manifest::Texts ages = {};
  std::vector<std::string> chosen_after = {};  ///< a line for each such limit, with both commits
};

/// Holds the limits of `now` against the records, results.json beside the prose, in the history of
/// the commit that is checked out, which must be a whole one. A limit is what the ledger prints,
/// and comes with the first record that prints it so. It judges its first result with the first
/// record that has its criterion, unless the claim is undecided by this criterion alone.
///
/// A limit was chosen after the result if it came with a later record, and an earlier one of the
/// same case, whatever its comments, has a result at another limit. It is older than its verdict
/// if it came earlier, after the first record of all, and has stood since; whether the number
/// itself was known before, as another value or claim, no record tells. It is not known of limits
/// that came with their result, nor, if their number is another, of those that the run computes, of
/// theory and method. Nothing is known if a record cannot be read.
DatedLimits dated_limits(const std::filesystem::path& document, const Manifest& now,
                         const Names& names, const std::filesystem::path& case_file);

}  // namespace literate
