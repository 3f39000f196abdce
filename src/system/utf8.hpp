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

/// The character that a text begins with; the text must not be empty. A byte that starts no valid
/// character (overlong forms and surrogates are not valid) stands alone.
Utf8Character first_character(std::string_view text);

/// The number of characters of a text, in which each byte of no valid character counts as one.
std::size_t n_characters(std::string_view text);

}  // namespace sys
