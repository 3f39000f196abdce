// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/excerpts/excerpt_hashes.hpp"

namespace app {

/// The excerpts of src as this program was compiled from them; defined by the build.
extern const std::vector<literate::CompiledExcerpt> compiled_excerpts;

}  // namespace app
