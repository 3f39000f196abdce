// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>

namespace sys {

/// The name that is nearest to an unknown one by single-letter edits; none if more than a third of
/// the letters, and more than two, or all would have to change.
std::optional<std::string> nearest_name(const std::string& unknown,
                                        const std::set<std::string>& names);

/// «, did you mean 'x'?» with that name; empty if there is none.
std::string suggestion(const std::string& unknown, const std::set<std::string>& names);

}  // namespace sys
