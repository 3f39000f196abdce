// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/format.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/estimate_algebra.hpp"

namespace literate {
namespace {

using numerics::Estimate;
using numerics::rounding::add_up;
using numerics::rounding::multiply_up;

constexpr std::array<std::string_view, 7> names_of_notations{
    "significant", "fixed", "scientific", "integer", "exact", "supported", "uncertain"};

void require_count(const char* what, int count, int least) {
  constexpr int most = 100;
  if (count >= least && count <= most) return;
  throw std::invalid_argument(
      fmt::format("{} = {}: must lie between {} and {}", what, count, least, most));
}

/// An error as it counts wherever digits depend on it: to twelve significant digits. As a double
/// the sum of 0.1 and 0.05 is 0.15000000000000002; what lies behind twelve digits is the rounding
/// of the error itself.
double counted(double abs_error) {
  constexpr int n_digits = 12;
  return number_of(rounded_to_digits(abs_error, n_digits));
}

/// The least place p with 10^p ≥ error > 0.
int place_of(double abs_error) {
  const Decimal error = shortest(counted(abs_error));
  return leading_place(error) + (error.digits == "1" ? 0 : 1);
}

/// The lowest place that is neither below `lowest` nor below the error.
int earned_place(double abs_error, int lowest) {
  return std::max(lowest, least_earned_place(abs_error).value_or(lowest));
}

/// Rounds to the digits that the error supports, at most `max_digits`.
Decimal supported_digits(Estimate estimate, int max_digits) {
  const Decimal longest = rounded_to_digits(estimate.value, max_digits);
  if (estimate.abs_error == 0) {
    const Decimal all = shortest(estimate.value);
    return all.place >= longest.place ? all : longest;
  }
  const int place = place_of(2 * estimate.abs_error);
  if (is_zero(longest)) return rounded_to_place(0, place);
  return rounded_to_place(estimate.value, std::max(place, leading_place(longest) - max_digits + 1));
}

/// The place of the last of `max_digits` digits of the number, or of its error if the number is
/// zero.
int lowest_place(Estimate estimate, int max_digits) {
  const double leading = estimate.value == 0 ? estimate.abs_error : estimate.value;
  return rounded_to_digits(leading, max_digits).place;
}

/// The first digits of a number that is too small for its place, if the error supports one.
std::optional<Decimal> first_digits(Estimate estimate) {
  constexpr int n_digits = 2;
  const Decimal two = rounded_to_digits(estimate.value, n_digits);
  if (estimate.abs_error == 0) {
    const Decimal all = shortest(estimate.value);
    return all.place > two.place ? all : two;
  }
  const int place = earned_place(estimate.abs_error, two.place);
  const Decimal earned = rounded_to_place(estimate.value, place);
  if (is_zero(earned)) return std::nullopt;
  return earned;
}

}  // namespace

std::string_view name_of(Notation notation) {
  return names_of_notations.at(static_cast<std::size_t>(notation));
}

Notation notation_of(std::string_view name) {
  const auto found = std::ranges::find(names_of_notations, name);
  if (found == names_of_notations.end()) {
    throw std::invalid_argument(fmt::format("there is no notation '{}'", name));
  }
  return static_cast<Notation>(found - names_of_notations.begin());
}

Format Format::in_percent() const {
  Format format = *this;
  format.is_percentage_ = true;
  return format;
}

Format Format::rounded_up() const {
  Format format = *this;
  format.rounds_up_ = true;
  return format;
}

Format Format::by_kind() const {
  if (notation_ != Notation::uncertain) {
    throw std::invalid_argument(
        fmt::format("{}() tells no kinds of uncertainty", name_of(notation_)));
  }
  Format format = *this;
  format.tells_kinds_ = true;
  return format;
}

Format significant(int n_digits) {
  require_count("significant digits", n_digits, 1);
  return {Notation::significant, n_digits};
}

Format fixed(int decimals) {
  require_count("decimals", decimals, 0);
  return {Notation::fixed, decimals};
}

Format scientific(int n_digits) {
  require_count("significant digits", n_digits, 1);
  return {Notation::scientific, n_digits};
}

Format percent(int decimals) {
  return fixed(decimals).in_percent();
}

Format integer() {
  return {Notation::integer, 0};
}

Format exact() {
  return {Notation::exact, 0};
}

Format supported(int max_digits) {
  require_count("significant digits", max_digits, 1);
  return {Notation::supported, max_digits};
}

Format uncertain() {
  return {Notation::uncertain, 0};
}

Uncertainty::Uncertainty(const numerics::Measured& number)
    : bound(number.bounded().abs_error),
      standard(number.standard()),
      kinds(number.kinds()),
      neglected(number.neglected()) {
  // What cancels leaves its rounding.
  std::erase_if(kinds, [&](const auto& kind) { return kind.second <= 1e-12 * standard; });
}

Uncertainty Uncertainty::to_sides(double below, double above) {
  require_error_bound(below);
  require_error_bound(above);
  Uncertainty uncertainty(std::max(below, above));
  if (below != above) uncertainty.sides = {below, above};
  return uncertainty;
}

double Uncertainty::error(double k) const {
  return add_up(bound, add_up(multiply_up(k, standard), multiply_up(k * k, neglected)));
}

double Uncertainty::told_bound() const {
  return is_nonlinear() ? add_up(bound, neglected) : bound;
}

void require_error_bound(double abs_error) {
  if (std::isfinite(abs_error) && abs_error >= 0) return;
  throw std::invalid_argument(
      fmt::format("{} is no error bound: it is negative or not finite", abs_error));
}

std::optional<int> least_earned_place(double abs_error) {
  if (abs_error == 0) return std::nullopt;
  return place_of(abs_error);
}

void require_earned(double number, int place, double abs_error, std::string_view printed) {
  if (least_earned_place(abs_error).value_or(place) <= place) return;
  throw std::invalid_argument(
      fmt::format("{} is printed as '{}', more digits than an error of {} supports", number,
                  printed, abs_error));
}

std::string NumberPrint::text() const {
  std::string text = number;
  for (const Beside& of : beside) text += of.sign + of.number;
  return exponent.empty() ? text : fmt::format("{}e{}", text, exponent);
}

NumberPrint RoundedNumber::printed(int exponent) const {
  Decimal shifted = digits;
  shifted.place -= exponent;
  // Zero has no power of ten, unless it says how much is known of it.
  if (is_zero(shifted) && !has_unknown_zeros) shifted.place = std::min(shifted.place, 0);
  const bool pads_zeros = has_unknown_zeros && shifted.place > 0;
  std::string text;
  if (style == Style::with_exponent || pads_zeros) {
    text = scientific(shifted);
  } else {
    text = style == Style::plain ? plain(shifted) : plain_or_scientific(shifted);
  }
  NumberPrint printed;
  const std::size_t end = std::min(text.find('e'), text.size());
  if (end < text.size()) printed.exponent = text.substr(end + 1);
  printed.number = text.substr(0, end) + (standard.empty() ? "" : fmt::format("({})", standard));
  const int power = printed.exponent.empty() ? 0 : std::stoi(printed.exponent);
  for (const auto& [of, what, sign] : beside) {
    Decimal shifted_too = of;
    shifted_too.place -= exponent + power;
    printed.beside.push_back({plain(shifted_too), what, sign});
  }
  return printed;
}

namespace {

using Style = RoundedNumber::Style;

constexpr int n_digits_of_error = 2;

/// ± a bound that holds the true number, though the printed one is rounded.
RoundedNumber with_bound(Estimate estimate) {
  for (int place = rounded_up_to_digits(counted(estimate.abs_error), n_digits_of_error).place;;
       ++place) {
    const Decimal digits = rounded_to_place(estimate.value, place);
    const double bound = estimate.abs_error + std::abs(estimate.value - number_of(digits));
    const Decimal printed = rounded_up_to_place(counted(bound), place);
    if (printed.digits.size() > n_digits_of_error) continue;
    return {digits, Style::automatic, true, "", {{printed}}};
  }
}

/// + and − the bounds to either side, to two digits of the lesser but no more than three of the
/// greater. They hold the true number, though the printed one is rounded.
RoundedNumber with_sides(double number, double below, double above) {
  const auto place_of_digits = [](double bound, int n) {
    return rounded_up_to_digits(counted(bound), n).place;
  };
  const double lesser =
      std::min(below, above) > 0 ? std::min(below, above) : std::max(below, above);
  const int place = std::max(place_of_digits(lesser, n_digits_of_error),
                             place_of_digits(std::max(below, above), n_digits_of_error + 1));
  const Decimal digits = rounded_to_place(number, place);
  const double up = number_of(digits) - number;
  const auto printed = [&](double bound) {
    return rounded_up_to_place(counted(std::max(bound, 0.0)), place);
  };
  return {digits,
          Style::automatic,
          true,
          "",
          {{printed(above - up), "", "+"}, {printed(below + up), "", "−"}}};
}

/// A bound beside a standard uncertainty, unless it is less than half a unit of the last digit,
/// which rounding leaves open anyway. It holds of the number that is printed.
void add_bound(RoundedNumber& rounded, double number, double bound, std::string_view what) {
  const int place = rounded.digits.place;
  const Decimal half{.negative = false, .digits = "5", .place = place - 1};
  if (bound < number_of(half)) return;
  bound += std::abs(number - number_of(rounded.digits));
  rounded.beside.push_back({rounded_up_to_place(counted(bound), place), std::string(what)});
}

/// The place of the second digit of the bound; the least there is without one.
int place_of_bound(const Uncertainty& uncertainty) {
  const double bound = uncertainty.told_bound();
  return bound > 0 ? rounded_to_digits(bound, n_digits_of_error).place
                   : std::numeric_limits<int>::min() / 2;
}

/// The place of the second digit of the standard uncertainty, or of the third of a bound that is
/// much greater.
int place_of_both(const Uncertainty& uncertainty) {
  return std::max(rounded_to_digits(uncertainty.standard, n_digits_of_error).place,
                  place_of_bound(uncertainty) - 1);
}

/// The number with each kind of what is not known of it, to the digits of the least of them, but to
/// no more than three of all together.
RoundedNumber with_kinds(double number, const Uncertainty& uncertainty) {
  int place = place_of_both(uncertainty);
  const int finest = std::max(place_of_bound(uncertainty), place) - 1;
  for (const auto& [kind, standard] : uncertainty.kinds) {
    place = std::min(place, rounded_to_digits(standard, n_digits_of_error).place);
  }
  place = std::max(place, finest);
  RoundedNumber result{rounded_to_place(number, place), Style::automatic, true};
  for (const auto& [kind, standard] : uncertainty.kinds) {
    const Decimal nearest = rounded_to_place(standard, place);
    result.beside.push_back(
        {is_zero(nearest) ? rounded_up_to_place(standard, place) : nearest, kind});
  }
  add_bound(result, number, uncertainty.told_bound(), "at most");
  return result;
}

RoundedNumber with_uncertainty(double number, const Uncertainty& uncertainty) {
  if (uncertainty.standard == 0 && uncertainty.sides) {
    return with_sides(number, uncertainty.sides->first, uncertainty.sides->second);
  }
  if (uncertainty.standard == 0) return with_bound({number, uncertainty.told_bound()});
  const int place = place_of_both(uncertainty);
  const Decimal standard = rounded_to_place(uncertainty.standard, place);
  if (is_zero(standard)) return with_bound({number, uncertainty.told_bound()});
  RoundedNumber result{rounded_to_place(number, place), Style::automatic, true, standard.digits};
  add_bound(result, number, uncertainty.told_bound(), "");
  return result;
}

/// A number without an error is the decimal number that reads as it: behind its digits stand zeros,
/// and not those of the double nearest to it.
Decimal exact_to_place(double number, int place) {
  Decimal digits = shortest(number);
  if (is_zero(digits) || digits.place < place) return rounded_to_place(number, place);
  digits.digits.append(static_cast<std::size_t>(digits.place - place), '0');
  digits.place = place;
  return digits;
}

/// The number with all that its digits count as its error.
Estimate estimate_of(double number, const std::optional<Uncertainty>& uncertainty) {
  if (!uncertainty) return {number, 0};
  require_error_bound(uncertainty->bound);
  return {number, uncertainty->error()};
}

/// Whether a number is rounded to zero, and this is not all that there is to say: it is known not
/// to be zero, it has a standard uncertainty, which is no bound, or nothing is left but zeros
/// before the point, which stands behind 10^ones, such as 0 · 10² of 12 ± 34.
bool is_lost_by_rounding(const Decimal& digits, Estimate estimate,
                         const std::optional<Uncertainty>& uncertainty, int ones) {
  if (!is_zero(digits)) return false;
  return std::abs(estimate.value) > estimate.abs_error ||
         (uncertainty && uncertainty->standard > 0) ||
         (digits.place > ones && estimate.abs_error > 0);
}

}  // namespace

RoundedNumber rounded_at(double number, const std::optional<Uncertainty>& uncertainty, int place,
                         int ones) {
  const Estimate estimate = estimate_of(number, uncertainty);
  const bool is_exact = uncertainty && estimate.abs_error == 0;
  const Decimal digits = is_exact
                             ? exact_to_place(number, place)
                             : rounded_to_place(number, earned_place(estimate.abs_error, place));
  RoundedNumber rounded{digits, Style::plain, estimate.abs_error > 0};
  if (!is_zero(digits)) return rounded;
  if (const auto first = number != 0 ? first_digits(estimate) : std::nullopt) {
    rounded.digits = *first;
    rounded.style = Style::automatic;
    return rounded;
  }
  return is_lost_by_rounding(digits, estimate, uncertainty, ones)
             ? with_uncertainty(number, *uncertainty)
             : rounded;
}

namespace {

RoundedNumber exactly(const Format& format, Estimate estimate) {
  if (estimate.abs_error > 0) {
    throw std::invalid_argument(fmt::format("{} has an error of {} and cannot be printed as {}",
                                            estimate.value, estimate.abs_error,
                                            name_of(format.notation())));
  }
  if (format.notation() == Notation::integer) {
    const Decimal digits = rounded_to_place(estimate.value, 0);
    if (std::trunc(estimate.value) != estimate.value) {
      throw std::invalid_argument(
          fmt::format("{} is not a whole number", round_trip(estimate.value)));
    }
    return {digits, Style::plain};
  }
  Decimal digits = shortest(estimate.value);
  if (!format.is_percentage()) return {digits, Style::automatic};
  // All zeros of an exact number are known: 100 %, not 1e2 %.
  for (; digits.place > -2 && !is_zero(digits); --digits.place) digits.digits += '0';
  return {digits, Style::plain};
}

/// A bound is true with any digits, so that none has to be earned; finer than the second digit of
/// the error it says nothing more.
RoundedNumber bound_above(const Format& format, Estimate estimate) {
  const double bound = estimate.value + estimate.abs_error;
  if (bound < 0) {
    throw std::invalid_argument(
        fmt::format("rounded_up() prints a bound, and {} is negative", bound));
  }
  int lowest = format.notation() == Notation::fixed
                   ? -format.digits() - (format.is_percentage() ? 2 : 0)
                   : rounded_up_to_digits(bound, format.digits()).place;
  if (estimate.abs_error > 0) {
    lowest = std::max(lowest, rounded_to_digits(estimate.abs_error, n_digits_of_error).place);
  }
  const Decimal digits = rounded_up_to_place(bound, lowest);
  return {digits, Style::plain, true};
}

RoundedNumber to_nearest(const Format& format, Estimate estimate,
                         const std::optional<Uncertainty>& uncertainty) {
  const int ones = format.is_percentage() ? -2 : 0;
  if (format.notation() == Notation::fixed) {
    return rounded_at(estimate.value, uncertainty, ones - format.digits(), ones);
  }
  const auto to_digits = [&] {
    const int lowest = lowest_place(estimate, format.digits());
    return uncertainty && estimate.abs_error == 0
               ? exact_to_place(estimate.value, lowest)
               : rounded_to_place(estimate.value, earned_place(estimate.abs_error, lowest));
  };
  const Decimal digits = format.notation() == Notation::supported
                             ? supported_digits(estimate, format.digits())
                             : to_digits();
  if (is_lost_by_rounding(digits, estimate, uncertainty, ones)) {
    return with_uncertainty(estimate.value, *uncertainty);
  }
  return {digits, Style::automatic, estimate.abs_error > 0};
}

}  // namespace

RoundedNumber rounded(const Format& format, double number,
                      const std::optional<Uncertainty>& uncertainty) {
  const Estimate estimate = estimate_of(number, uncertainty);
  const Notation notation = format.notation();
  const bool needs_error = notation == Notation::supported || notation == Notation::uncertain;
  if (needs_error && !uncertainty) {
    throw std::invalid_argument(
        fmt::format("{} has no error, which {}() prints it by", number, name_of(notation)));
  }
  if (format.rounds_up() &&
      (needs_error || notation == Notation::exact || notation == Notation::integer)) {
    throw std::invalid_argument(fmt::format("{}() cannot round up", name_of(notation)));
  }
  if (format.rounds_up() && uncertainty && uncertainty->standard > 0) {
    throw std::invalid_argument(fmt::format(
        "{} has a standard uncertainty of {}, which is no bound: rounded_up() has nothing to round",
        number, uncertainty->standard));
  }

  RoundedNumber result;
  if (notation == Notation::exact || notation == Notation::integer) {
    result = exactly(format, estimate);
  } else if (notation == Notation::uncertain) {
    result = estimate.abs_error == 0 ? exactly(format, estimate)
             : format.tells_kinds() && uncertainty->standard > 0
                 ? with_kinds(number, *uncertainty)
                 : with_uncertainty(number, *uncertainty);
  } else {
    result = format.rounds_up() ? bound_above(format, estimate)
                                : to_nearest(format, estimate, uncertainty);
  }
  if (format.is_percentage()) {
    // Style::automatic is what a number too small for its decimals has.
    if (notation != Notation::fixed) result.style = Style::plain;
    if (notation == Notation::scientific) result.style = Style::with_exponent;
    const bool is_exact_zero = number == 0 && estimate.abs_error == 0;
    result.has_unknown_zeros = notation != Notation::exact && !is_exact_zero;
  } else if (notation == Notation::scientific) {
    result.style = Style::with_exponent;
  } else if (format.rounds_up() && notation == Notation::significant) {
    result.style = Style::automatic;
    result.has_unknown_zeros = estimate.abs_error > 0;
  }
  return result;
}

}  // namespace literate
