// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// What LaTeX's package listings calls the language of a source file, by the file's name; empty for
/// a text whose language is not known, which is printed as it is. literate.sty defines those that
/// listings lacks: CMake, Julia, JSON and TOML.
std::string listing_language(std::string_view file);

}  // namespace literate
