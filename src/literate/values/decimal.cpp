// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/decimal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace literate {
namespace {

// A double has up to 309 digits before the point and 1074 after it.
using Buffer = std::array<char, 1500>;

void require_number(double value) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument("a number to be printed is not finite");
  }
}

std::string signed_text(const Decimal& number, const std::string& magnitude) {
  return fmt::format("{}{}", number.negative ? "-" : "", magnitude);
}

int size_of(const std::string& text) {
  return static_cast<int>(text.size());
}

Decimal converted(double value, std::chars_format format, int precision) {
  Buffer buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  if (end.ec != std::errc{}) throw std::invalid_argument("too many digits asked for");
  return sys::parse_decimal({buffer.data(), end.ptr}).value();
}

/// Rounds to a place left of the point, where std::to_chars has no fixed form.
Decimal rounded_to_high_place(double value, int place) {
  const int leading = leading_place(converted(value, std::chars_format::scientific, 17));
  const int n_digits = leading - place + 1;
  Decimal number{std::signbit(value), "0", place};
  if (n_digits >= 1) {
    number = converted(value, std::chars_format::scientific, n_digits - 1);
    // If rounding carried into a new digit, the last place is one too high.
    number.digits.append(static_cast<std::size_t>(number.place - place), '0');
    number.place = place;
  } else if (n_digits == 0 && std::abs(value) > 5 * std::pow(10, leading)) {
    number.digits.assign(1, '1');
  }
  if (is_zero(number)) number.negative = false;
  return number;
}

}  // namespace

Decimal rounded_to_place(double value, int place) {
  require_number(value);
  return place > 0 ? rounded_to_high_place(value, place)
                   : converted(value, std::chars_format::fixed, -place);
}

Decimal rounded_to_digits(double value, int n_digits) {
  require_number(value);
  if (n_digits < 1 || n_digits > 100) {
    throw std::invalid_argument("significant digits must lie between 1 and 100");
  }
  if (value == 0) return {};
  return converted(value, std::chars_format::scientific, n_digits - 1);
}

Decimal rounded_up_to_place(double value, int place) {
  const Decimal nearest = rounded_to_place(value, place);
  const double number = number_of(nearest);
  return number >= value ? nearest : rounded_to_place(number + std::pow(10, place), place);
}

Decimal rounded_up_to_digits(double value, int n_digits) {
  const Decimal up = rounded_up_to_place(value, rounded_to_digits(value, n_digits).place);
  // Rounding 9.3 up to 10 gives a digit too many.
  return size_of(up.digits) > n_digits ? rounded_to_digits(number_of(up), n_digits) : up;
}

Decimal shortest(double value) {
  require_number(value);
  return sys::shortest(value);
}

namespace {

using Integer = boost::multiprecision::cpp_int;

Integer power_of_ten(int exponent) {
  return boost::multiprecision::pow(Integer(10), static_cast<unsigned>(exponent));
}

/// The number in units of 10^place, which is not above the place of its last digit.
Integer in_units_of(const Decimal& number, int place) {
  const Integer magnitude = Integer(number.digits) * power_of_ten(number.place - place);
  return number.negative ? Integer(-magnitude) : magnitude;
}

/// The double nearest to the number of units of 10^place.
double number_of_units(const Integer& units, int place) {
  return number_of({.negative = units < 0, .digits = Integer(abs(units)).str(), .place = place});
}

}  // namespace

double decimal_difference(double a, double b) {
  const Decimal from = shortest(a), what = shortest(b);
  const int place = std::min(from.place, what.place);
  return number_of_units(in_units_of(from, place) - in_units_of(what, place), place);
}

double decimal_relative_difference(double a, double b) {
  const Decimal over = shortest(a), under = shortest(b);
  const int place = std::min(over.place, under.place);
  const Integer below = in_units_of(under, place);
  const Integer above = in_units_of(over, place) - below;
  // With so many digits behind the point the quotient is rounded as its double is.
  const int n_digits =
      40 + std::max(0, static_cast<int>(below.str().size()) - static_cast<int>(above.str().size()));
  return number_of_units(above * power_of_ten(n_digits) / below, -n_digits);
}

void require_held(const std::string& not_held, std::string_view text) {
  if (not_held.empty()) return;
  throw std::invalid_argument(
      fmt::format("{0} is beyond 2^53, where a number does not hold each integer: "
                  "{1}(\"{0}\") prints it",
                  not_held, text));
}

bool is_zero(const Decimal& number) {
  return number.digits == "0";
}

int leading_place(const Decimal& number) {
  return number.place + size_of(number.digits) - 1;
}

std::string plain(const Decimal& number) {
  std::string text = number.digits;
  if (number.place > 0 && !is_zero(number)) {
    text.append(static_cast<std::size_t>(number.place), '0');
  } else if (number.place < 0) {
    const int n_missing = 1 - number.place - size_of(text);
    if (n_missing > 0) text.insert(0, static_cast<std::size_t>(n_missing), '0');
    text.insert(text.end() + number.place, '.');
  }
  return signed_text(number, text);
}

std::string scientific(const Decimal& number) {
  if (is_zero(number) && number.place == 0) return number.digits;
  std::string text = number.digits;
  if (text.size() > 1) text.insert(1, 1, '.');
  text += fmt::format("e{}", leading_place(number));
  return signed_text(number, text);
}

std::string plain_or_scientific(const Decimal& number) {
  const int leading = leading_place(number);
  const bool is_plain =
      is_zero(number) ? number.place >= -6 && number.place <= 0 : leading >= -3 && leading < 6;
  return is_plain ? plain(number) : scientific(number);
}

std::string round_trip(double value) {
  if (std::isnan(value)) return "nan";
  Buffer buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end.ptr};
}

std::string bare_digits(double value) {
  require_number(value);
  Buffer buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
  return {buffer.data(), end.ptr};
}

}  // namespace literate
