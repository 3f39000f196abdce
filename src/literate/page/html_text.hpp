// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Escapes characters for HTML, in text and in attributes between double quotation marks.
std::string escape_html(std::string_view text);

/// The text of a piece of HTML: without tags, and with white space joined.
std::string text_of_html(std::string_view html);

/// Without links, footnotes and ids, as in contents that repeat a heading.
std::string without_links(std::string_view html);

/// Without the element around it if all is a single paragraph.
std::string without_paragraph(std::string html);

/// Replaces every occurrence.
std::string replaced(std::string text, std::string_view from, std::string_view to);

}  // namespace literate
