// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/value.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"

namespace literate {
namespace {

void require_decimals(int decimals) {
  if (decimals < 0 || decimals > 100) {
    throw std::invalid_argument(fmt::format("decimals = {}: must lie between 0 and 100", decimals));
  }
}

/// The least place p with 10^p ≥ error > 0.
int place_of(const Decimal& error) {
  return leading_place(error) + (error.digits == "1" ? 0 : 1);
}

/// The place p of the last digit that an error bound > 0 supports: 10^p ≥ 2·abs_error.
int supported_place(double abs_error) {
  return place_of(shortest(2 * abs_error));
}

/// Rounds to the digits that the error supports, at most `max_digits`.
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

/// The lowest place that is neither below `lowest` nor below the error.
int earned_place(double abs_error, int lowest) {
  return abs_error > 0 ? std::max(lowest, place_of(shortest(abs_error))) : lowest;
}

/// Rounds to the earned place.
Decimal earned_digits(numerics::Estimate estimate, int lowest) {
  return rounded_to_place(estimate.value, earned_place(estimate.abs_error, lowest));
}

/// Rounds the sum of number and error up to the earned place.
Decimal earned_bound(numerics::Estimate estimate, int lowest) {
  return rounded_up_to_place(estimate.value + estimate.abs_error,
                             earned_place(estimate.abs_error, lowest));
}

/// The place of the last of `max_digits` digits of the number, or of its error if the number is
/// zero.
int lowest_place(numerics::Estimate estimate, int max_digits) {
  const double leading = estimate.value == 0 ? estimate.abs_error : estimate.value;
  return rounded_to_digits(leading, max_digits).place;
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

Value Value::at_place(int place) const {
  Value value = *this;
  value.place_ = place;
  return value;
}

Value Value::with_error(double abs_error) const {
  Value value = *this;
  value.abs_error_ = abs_error;
  return value;
}

Value Value::within(double abs_error) const {
  require_error_bound(abs_error);
  if (!number_ || abs_error_) {
    throw std::invalid_argument(fmt::format(
        "'{}' {}", printed_,
        number_ ? "has an error bound already" : "is text and can have no error bound"));
  }
  if (std::pow(10.0, place_) < abs_error) {
    throw std::invalid_argument(
        fmt::format("{} is printed as '{}', more digits than an error of {} supports", *number_,
                    printed_, abs_error));
  }
  return with_error(abs_error);
}

Value Value::integer(std::int64_t number, std::string_view unit) {
  return quantity(static_cast<double>(number), fmt::format("{}", number), unit);
}

Value Value::significant(double number, int n_digits, std::string_view unit) {
  const Decimal rounded = rounded_to_digits(number, n_digits);
  return quantity(number, plain_or_scientific(rounded), unit).at_place(rounded.place);
}

Value Value::fixed(double number, int decimals, std::string_view unit) {
  require_decimals(decimals);
  return quantity(number, plain(rounded_to_place(number, -decimals)), unit).at_place(-decimals);
}

Value Value::scientific(double number, int n_digits, std::string_view unit) {
  const Decimal rounded = rounded_to_digits(number, n_digits);
  return quantity(number, literate::scientific(rounded), unit).at_place(rounded.place);
}

// Without an exponent, zeros to the left of the point would claim digits that are not known.
Value Value::plain_or_padded(numerics::Estimate estimate, const Decimal& rounded,
                             std::string_view unit) {
  const bool pads_zeros = rounded.place > 0 && estimate.abs_error > 0;
  return quantity(estimate.value,
                  pads_zeros ? literate::scientific(rounded) : plain_or_scientific(rounded), unit)
      .at_place(rounded.place)
      .with_error(estimate.abs_error);
}

Value Value::significant(numerics::Estimate estimate, int max_digits, std::string_view unit) {
  require_error_bound(estimate.abs_error);
  return plain_or_padded(estimate, earned_digits(estimate, lowest_place(estimate, max_digits)),
                         unit);
}

Value Value::fixed(numerics::Estimate estimate, int max_decimals, std::string_view unit) {
  require_error_bound(estimate.abs_error);
  require_decimals(max_decimals);
  const Decimal rounded = earned_digits(estimate, -max_decimals);
  if (rounded.place > 0) return plain_or_padded(estimate, rounded, unit);
  return fixed(estimate.value, -rounded.place, unit).with_error(estimate.abs_error);
}

Value Value::scientific(numerics::Estimate estimate, int max_digits, std::string_view unit) {
  require_error_bound(estimate.abs_error);
  const Decimal rounded = earned_digits(estimate, lowest_place(estimate, max_digits));
  return quantity(estimate.value, literate::scientific(rounded), unit)
      .at_place(rounded.place)
      .with_error(estimate.abs_error);
}

Value Value::percent(numerics::Estimate ratio, int max_decimals) {
  require_error_bound(ratio.abs_error);
  require_decimals(max_decimals);
  return percentage(ratio.value, earned_digits(ratio, -max_decimals - 2))
      .with_error(ratio.abs_error);
}

Value Value::estimate(numerics::Estimate estimate, std::string_view unit, int max_digits) {
  require_error_bound(estimate.abs_error);
  return plain_or_padded(estimate, supported_digits(estimate, max_digits), unit);
}

Value Value::with_uncertainty(numerics::Estimate estimate, std::string_view unit) {
  require_error_bound(estimate.abs_error);
  if (estimate.abs_error == 0) return exact(estimate.value, unit);
  const Decimal error = rounded_up_to_digits(estimate.abs_error, 2);
  const Decimal number = rounded_to_place(estimate.value, error.place);
  std::string digits =
      number.place > 0 ? literate::scientific(number) : plain_or_scientific(number);
  digits.insert(std::min(digits.find('e'), digits.size()), fmt::format("({})", error.digits));
  return quantity(estimate.value, digits, unit)
      .at_place(error.place)
      .with_error(estimate.abs_error);
}

Value Value::percent(double ratio, int decimals) {
  require_decimals(decimals);
  return percentage(ratio, rounded_to_place(ratio, -decimals - 2));
}

Value Value::exact_percent(double ratio) {
  Decimal digits = shortest(ratio);
  // All zeros of an exact number are known: 100 %, not 1e2 %.
  for (; digits.place > -2 && !is_zero(digits); --digits.place) digits.digits += '0';
  return percentage(ratio, digits);
}

Value Value::percent_significant(numerics::Estimate ratio, int max_digits) {
  require_error_bound(ratio.abs_error);
  return percentage(ratio.value, earned_digits(ratio, lowest_place(ratio, max_digits)))
      .with_error(ratio.abs_error);
}

Value Value::percent_bound(double ratio, int decimals) {
  require_decimals(decimals);
  require_not_negative(ratio);
  return percentage(ratio, rounded_up_to_place(ratio, -decimals - 2));
}

Value Value::scientific_bound(double number, int n_digits, std::string_view unit) {
  require_not_negative(number);
  const Decimal rounded = rounded_up_to_digits(number, n_digits);
  return quantity(number, literate::scientific(rounded), unit).at_place(rounded.place);
}

Value Value::scientific_bound(numerics::Estimate estimate, int n_digits, std::string_view unit) {
  require_error_bound(estimate.abs_error);
  const double bound = estimate.value + estimate.abs_error;
  require_not_negative(bound);
  const Decimal rounded = earned_bound(estimate, rounded_up_to_digits(bound, n_digits).place);
  return quantity(estimate.value, literate::scientific(rounded), unit)
      .at_place(rounded.place)
      .with_error(estimate.abs_error);
}

Value Value::percent_bound(numerics::Estimate ratio, int decimals) {
  require_error_bound(ratio.abs_error);
  require_decimals(decimals);
  require_not_negative(ratio.value + ratio.abs_error);
  return percentage(ratio.value, earned_bound(ratio, -decimals - 2)).with_error(ratio.abs_error);
}

Value Value::percentage(double ratio, Decimal rounded) {
  // Multiplying by 100 would round twice; moving the point does not.
  const int place = rounded.place;
  rounded.place += 2;
  const bool pads_zeros = rounded.place > 0;
  const std::string digits = pads_zeros ? literate::scientific(rounded) : plain(rounded);
  Value value = quantity(ratio, digits, "").at_place(place);
  value.latex_ = fmt::format("\\qty{{{}}}{{\\percent}}", digits);
  value.printed_ += " %";
  value.is_percentage_ = true;
  return value;
}

Value Value::exact(double number, std::string_view unit) {
  const Decimal digits = shortest(number);
  return quantity(number, plain_or_scientific(digits), unit).at_place(digits.place);
}

Value Value::text(std::string_view text) {
  Value value;
  value.latex_ = escape_latex(text);
  value.printed_ = text;
  return value;
}

}  // namespace literate
