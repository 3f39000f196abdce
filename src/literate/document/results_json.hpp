// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/document/document.hpp"

namespace literate {

/// The version of results.json, which document/results.schema.json describes.
inline constexpr int results_schema = 1;

/// Returns results.json: everything registered, with its place, and the names of the written files.
std::string results_json(const Document& document, const std::string& case_name,
                         const std::vector<std::string>& files);

}  // namespace literate
