// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/format.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "system/decimal.hpp"

namespace literate {

namespace {

constexpr std::array<std::string_view, 6> names_of_notations{"significant", "fixed", "scientific",
                                                             "integer",     "exact", "uncertain"};

}  // namespace

std::string_view name_of(Notation notation) {
  return names_of_notations.at(static_cast<std::size_t>(notation));
}

bool has_digits(Notation notation) {
  return notation == Notation::significant || notation == Notation::fixed ||
         notation == Notation::scientific;
}

Format Format::with_digits(int n_digits) const {
  Format format = *this;
  if (notation_ != Notation::scientific) format.notation_ = Notation::significant;
  format.digits_ = n_digits;
  return format;
}

std::string Format::text() const {
  const bool is_percent = is_percentage_ && notation_ == Notation::fixed;
  std::string text = fmt::format("{}({})", is_percent ? "percent" : name_of(notation_),
                                 has_digits(notation_) ? fmt::format("{}", digits_) : "");
  if (is_percentage_ && !is_percent) text += ".in_percent()";
  if (rounds_up_) text += ".rounded_up()";
  return text;
}

Format Format::parse(std::string_view text) {
  const auto fails = [text] {
    return std::invalid_argument(fmt::format(
        "'{}' is not a format: significant(4), fixed(2), scientific(3), percent(1), integer(), "
        "exact() or uncertain(), with .in_percent() or .rounded_up() behind it",
        text));
  };
  const auto open = text.find('('), close = text.find(')');
  if (open == text.npos || close == text.npos || close < open) throw fails();
  const std::string_view name = text.substr(0, open);
  const std::string_view digits = text.substr(open + 1, close - open - 1);
  std::string_view rest = text.substr(close + 1);

  const bool is_percent = name == "percent";
  const auto* const found = std::ranges::find(names_of_notations, is_percent ? "fixed" : name);
  if (found == names_of_notations.end()) throw fails();
  const auto notation = static_cast<Notation>(found - names_of_notations.begin());
  const auto count = sys::parsed<int>(digits);
  if (has_digits(notation) ? !count.has_value() : !digits.empty()) throw fails();

  Format format(notation, count.value_or(0));
  format.is_percentage_ = is_percent;
  const auto takes = [&rest](std::string_view suffix) {
    const bool is_there = rest.starts_with(suffix);
    if (is_there) rest.remove_prefix(suffix.size());
    return is_there;
  };
  if (takes(".in_percent()")) format.is_percentage_ = true;
  if (takes(".rounded_up()")) format.rounds_up_ = true;
  if (!rest.empty()) throw fails();
  return format;
}

}  // namespace literate
