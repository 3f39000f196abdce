// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/document/document.hpp"

namespace literate {

/// The number of the form of results.json; document/results.schema.json describes it.
inline constexpr int results_schema = 1;

/// results.json: everything that was registered, with its place, and the names of the files of the
/// folder.
std::string results_json(const Document& document, const std::string& case_name,
                         const std::vector<std::string>& files);

}  // namespace literate
