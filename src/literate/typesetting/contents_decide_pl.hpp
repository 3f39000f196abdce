// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace literate {

/// The text of contents_decide.pl, which the build puts into the library.
extern const std::string_view contents_decide_pl;

}  // namespace literate
