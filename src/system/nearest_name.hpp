// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace sys {

/// «, did you mean 'x'?» with the name that is nearest to an unknown one by single-letter edits;
/// empty if more than a third of the letters, and more than two, or all would have to change.
std::string suggestion(const std::string& unknown, const std::set<std::string>& names);

}  // namespace sys
