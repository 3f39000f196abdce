// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "literate/values/decimal.hpp"

namespace literate {

enum class Notation { significant, fixed, scientific, integer, exact, supported, uncertain };

/// significant, fixed, scientific, integer, exact, supported or uncertain.
std::string_view name_of(Notation notation);

/// The notation of that name; throws std::invalid_argument for any other text.
Notation notation_of(std::string_view name);

/// How a number is printed, in the text and in the columns of tables: significant(4), fixed(2),
/// scientific(3), percent(1), integer(), exact(), supported(), uncertain().
///
/// All round half to even from the exact binary value. A number that comes with its error prints
/// no digit whose place is less than the error, and so perhaps fewer than the format names. A
/// number that fixed() would print as zero, though it is not, prints its first digits instead: two
/// of them, or as many as its error supports. One that is greater than its error, although the
/// error supports none of its digits, prints as uncertain() does: -0.0047(18).
class Format {
 public:
  /// The same format for a ratio that is printed in per cent: 0.125 as 12.5 %.
  Format in_percent() const;

  /// The same format, rounding up: for bounds that a sentence states. A number with an error prints
  /// no less than their sum, with any digits down to the second of the error: as a bound each of
  /// them is true. Refuses negative sums.
  Format rounded_up() const;

  Notation notation() const { return notation_; }
  /// Significant digits, or decimals of fixed(); 0 where the notation has no such number.
  int digits() const { return digits_; }
  bool is_percentage() const { return is_percentage_; }
  bool rounds_up() const { return rounds_up_; }

 private:
  Format(Notation notation, int digits) : notation_(notation), digits_(digits) {}

  friend Format significant(int n_digits);
  friend Format fixed(int decimals);
  friend Format scientific(int n_digits);
  friend Format percent(int decimals);
  friend Format integer();
  friend Format exact();
  friend Format supported(int max_digits);
  friend Format uncertain();

  Notation notation_;
  int digits_;
  bool is_percentage_ = false;
  bool rounds_up_ = false;
};

/// Prints `n_digits` significant digits, 1 ≤ n_digits ≤ 100, with an exponent outside [1e-3, 1e6).
/// In a column of a table it is the largest number that has so many digits, and the power of ten
/// that all have in common stands below the heading.
Format significant(int n_digits);

/// Prints `decimals` digits after the point, 0 ≤ decimals ≤ 100.
Format fixed(int decimals);

/// Prints `n_digits` significant digits and always an exponent, except for zero.
Format scientific(int n_digits);

/// fixed(decimals).in_percent().
Format percent(int decimals);

/// Prints a whole number with all its digits; refuses a fraction.
Format integer();

/// Prints the fewest digits that read back as the same double: for parameters.
Format exact();

/// Prints the digits that the error supports, at most `max_digits`. The last digit stands at 10^p,
/// the least power of ten ≥ 2·abs_error, so it is wrong by one at most. With an error of 0 it
/// prints as exact() does.
Format supported(int max_digits = 12);

/// Prints the number and, in parentheses, the error bound in units of its last digit, rounded up to
/// two digits: 0.78615138(12) for 0.786151378 and 1.2e-7. With an error of 0 it prints as exact()
/// does.
Format uncertain();

/// A number as a format rounds it.
struct RoundedNumber {
  Decimal digits;
  enum class Style { plain, automatic, with_exponent } style = Style::plain;
  bool has_unknown_zeros = false;  ///< zeros left of the point would claim digits not known
  std::string uncertainty;         ///< in units of the last digit; empty for none

  /// The number divided by 10^exponent, as text: -0.0123, 4.55e4, 0.786(12).
  std::string text(int exponent = 0) const;
};

/// Rounds a number, with its error bound if it has one; of a percentage both are of the ratio.
///
/// Throws std::invalid_argument for a number that is not finite, for an error bound that is
/// negative or not finite, for digits out of range, and for what the format refuses: a fraction, a
/// negative bound, an error beside an exact or whole number, none beside supported() and
/// uncertain().
RoundedNumber rounded(const Format& format, double number, std::optional<double> abs_error);

/// As rounded() for a format that fixes the place of the last digit: fixed() with decimals of the
/// number divided by 10^exponent.
RoundedNumber rounded_at(double number, std::optional<double> abs_error, int place);

/// The least power of ten that is not less than the bound, as the place of a last digit; none for a
/// bound of 0.
std::optional<int> least_earned_place(double abs_error);

/// Throws std::invalid_argument unless a digit at 10^place is earned: 10^place ≥ abs_error. What is
/// printed is named in the message.
void require_earned(double number, int place, double abs_error, std::string_view printed);

/// Throws std::invalid_argument for an error bound that is negative or not finite.
void require_error_bound(double abs_error);

}  // namespace literate
