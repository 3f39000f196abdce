// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// Finds numbers typed into the prose of a LaTeX text where a computed value ought to stand.
///
/// A number counts as typed if a unit follows it or it has more than two significant digits; final
/// zeros of a whole number are not significant. Exempt are constants in displayed equations, a
/// year in parentheses or behind a month, the place in a source that is named beside a \cite, and
/// lines that end in a comment «% constant: reason». Such a comment without a reason, or on a line
/// that needs none, is reported as well. Each finding is «file:line:column: message».
std::vector<std::string> typed_numbers(std::string_view latex, const std::string& file);

/// The same for all *.tex files below a folder, named with the folder's own last name in front.
/// Throws sys::OutputError if the folder or a file cannot be read.
std::vector<std::string> typed_numbers_below(const std::filesystem::path& folder);

}  // namespace literate
