// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "system/ascii.hpp"

namespace literate {

using sys::is_alphanumeric;
using sys::is_digit;
using sys::is_letter;

/// Whether the name of a TeX command may hold this character.
constexpr bool is_command_letter(char c) {
  return is_letter(c) || c == '@';
}

/// What LaTeX prints for a character beyond ASCII; empty if there is no mapping.
std::string_view latex_of(std::string_view character);

/// The character that a command such as `\theta` prints; empty if there is none.
std::string_view character_of(std::string_view command);

/// The mappings as a `literate` setting for the listings package.
std::string listings_characters();

}  // namespace literate
