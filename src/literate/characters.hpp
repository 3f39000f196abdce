// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// The bytes of the first UTF-8 character of a text that is not empty; a byte that starts no
/// valid character stands alone.
std::string_view first_character(std::string_view text);

/// What LaTeX prints for a character beyond ASCII; empty if there is no mapping.
std::string_view latex_of(std::string_view character);

/// The mappings as a `literate` setting for the listings package.
std::string listings_characters();

}  // namespace literate
