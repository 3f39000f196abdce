// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace literate {

/// The text of keep_preamble.tex, which the build puts into the library.
extern const std::string_view keep_preamble_tex;

}  // namespace literate
