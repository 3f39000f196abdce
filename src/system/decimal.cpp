// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/decimal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "system/text.hpp"

namespace sys {
namespace {

bool are_digits(std::string_view text) {
  return std::ranges::all_of(text, is_digit);
}

}  // namespace

std::optional<Decimal> parse_decimal(std::string_view text) {
  Decimal number{.negative = text.starts_with('-')};
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);

  const auto e = text.find_first_of("eE");
  if (e != text.npos) {
    std::string_view exponent = text.substr(e + 1);
    if (exponent.starts_with('+') && !exponent.starts_with("+-")) exponent.remove_prefix(1);
    const auto place = parsed<int>(exponent);
    if (!place) return std::nullopt;
    number.place = *place;
    text = text.substr(0, e);
  }

  const auto point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const std::string_view decimals = point == text.npos ? "" : text.substr(point + 1);
  if (whole.empty() && decimals.empty()) return std::nullopt;
  if (!are_digits(whole) || !are_digits(decimals)) return std::nullopt;

  number.digits = std::string(whole) + std::string(decimals);
  number.place -= static_cast<int>(decimals.size());
  number.digits.erase(0, std::min(number.digits.find_first_not_of('0'), number.digits.size()));
  if (number.digits.empty()) return Decimal{.place = number.place};
  return number;
}

Decimal shortest(double number) {
  Decimal decimal = parse_decimal(fmt::format("{}", number)).value();
  for (; decimal.digits.size() > 1 && decimal.digits.back() == '0'; ++decimal.place) {
    decimal.digits.pop_back();
  }
  return decimal;
}

double number_of(const Decimal& number) {
  const std::string text =
      fmt::format("{}{}e{}", number.negative ? "-" : "", number.digits, number.place);
  // std::from_chars reports the same error for too small and too large numbers.
  if (const auto value = parsed<double>(text)) return *value;
  const bool is_tiny = number.place + static_cast<int>(number.digits.size()) < 0;
  const double magnitude = is_tiny ? 0 : std::numeric_limits<double>::infinity();
  return number.negative ? -magnitude : magnitude;
}

}  // namespace sys
