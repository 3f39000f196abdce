// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace literate {

/// The texts of literate.sty, keep_preamble.tex and contents_decide.pl, which the build puts into
/// the library.
extern const std::string_view literate_sty, keep_preamble_tex, contents_decide_pl;

}  // namespace literate
