// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// A listing as HTML, a `span.lit-line` a line with its number in `data-line`; within, comments,
/// keywords and strings have spans of their own. `language` is what the package listings calls it;
/// of one that is not known, the text comes as it is.
std::string highlighted(std::string_view code, std::string_view language, int first_line);

/// The name of a language as readers know it: «C++» of «[20]C++».
std::string_view language_name(std::string_view language);

}  // namespace literate
