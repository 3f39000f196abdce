// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/found.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// The quantity with its bound and k standard uncertainties.
Estimate counted(const Value& quantity, double k) {
  return {*quantity.number(), Uncertainty(quantity.measured().value()).error(k)};
}

/// The number that a reader reads.
double as_printed(const Value& value) {
  if (!value.format()->rounds_up()) {
    return number_of(rounded_to_place(*value.number(), value.last_place()));
  }
  const double bound = *value.number() + value.measured().value_or(0).bounded().abs_error;
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

/// A number as it is printed, and the interval in which a reader takes it to be.
struct Printed {
  Phrase phrase;
  double least, most;
};

/// Without what binary numbers add to decimal ones: 0.15 for 0.75 - 0.6.
double decimal(double number) {
  constexpr int n_digits = 12;
  return number_of(rounded_to_digits(number, n_digits));
}

Printed rounded_print(const Value& value) {
  const double half_unit = 0.5 * std::pow(10, value.last_place());
  const double number = as_printed(value);
  return {phrase("{}", value), decimal(number - half_unit), decimal(number + half_unit)};
}

/// «at most 3.7e-11» or «at least -3.7e-11»: the end of the quantity's interval that is nearer to
/// the limit, rounded away from the quantity, but not across the limit.
Printed bound_print(const Value& quantity, Estimate estimate, double limit) {
  const bool from_above = estimate.value <= limit;
  const double sign = from_above ? 1 : -1;
  const double magnitude = decimal(sign * estimate.value + estimate.abs_error);
  Decimal bound;
  int n_digits = 2;
  for (;; ++n_digits) {
    bound = rounded_up_to_digits(magnitude, n_digits);
    const bool is_beyond = number_of(bound) > sign * limit;
    if (!is_beyond || magnitude > sign * limit || n_digits == digits_of_double) break;
  }
  const Value printed = like(quantity, sign * number_of(bound), n_digits);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return from_above ? Printed{phrase("at most {}", printed), -infinite, *printed.number()}
                    : Printed{phrase("at least {}", printed), *printed.number(), infinite};
}

/// How many significant digits of a number other than zero are printed.
int n_printed_digits(const Value& value) {
  const double magnitude = std::abs(as_printed(value));
  if (magnitude == 0) return 0;
  return static_cast<int>(std::floor(std::log10(magnitude))) - value.last_place() + 1;
}

/// The quantity as it is printed elsewhere if it is rounded up to two digits or more, else to the
/// nearest number with the digits of its format and `n_more` besides.
Value nearest(const Value& quantity, int n_more) {
  const Format& format = *quantity.format();
  const Notation notation = format.notation();
  const bool is_percentage = format.is_percentage();
  if (notation != Notation::fixed && notation != Notation::significant &&
      notation != Notation::scientific) {
    return quantity;
  }
  const auto with = [&](Notation wanted, int n_digits) {
    return Value(quantity.measured().value(), with_digits(wanted, n_digits, is_percentage),
                 quantity.unit());
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

/// The quantity with its error behind it.
Value with_error(const Value& quantity) {
  if (counted(quantity, 1).abs_error == 0) return quantity;
  return {quantity.measured().value(),
          quantity.is_percentage() ? uncertain().in_percent() : uncertain(), quantity.unit()};
}

Printed found_print(const Value& quantity, double limit, Side side, double k) {
  if (!quantity.measured()) {
    throw std::invalid_argument("what was found is a number with its error");
  }
  const Estimate estimate = counted(quantity, k);
  if (std::abs(estimate.value) < estimate.abs_error) return bound_print(quantity, estimate, limit);
  const bool is_allowed_itself = is_allowed(estimate.value, limit, side);
  for (int n_more = 0; n_more < digits_of_double; ++n_more) {
    const Value printed = nearest(quantity, n_more);
    if (is_allowed(as_printed(printed), limit, side) == is_allowed_itself) {
      return rounded_print(printed);
    }
  }
  return rounded_print(with_error(quantity));
}

/// How far apart two printed numbers are.
double distance_of(const Value& computed, const Value& stated, Distance distance) {
  const double from = as_printed(computed), to = as_printed(stated);
  if (distance == Distance::relative) return decimal(std::abs(from / to - 1));
  const int place = std::min(computed.last_place(), stated.last_place());
  return number_of(rounded_to_place(std::abs(from - to), place));
}

}  // namespace

Phrase found_phrase(const Value& quantity, double limit, Side side, double k) {
  return found_print(quantity, limit, side, k).phrase;
}

Phrase undecided_phrase(const Value& quantity, double limit, Side side, double k) {
  const bool is_lost = std::abs(*quantity.number()) < counted(quantity, k).abs_error;
  return is_lost ? found_phrase(quantity, limit, side, k) : phrase("{}", with_error(quantity));
}

Phrase apart_phrase(const Value& computed, const Value& stated, const Value& difference,
                    double limit, Side side, Distance distance, double k) {
  const bool is_allowed_itself = is_allowed(*difference.number(), limit, side);
  // Where a difference is less than its error, a reader is told how far it may be from nothing.
  const bool is_lost = *difference.number() < counted(difference, k).abs_error;
  const bool is_beyond = is_lost && *difference.number() > limit;
  const Printed apart =
      found_print(difference, is_beyond ? std::numeric_limits<double>::infinity() : limit, side, k);
  const auto sentence = [&](const Value& from, const Value& to, const Printed& by) {
    const bool is_told = distance == Distance::absolute || difference.is_percentage();
    if (is_told) return phrase("{}, {} from {}", from, by.phrase, to);
    return phrase("{} against {}, relative difference {}", from, to, by.phrase);
  };
  const auto reads_true = [&](const Value& from, const Value& to) {
    const double seen = distance_of(from, to, distance);
    if (is_allowed(seen, limit, side) != is_allowed_itself && !is_lost) return false;
    return (seen == 0 && side == Side::at_most) ||
           (apart.least < seen && (seen < apart.most || (is_lost && seen <= apart.most)));
  };
  if (reads_true(computed, stated)) return sentence(computed, stated, apart);
  for (int n_more = 1; n_more < digits_of_double; ++n_more) {
    const Value from = nearest(computed, n_more);
    if (reads_true(from, stated)) return sentence(from, stated, apart);
    const Value to = nearest(stated, n_more);
    if (reads_true(from, to)) return sentence(from, to, apart);
  }
  // What has no error gets as many digits as the difference has.
  const Value by = with_error(difference);
  const auto beside = [&](const Value& value) {
    Value printed = with_error(value);
    const bool is_exact = counted(value, k).abs_error == 0;
    for (int n_more = 1; n_more < digits_of_double && is_exact; ++n_more) {
      if (printed.last_place() <= by.last_place()) break;
      printed = nearest(value, n_more);
    }
    return printed;
  };
  return sentence(beside(computed), beside(stated), is_lost ? apart : rounded_print(by));
}

}  // namespace literate
