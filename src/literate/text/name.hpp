// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace literate {

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
