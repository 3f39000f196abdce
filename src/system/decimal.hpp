// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace sys {

/// The number that the whole text spells, whatever the locale says; none if the text is anything
/// else, or a number beyond the range of the type.
template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// A decimal number: ± digits · 10^place, where `place` is that of the last digit.
///
/// `digits` has no leading zero, except that zero itself is "0"; zero has no sign.
struct Decimal {
  bool negative = false;
  std::string digits = "0";
  int place = 0;
};

/// Reads a decimal number, with a sign, a point and an exponent or without, and keeps all its
/// digits: "-1.50e3" is −150 · 10^1. None if the text is anything else.
std::optional<Decimal> parse_decimal(std::string_view text);

/// The fewest digits that read back as the same double, which is finite; none of them is a zero at
/// the end.
Decimal shortest(double number);

/// The double nearest to a decimal number; infinite if that is beyond the range of a double.
double number_of(const Decimal& number);

}  // namespace sys
