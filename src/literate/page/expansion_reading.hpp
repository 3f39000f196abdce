// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "literate/prose/tex_scanner.hpp"

namespace literate::page_reading {

/// Goes past blanks, line ends and comments.
void skip_blanks(TexScanner& in);

/// The next argument without its braces; of an argument without braces its one character or
/// command.
std::string_view argument(TexScanner& in);

/// An argument in brackets; none if there is no bracket, over at most one line end.
std::optional<std::string_view> option(TexScanner& in);

/// The names between commas, without blanks.
std::vector<std::string> names_in(std::string_view text);

}  // namespace literate::page_reading
