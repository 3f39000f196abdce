// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace sys {

/// One character of a UTF-8 text.
struct Utf8Character {
  std::string_view bytes;
  std::optional<char32_t> code_point;  ///< none for a byte that belongs to no valid character
};

/// Returns the first character of a text, which must not be empty. If its first byte starts no
/// valid character, that byte alone; overlong forms and surrogates are not valid.
Utf8Character first_character(std::string_view text);

/// Counts the characters of a text; each byte that belongs to no valid character counts as one.
std::size_t n_characters(std::string_view text);

}  // namespace sys
