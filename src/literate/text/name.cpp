// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/name.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "literate/text/characters.hpp"

namespace literate {

bool is_key(std::string_view text) {
  const auto is_allowed = [](char c) {
    return is_alphanumeric(c) || c == '-' || c == '_' || c == '.';
  };
  return !text.empty() && is_alphanumeric(text.front()) && std::ranges::all_of(text, is_allowed);
}

bool is_file_name(std::string_view text) {
  return is_key(text) && text.find('.') == std::string_view::npos;
}

void require_key(std::string_view text) {
  if (is_key(text)) return;
  throw std::logic_error(fmt::format("key '{}' must be letters, digits, '-', '_' and '.'", text));
}

void require_file_name(std::string_view text) {
  if (is_file_name(text)) return;
  throw std::logic_error(fmt::format("name '{}' must be letters, digits, '-' and '_'", text));
}

}  // namespace literate
