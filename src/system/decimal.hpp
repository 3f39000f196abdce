// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace sys {

/// Parses a text that consists of a number only, in any locale. Returns none if the text contains
/// anything else or the number is beyond the range of the type.
template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// A decimal number: ± digits · 10^place, where `place` is the exponent of the last digit.
///
/// `digits` has no leading zeros, except that zero is "0"; zero has no sign.
struct Decimal {
  bool negative = false;
  std::string digits = "0";
  int place = 0;
};

/// Parses a decimal number with an optional sign, point and exponent, and keeps all digits:
/// "-1.50e3" is −150 · 10^1. Returns none for any other text.
std::optional<Decimal> parse_decimal(std::string_view text);

/// The fewest digits that identify a finite double, without trailing zeros.
Decimal shortest(double number);

/// The double nearest to a decimal number; infinity beyond the range of doubles.
double number_of(const Decimal& number);

}  // namespace sys
