// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/provenance/manifest.hpp"

namespace literate {

/// How a document differs from the same one made elsewhere.
struct ManifestComparison {
  std::vector<std::string>
      changed_outputs;               ///< files whose bytes differ, or that one of them lacks
  std::vector<std::string> reasons;  ///< what differs of tools and inputs, a line each
  std::vector<std::string> moved;    ///< numbers that differ by more than their errors
};

/// Compares bytes, and each number within the sum of the two errors it has; one without an error,
/// as it is printed.
ManifestComparison compare(const Manifest& theirs, const Manifest& ours);

}  // namespace literate
