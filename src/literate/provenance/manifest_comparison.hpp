// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/provenance/manifest.hpp"

namespace literate {

/// How a document differs from the same one made elsewhere.
struct ManifestComparison {
  std::vector<std::string> changed_outputs;  ///< files whose bytes differ or that one of them lacks
  std::vector<std::string> reasons;          ///< each tool or input that differs, a line each
  std::vector<std::string> moved;            ///< numbers beyond their errors, and other verdicts
};

/// Compares the bytes of files, verdicts and numbers: two numbers agree if they differ by no more
/// than the sum of their error bounds, or, if one has no bound, if they are printed the same.
ManifestComparison compare(const Manifest& theirs, const Manifest& ours);

}  // namespace literate
