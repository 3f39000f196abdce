// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/decimal.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace literate {
namespace {

using Buffer = std::array<char, 1500>;  // a double has at most 309 digits before the point

Decimal converted(double value, std::chars_format format, int precision) {
  Buffer buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  Decimal decimal = sys::parse_decimal({buffer.data(), end.ptr}).value();
  if (is_zero(decimal)) decimal.negative = false;
  return decimal;
}

/// Steps away from zero by one unit of the last place.
void increment(Decimal& number) {
  auto digit = number.digits.rbegin();
  for (; digit != number.digits.rend() && *digit == '9'; ++digit) *digit = '0';
  if (digit == number.digits.rend()) {
    number.digits.insert(0, 1, '1');
  } else {
    ++*digit;
  }
}

}  // namespace

Decimal rounded_to_place(double value, int place) {
  if (place <= 0) return converted(value, std::chars_format::fixed, -place);
  constexpr int n_all = 17;
  const int n_digits = leading_place(rounded_to_digits(value, n_all)) - place + 1;
  if (n_digits >= 1) {
    Decimal number = rounded_to_digits(value, n_digits);
    if (number.place > place) number.digits += '0';  // 96 to tens is 10·10
    number.place = place;
    return number;
  }
  const double half = number_of({.negative = false, .digits = "5", .place = place - 1});
  if (std::abs(value) > half) return {.negative = value < 0, .digits = "1", .place = place};
  return {.place = place};
}

Decimal rounded_to_digits(double value, int n_digits) {
  if (value == 0) return {};
  return converted(value, std::chars_format::scientific, n_digits - 1);
}

Decimal rounded_up_to_place(double value, int place) {
  Decimal number = rounded_to_place(value, place);
  if (number_of(number) < value) increment(number);
  return number;
}

Decimal rounded_up_to_digits(double value, int n_digits) {
  const Decimal up = rounded_up_to_place(value, rounded_to_digits(value, n_digits).place);
  // Rounding 9.3 up to 10 yields one digit too many.
  const bool is_longer = up.digits.size() > static_cast<std::size_t>(n_digits);
  return is_longer ? rounded_to_digits(number_of(up), n_digits) : up;
}

bool is_zero(const Decimal& number) {
  return number.digits == "0";
}

int leading_place(const Decimal& number) {
  return number.place + static_cast<int>(number.digits.size()) - 1;
}

double decimal_difference(double a, double b) {
  // Rounded to the last place of both, the difference of the doubles is that of the decimals. If
  // the doubles do not resolve this place, the difference is left unrounded.
  const int place = std::min(shortest(a).place, shortest(b).place);
  const double difference = a - b;
  const double largest = std::max(std::abs(a), std::abs(b));
  const bool is_resolved =
      std::pow(10, place) > 4 * std::numeric_limits<double>::epsilon() * largest;
  return is_resolved ? number_of(rounded_to_place(difference, place)) : difference;
}

double error_of_sum(double a, double b) {
  const double sum = a + b;
  const double from_b = sum - a;
  return (a - (sum - from_b)) + (b - from_b);
}

namespace {

double next_up(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

}  // namespace

double add_up(double a, double b) {
  return error_of_sum(a, b) > 0 ? next_up(a + b) : a + b;
}

double multiply_up(double a, double b) {
  const double product = a * b;
  return std::fma(a, b, -product) > 0 ? next_up(product) : product;
}

std::string plain(const Decimal& number) {
  std::string text = number.digits;
  if (number.place > 0 && !is_zero(number)) {
    text.append(static_cast<std::size_t>(number.place), '0');
  } else if (number.place < 0) {
    const int n_missing = 1 - number.place - static_cast<int>(text.size());
    if (n_missing > 0) text.insert(0, static_cast<std::size_t>(n_missing), '0');
    text.insert(text.end() + number.place, '.');
  }
  return number.negative ? "-" + text : text;
}

std::string round_trip(double value) {
  Buffer buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end.ptr};
}

}  // namespace literate
