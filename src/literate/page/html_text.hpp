// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Escapes characters for HTML, in text and in attributes between double quotation marks.
std::string escape_html(std::string_view text);

/// The text of a piece of HTML: without tags and the TeX of formulas, and with white space joined.
/// Characters stay escaped.
std::string text_of_html(std::string_view html);

/// One word for what the page tells apart by a colour: «partly» for «partly confirmed».
std::string one_word(const std::string& verdict);

/// A text without its blanks and line ends, by which formulas are compared.
std::string without_blanks(std::string_view text);

}  // namespace literate
