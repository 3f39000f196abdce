// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>

namespace sys {

/// Finds the name that is most similar to an unknown one, by the number of single-letter edits.
/// Returns none if this number exceeds both two and a third of the letters, or if all differ.
std::optional<std::string> nearest_name(const std::string& unknown,
                                        const std::set<std::string>& names);

/// Returns «, did you mean 'x'?» with that name; empty if there is none.
std::string suggestion(const std::string& unknown, const std::set<std::string>& names);

}  // namespace sys
