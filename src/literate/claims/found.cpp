// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/found.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "literate/values/rounding.hpp"

namespace literate {
namespace {

constexpr int most_digits = 17;

/// The number as the reader sees it.
double as_printed(const Value& value) {
  return number_of(rounded(value.format(), value.number(), value.known()).decimal);
}

/// The same quantity with more digits than its format has.
Value with_more_digits(const Value& quantity, int n_more) {
  const Format& format = quantity.format();
  const int n_digits = std::min(format.digits() + n_more, most_digits);
  Format longer = format.notation() == Notation::scientific ? scientific(n_digits)
                  : format.notation() == Notation::fixed    ? fixed(format.digits() + n_more)
                                                            : significant(n_digits);
  return quantity.formatted(format.is_percentage() ? longer.in_percent() : longer);
}

Value with_error(const Value& quantity) {
  if (!quantity.known()) return quantity;
  return quantity.formatted(quantity.is_percentage() ? uncertain().in_percent() : uncertain());
}

/// The end of the quantity's interval nearer to the limit, rounded away from the quantity to two
/// digits, or to more if rounding would cross the limit.
Phrase end_phrase(const Value& quantity, double error, double limit) {
  constexpr int n_meant = 12;  // later digits are rounding errors of the sum
  const bool is_below = quantity.number() <= limit;
  const double sign = is_below ? 1 : -1;
  const double end = number_of(rounded_to_digits(sign * quantity.number() + error, n_meant));
  double printed = end;
  for (int n_digits = 2; n_digits <= n_meant; ++n_digits) {
    printed = number_of(rounded_up_to_digits(end, n_digits));
    if (printed <= sign * limit || end > sign * limit) break;
  }
  const Notation notation = quantity.format().notation();
  Format format =
      notation == Notation::scientific || quantity.is_percentage() ? scientific(2) : significant(2);
  // All digits of the end; usually it has two.
  const auto n_digits = static_cast<int>(shortest(printed).digits.size());
  format = format.with_digits(std::max(2, n_digits));
  constexpr double least_plain_ratio = 1e-6;
  if (quantity.is_percentage()) {
    format = (printed < least_plain_ratio ? format : significant(format.digits())).in_percent();
  }
  const Value bound = Value(sign * printed, format, quantity.unit()).as_is();
  return phrase(is_below ? "at most {}" : "at least {}", phrase_of(bound));
}

}  // namespace

Phrase phrase(std::string_view words, const Phrase& first, const Phrase& second,
              const Phrase& third) {
  return {fmt::format(fmt::runtime(words), first.plain, second.plain, third.plain),
          fmt::format(fmt::runtime(words), first.latex, second.latex, third.latex)};
}

Phrase phrase_of(const Value& value) {
  return {value.printed(), value.latex()};
}

Phrase found_phrase(const Value& quantity, double error, double limit, Side side) {
  if (std::abs(quantity.number()) < error) return end_phrase(quantity, error, limit);
  const auto is_allowed = [&](double number) {
    return side == Side::at_most ? number <= limit : number >= limit;
  };
  const bool is_allowed_itself = is_allowed(quantity.number());
  Value printed = quantity;
  for (int n_more = 1; n_more < most_digits; ++n_more) {
    if (is_allowed(as_printed(printed)) == is_allowed_itself) return phrase_of(printed);
    printed = with_more_digits(quantity, n_more);
  }
  return phrase_of(with_error(quantity));
}

Phrase undecided_phrase(const Value& quantity, double error, double limit) {
  if (std::abs(quantity.number()) < error) return end_phrase(quantity, error, limit);
  return phrase_of(with_error(quantity));
}

}  // namespace literate
