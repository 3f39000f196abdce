// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/rounding.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace literate {

namespace {

constexpr int n_digits_of_error = 2;

/// The error that decides on digits: rounded to twelve significant digits, since later ones are
/// rounding errors of the error itself. As doubles, 0.1 + 0.05 is 0.15000000000000002.
double counted(double error) {
  constexpr int n_digits = 12;
  return number_of(rounded_to_digits(error, n_digits));
}

/// The least place p with 10^p ≥ bound > 0.
int place_of_bound(double bound) {
  const Decimal digits = shortest(counted(bound));
  return leading_place(digits) + (digits.digits == "1" ? 0 : 1);
}

/// The lowest place whose digit is earned; none for an exact number, which has earned all.
std::optional<int> earned_place(const std::optional<Number>& number) {
  if (!number || number->is_exact()) return std::nullopt;
  int place = std::numeric_limits<int>::min();
  if (number->bound > 0) place = std::max(place, place_of_bound(number->bound));
  if (number->standard > 0) {
    place = std::max(place, leading_place(shortest(counted(number->standard))));
  }
  return place;
}

void require_error(std::string_view what, double error) {
  if (std::isfinite(error) && error >= 0) return;
  throw std::invalid_argument(
      fmt::format("the {} {} is not finite or below zero", what, round_trip(error)));
}

void require_count(std::string_view what, int count, int least, int most) {
  if (count >= least && count <= most) return;
  throw std::invalid_argument(fmt::format("{} {}: there are {} to {}", count, what, least, most));
}

void require_printable(const Format& format, double value, const std::optional<Number>& number) {
  constexpr int most_significant = 17, most_decimals = 100;
  if (!std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("{} is not finite", round_trip(value)));
  }
  if (number) {
    require_error("bound", number->bound);
    require_error("standard uncertainty", number->standard);
  }
  const Notation notation = format.notation();
  if (notation == Notation::fixed) {
    require_count("decimals", format.digits(), 0, most_decimals);
  } else if (has_digits(notation)) {
    require_count("significant digits", format.digits(), 1, most_significant);
  }
  if (!format.rounds_up()) return;
  if (!has_digits(notation)) {
    throw std::invalid_argument(fmt::format("{}() cannot round up", name_of(notation)));
  }
  if (number && number->standard > 0) {
    throw std::invalid_argument(fmt::format(
        "{} has a standard uncertainty of {}, which is not a bound that could be rounded up",
        round_trip(value), round_trip(number->standard)));
  }
}

/// A number rounded to a place, before the choice of its notation.
struct Rounding {
  enum class Style { plain, automatic, with_exponent };

  Decimal decimal;
  Style style = Style::automatic;
  bool are_zeros_known = false;  ///< those that fill the places up to the point
  std::string standard = {};
  std::optional<Decimal> bound = {};
};
using Style = Rounding::Style;

/// The printed form: the number divided by 10^ones, with a power of ten if it needs one.
RoundedNumber written(const Rounding& rounding, int ones) {
  // Outside of these leading places a power of ten is easier to read than the zeros.
  constexpr int least_plain = -3, most_plain = 5;
  Decimal shifted = rounding.decimal;
  shifted.place -= ones;
  const bool is_nothing = is_zero(shifted);
  if (is_nothing && rounding.are_zeros_known) shifted.place = std::min(shifted.place, 0);

  // If the number is zero, its error has the leading digit.
  int leading = leading_place(shifted);
  if (is_nothing && rounding.bound) leading = leading_place(*rounding.bound) - ones;
  const bool has_error = rounding.bound || !rounding.standard.empty();
  const bool is_out_of_range =
      (!is_nothing || has_error) && (leading < least_plain || leading > most_plain);
  const bool has_exponent = (rounding.style == Style::with_exponent && !is_nothing) ||
                            (rounding.style == Style::automatic && is_out_of_range) ||
                            (shifted.place > 0 && !rounding.are_zeros_known);
  const int exponent = has_exponent ? leading : 0;
  const auto digits_of = [&](Decimal number) {
    number.place -= exponent;
    return plain(number);
  };
  RoundedNumber result{
      .decimal = rounding.decimal, .digits = digits_of(shifted), .standard = rounding.standard};
  if (exponent != 0) result.exponent = exponent;
  if (rounding.bound) {
    Decimal bound = *rounding.bound;
    bound.place -= ones;
    result.bound = digits_of(bound);
  }
  return result;
}

/// The digits of an exact number at a place and above, with zeros down to it. Lower digits are
/// rounded away.
Rounding exact_to_place(double value, int place, Style style) {
  Decimal digits = shortest(value);
  if (digits.place < place) digits = rounded_to_place(value, place);
  const bool is_whole = number_of(digits) == value;
  if (!is_zero(digits) && digits.place > place) {
    digits.digits.append(static_cast<std::size_t>(digits.place - place), '0');
  }
  if (is_zero(digits) || digits.place > place) digits.place = place;
  return {digits, style, is_whole};
}

/// value ± a two-digit bound that includes the rounding of the printed number.
Rounding with_bound(double value, double error) {
  for (int place = rounded_up_to_digits(counted(error), n_digits_of_error).place;; ++place) {
    const Decimal digits = rounded_to_place(value, place);
    const double from_printed = add_up(error, std::abs(value - number_of(digits)));
    const Decimal bound = rounded_up_to_place(counted(from_printed), place);
    if (bound.digits.size() <= n_digits_of_error)
      return {digits, Style::automatic, false, "", bound};
  }
}

/// The output of uncertain() for a number that is not exact.
Rounding with_uncertainty(const Number& number) {
  if (number.standard == 0) return with_bound(number.value, number.bound);
  int place = rounded_to_digits(number.standard, n_digits_of_error).place;
  if (number.bound > 0) {
    // Beside a much greater bound, digits below its third one carry no information.
    place = std::max(place, rounded_to_digits(number.bound, n_digits_of_error).place - 1);
  }
  const Decimal standard = rounded_to_place(number.standard, place);
  if (is_zero(standard)) return with_bound(number.value, number.bound);

  Rounding result{rounded_to_place(number.value, place), Style::automatic, false, standard.digits};
  const double half_unit = number_of({.negative = false, .digits = "5", .place = place - 1});
  if (number.bound >= half_unit) {
    const double moved = std::abs(number.value - number_of(result.decimal));
    result.bound = rounded_up_to_place(counted(add_up(number.bound, moved)), place);
  }
  return result;
}

Rounding exactly(const Format& format, double value, const std::optional<Number>& number) {
  const bool is_integer = format.notation() == Notation::integer;
  if (number && !number->is_exact()) {
    throw std::invalid_argument(fmt::format("{} has an error and cannot be printed as {}()",
                                            round_trip(value), name_of(format.notation())));
  }
  if (is_integer && std::trunc(value) != value) {
    throw std::invalid_argument(fmt::format("{} is not a whole number", round_trip(value)));
  }
  const int ones = format.is_percentage() ? -2 : 0;
  const bool is_plain = is_integer || format.is_percentage();
  const int last = shortest(value).place;
  return exact_to_place(value, is_plain ? std::min(ones, last) : last,
                        is_plain ? Style::plain : Style::automatic);
}

Rounding bound_above(const Format& format, double value, const std::optional<Number>& number,
                     int ones) {
  const double error = number ? number->bound : 0;
  const double bound = add_up(value, error);
  if (bound < 0) {
    throw std::invalid_argument(
        fmt::format("rounded_up() prints a bound, and {} is negative", round_trip(bound)));
  }
  const bool is_fixed = format.notation() == Notation::fixed;
  int place =
      is_fixed ? ones - format.digits() : rounded_up_to_digits(bound, format.digits()).place;
  if (error > 0) place = std::max(place, rounded_to_digits(error, n_digits_of_error).place);
  const Decimal digits = rounded_up_to_place(bound, place);
  return {digits, is_fixed ? Style::plain : Style::automatic, bound == 0};
}

/// Rounds the number to a place, or to the lowest earned place above it.
Rounding to_place(double value, const std::optional<Number>& number, int place, Style style) {
  if (number && number->is_exact()) return exact_to_place(value, place, style);
  const int lowest = std::max(place, earned_place(number).value_or(place));
  return {rounded_to_place(value, lowest), style, false};
}

/// The place of the n-th digit of the number, or of its error if the number is zero.
int place_of_digits(double value, const std::optional<Number>& number, int n_digits) {
  if (value != 0 || !number) return rounded_to_digits(value, n_digits).place;
  return rounded_to_digits(std::max(number->bound, number->standard), n_digits).place;
}

Rounding to_nearest(const Format& format, double value, const std::optional<Number>& number,
                    int ones) {
  const bool is_fixed = format.notation() == Notation::fixed;
  const int place =
      is_fixed ? ones - format.digits() : place_of_digits(value, number, format.digits());
  Rounding result = to_place(value, number, place, is_fixed ? Style::plain : Style::automatic);
  if (!is_zero(result.decimal)) return result;

  if (is_fixed && value != 0) {
    // The number's first digits, if any are earned.
    constexpr int n_first = 2;
    const int first = rounded_to_digits(value, n_first).place;
    const Rounding digits = to_place(value, number, first, Style::automatic);
    if (!is_zero(digits.decimal)) return digits;
  }
  if (!number || number->is_exact()) return result;
  // Only zeros are earned. They suffice if the number may be zero within its bound, and if they are
  // near the point. Otherwise the number is printed with its error.
  constexpr int lowest_zero = -6;
  const int last = result.decimal.place - ones;
  const bool is_lost =
      std::abs(value) > number->bound || number->standard > 0 || last > 0 || last < lowest_zero;
  return is_lost ? with_uncertainty(*number) : result;
}

}  // namespace

RoundedNumber rounded(const Format& format, double value, const std::optional<Number>& number,
                      int scale) {
  require_printable(format, value, number);
  const int ones = scale + (format.is_percentage() ? -2 : 0);
  const Notation notation = format.notation();
  Rounding result;
  if (notation == Notation::exact || notation == Notation::integer) {
    result = exactly(format, value, number);
  } else if (notation == Notation::uncertain) {
    if (!number) {
      throw std::invalid_argument(
          fmt::format("{} has no error, which uncertain() prints", round_trip(value)));
    }
    result = number->is_exact()
                 ? exactly(format.is_percentage() ? exact().in_percent() : exact(), value, number)
                 : with_uncertainty(*number);
  } else {
    result = format.rounds_up() ? bound_above(format, value, number, ones)
                                : to_nearest(format, value, number, ones);
  }
  if (notation == Notation::scientific) {
    result.style = Style::with_exponent;
  } else if (format.is_percentage() && notation != Notation::fixed) {
    result.style = Style::plain;
  }
  return written(result, ones);
}

RoundedNumber quoted(const Format& format, double value, int place, int scale) {
  require_printable(format, value, std::nullopt);
  const Decimal digits = rounded_to_place(value, place);
  // Reading a decimal number as a double rounds it, and arithmetic such as 5 · 0.01 rounds again.
  constexpr double of_reading = 4 * std::numeric_limits<double>::epsilon();
  if (std::abs(number_of(digits) - value) > of_reading * std::abs(value)) {
    throw std::invalid_argument(fmt::format("{} has more digits than one quoted to the place 1e{}",
                                            round_trip(value), place));
  }
  const bool has_exponent = format.notation() == Notation::scientific;
  return written({digits, has_exponent ? Style::with_exponent : Style::plain, false},
                 scale + (format.is_percentage() ? -2 : 0));
}

int n_earned_digits(const Format& format, double value, const std::optional<Number>& number) {
  constexpr int most = 12;
  const Decimal printed = rounded(format, value, number).decimal;
  if (value == 0 || is_zero(printed)) return 0;
  const auto n_digits = [&](const Decimal& digits) {
    // The zeros of an exact integer count: 31220 has five digits.
    const int last = number && number->is_exact() ? std::min(digits.place, 0) : digits.place;
    return std::clamp(leading_place(digits) - last + 1, 0, most);
  };
  if (!number) return n_digits(printed);
  if (number->is_exact()) return format.rounds_up() ? most : n_digits(shortest(value));
  if (format.rounds_up()) {
    const int last = rounded_to_digits(number->bound, n_digits_of_error).place;
    return n_digits(rounded_up_to_place(add_up(value, number->bound), last));
  }
  const Decimal earned = rounded_to_place(value, earned_place(number).value());
  return is_zero(earned) ? 0 : n_digits(earned);
}

std::string grouped(std::string_view digits, bool point_is_left) {
  constexpr std::size_t least_grouped = 5;
  if (digits.size() < least_grouped) return std::string(digits);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t from_point = point_is_left ? i : digits.size() - i;
    if (i > 0 && from_point % 3 == 0) text += "\\,";
    text += digits[i];
  }
  return text;
}

std::string plain_print(const RoundedNumber& number, std::string_view unit) {
  std::string text = number.digits;
  if (!number.standard.empty()) text += fmt::format("({})", number.standard);
  if (!number.bound.empty()) {
    text += " ± " + number.bound;
    if (number.exponent || !unit.empty()) text = fmt::format("({})", text);
  }
  if (number.exponent) text += fmt::format("e{}", *number.exponent);
  const bool is_attached = unit == "°" || unit == "′" || unit == "″";
  if (!unit.empty()) text += fmt::format("{}{}", is_attached ? "" : " ", unit);
  return text;
}

namespace {

std::string grouped_number(std::string_view number) {
  const std::string sign = number.starts_with('-') ? "-" : "";
  number.remove_prefix(sign.size());
  const auto point = number.find('.');
  std::string text = sign + grouped(number.substr(0, point), false);
  if (point != number.npos) text += "." + grouped(number.substr(point + 1), true);
  return text;
}

}  // namespace

std::string latex_print(const RoundedNumber& number, std::string_view unit) {
  std::string text = grouped_number(number.digits);
  if (!number.standard.empty()) text += fmt::format("({})", number.standard);
  if (!number.bound.empty()) {
    text += "\\pm " + grouped_number(number.bound);
    if (number.exponent || !unit.empty()) text = fmt::format("({})", text);
  }
  if (number.exponent) text += fmt::format("\\times10^{{{}}}", *number.exponent);
  const bool is_attached = unit.starts_with('^');  // as in 90°
  if (!unit.empty()) text += fmt::format("{}{}", is_attached ? "" : "\\,", unit);
  return fmt::format("\\ensuremath{{{}}}", text);
}

}  // namespace literate
