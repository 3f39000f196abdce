// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/value.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "literate/decimal.hpp"
#include "literate/latex.hpp"

namespace literate {
namespace {

void require_decimals(int decimals) {
  if (decimals < 0 || decimals > 100) {
    throw std::invalid_argument(fmt::format("decimals = {}: must lie between 0 and 100", decimals));
  }
}

/// The place p of the last digit that an error bound > 0 supports: 10^p ≥ 2·abs_error.
int supported_place(double abs_error) {
  const Decimal twice = shortest(2 * abs_error);
  return leading_place(twice) + (twice.digits == "1" ? 0 : 1);
}

/// Rounds to the digits that the error supports, and to no more than `max_digits` of them.
Decimal supported_digits(numerics::Estimate estimate, int max_digits) {
  const Decimal longest = rounded_to_digits(estimate.value, max_digits);
  if (estimate.abs_error == 0) {
    const Decimal exact = shortest(estimate.value);
    return exact.place >= longest.place ? exact : longest;
  }
  const int place = supported_place(estimate.abs_error);
  if (is_zero(longest)) return rounded_to_place(0, place);
  const int lowest_place = leading_place(longest) - max_digits + 1;
  return rounded_to_place(estimate.value, std::max(place, lowest_place));
}

void require_error_bound(double abs_error) {
  if (std::isfinite(abs_error) && abs_error >= 0) return;
  throw std::invalid_argument("an error bound to be printed is negative or not finite");
}

void require_not_negative(double number) {
  if (number < 0) throw std::invalid_argument("a bound to be printed is negative");
}

}  // namespace

Value Value::quantity(double number, const std::string& digits, std::string_view unit) {
  require_unit(unit);
  Value value;
  value.latex_ = unit.empty() ? fmt::format("\\num{{{}}}", digits)
                              : fmt::format("\\qty{{{}}}{{{}}}", digits, unit);
  value.printed_ = unit.empty() ? digits : fmt::format("{} {}", digits, unit);
  value.number_ = number;
  value.unit_ = unit;
  return value;
}

Value Value::integer(std::int64_t number, std::string_view unit) {
  return quantity(static_cast<double>(number), fmt::format("{}", number), unit);
}

Value Value::significant(double number, int n_digits, std::string_view unit) {
  return quantity(number, plain_or_scientific(rounded_to_digits(number, n_digits)), unit);
}

Value Value::fixed(double number, int decimals, std::string_view unit) {
  require_decimals(decimals);
  return quantity(number, plain(rounded_to_place(number, -decimals)), unit);
}

Value Value::scientific(double number, int n_digits, std::string_view unit) {
  return quantity(number, literate::scientific(rounded_to_digits(number, n_digits)), unit);
}

Value Value::estimate(numerics::Estimate estimate, std::string_view unit, int max_digits) {
  require_error_bound(estimate.abs_error);
  const Decimal number = supported_digits(estimate, max_digits);
  // Zeros to the left of the point would claim digits that are not known.
  const bool pads_zeros = number.place > 0 && estimate.abs_error > 0;
  Value value =
      quantity(estimate.value,
               pads_zeros ? literate::scientific(number) : plain_or_scientific(number), unit);
  value.abs_error_ = estimate.abs_error;
  return value;
}

Value Value::with_uncertainty(numerics::Estimate estimate, std::string_view unit) {
  require_error_bound(estimate.abs_error);
  if (estimate.abs_error == 0) return exact(estimate.value, unit);
  const Decimal error = rounded_up_to_digits(estimate.abs_error, 2);
  const Decimal number = rounded_to_place(estimate.value, error.place);
  std::string digits =
      number.place > 0 ? literate::scientific(number) : plain_or_scientific(number);
  digits.insert(std::min(digits.find('e'), digits.size()), fmt::format("({})", error.digits));
  Value value = quantity(estimate.value, digits, unit);
  value.abs_error_ = estimate.abs_error;
  return value;
}

Value Value::percent(double ratio, int decimals) {
  require_decimals(decimals);
  return percentage(ratio, rounded_to_place(ratio, -decimals - 2));
}

Value Value::percent_bound(double ratio, int decimals) {
  require_decimals(decimals);
  require_not_negative(ratio);
  return percentage(ratio, rounded_up_to_place(ratio, -decimals - 2));
}

Value Value::scientific_bound(double number, int n_digits, std::string_view unit) {
  require_not_negative(number);
  return quantity(number, literate::scientific(rounded_up_to_digits(number, n_digits)), unit);
}

Value Value::percentage(double ratio, Decimal rounded) {
  // Multiplying by 100 would round twice; moving the point does not.
  rounded.place += 2;
  Value value = quantity(ratio, plain(rounded), "");
  value.latex_ = fmt::format("\\qty{{{}}}{{\\percent}}", plain(rounded));
  value.printed_ += " %";
  return value;
}

Value Value::exact(double number, std::string_view unit) {
  return quantity(number, plain_or_scientific(shortest(number)), unit);
}

Value Value::text(std::string_view text) {
  Value value;
  value.latex_ = escape_latex(text);
  value.printed_ = text;
  return value;
}

}  // namespace literate
