// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "system/text.hpp"

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

/// Whether a text can be a key, as in `\val{…}`: letters, digits, hyphens, underscores and dots, of
/// which the first is a letter or digit.
bool is_key(std::string_view text);

/// Whether a text is a key without a dot, so that LaTeX can complete it to a file name.
bool is_file_name(std::string_view text);

/// Throws std::logic_error naming a text that is not a key.
void require_key(std::string_view text);

/// Throws std::logic_error naming a text that is not a file name.
void require_file_name(std::string_view text);

}  // namespace literate
