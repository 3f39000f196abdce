// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/found.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "literate/values/decimal.hpp"

namespace literate {
namespace {

using numerics::Estimate;

constexpr int digits_of_double = 17;

Format with_digits(Notation notation, int n_digits, bool is_percentage) {
  const Format format = notation == Notation::fixed        ? fixed(n_digits)
                        : notation == Notation::scientific ? scientific(n_digits)
                                                           : significant(n_digits);
  return is_percentage ? format.in_percent() : format;
}

/// The number that a reader reads.
double as_printed(const Value& value) {
  if (!value.format()->rounds_up()) {
    return number_of(rounded_to_place(*value.number(), value.last_place()));
  }
  const double bound = *value.number() + value.abs_error().value_or(0);
  return number_of(rounded_up_to_place(bound, value.last_place()));
}

bool is_allowed(double number, double limit, Side side) {
  return side == Side::at_most ? number <= limit : number >= limit;
}

/// A number without an error in the notation of the quantity: significant digits, or a percentage
/// of them that is not mostly zeros.
Value like(const Value& quantity, double number, int n_digits) {
  if (quantity.is_percentage()) {
    constexpr double least_plain = 1e-6;
    const Format format =
        std::abs(number) < least_plain ? scientific(n_digits) : significant(n_digits);
    return {number, format.in_percent()};
  }
  const bool has_exponent = quantity.format()->notation() == Notation::scientific;
  return {number, has_exponent ? scientific(n_digits) : significant(n_digits), quantity.unit()};
}

/// «at most 3.7e-11» or «at least -3.7e-11»: the end of the quantity's interval that is nearer to
/// the limit, rounded away from the quantity, but not across the limit.
Phrase bound_phrase(const Value& quantity, Estimate estimate, double limit) {
  const bool from_above = estimate.value <= limit;
  const double sign = from_above ? 1 : -1;
  const double magnitude = sign * estimate.value + estimate.abs_error;
  Decimal bound;
  int n_digits = 2;
  for (;; ++n_digits) {
    bound = rounded_up_to_digits(magnitude, n_digits);
    const bool is_beyond = number_of(bound) > sign * limit;
    if (!is_beyond || magnitude > sign * limit || n_digits == digits_of_double) break;
  }
  const Value printed = like(quantity, sign * number_of(bound), n_digits);
  return from_above ? phrase("at most {}", printed) : phrase("at least {}", printed);
}

/// How many significant digits of a number other than zero are printed.
int n_printed_digits(const Value& value) {
  const double magnitude = std::abs(as_printed(value));
  if (magnitude == 0) return 0;
  return static_cast<int>(std::floor(std::log10(magnitude))) - value.last_place() + 1;
}

/// The quantity as it is printed elsewhere if it is rounded up to two digits or more, else to the
/// nearest number with the digits of its format and `n_more` besides.
Value nearest(const Value& quantity, Estimate estimate, int n_more) {
  const Format& format = *quantity.format();
  const Notation notation = format.notation();
  const bool is_percentage = format.is_percentage();
  if (notation != Notation::fixed && notation != Notation::significant &&
      notation != Notation::scientific) {
    return quantity;
  }
  const auto with = [&](Notation wanted, int n_digits) {
    return Value(estimate, with_digits(wanted, n_digits, is_percentage), quantity.unit());
  };
  if (!format.rounds_up()) {
    return n_more == 0 ? quantity : with(notation, format.digits() + n_more);
  }
  constexpr int least_digits = 2;
  if (n_more == 0 && n_printed_digits(quantity) >= least_digits) return quantity;
  if (notation != Notation::fixed) {
    return with(notation, std::max(format.digits(), least_digits) + n_more);
  }
  const Value decimals = with(Notation::fixed, format.digits() + n_more);
  const Value digits = with(Notation::significant, least_digits + n_more);
  return digits.last_place() < decimals.last_place() ? digits : decimals;
}

}  // namespace

Phrase found_phrase(const Value& quantity, double limit, Side side) {
  if (!quantity.number() || !quantity.abs_error()) {
    throw std::invalid_argument("what was found is a number with its error");
  }
  const Estimate estimate{*quantity.number(), *quantity.abs_error()};
  if (std::abs(estimate.value) < estimate.abs_error) {
    return bound_phrase(quantity, estimate, limit);
  }
  const bool is_allowed_itself = is_allowed(estimate.value, limit, side);
  for (int n_more = 0; n_more < digits_of_double; ++n_more) {
    const Value printed = nearest(quantity, estimate, n_more);
    if (is_allowed(as_printed(printed), limit, side) == is_allowed_itself) {
      return phrase("{}", printed);
    }
  }
  const Format format = quantity.is_percentage() ? uncertain().in_percent() : uncertain();
  return phrase("{}", Value(estimate, format, quantity.unit()));
}

}  // namespace literate
