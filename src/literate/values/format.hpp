// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "literate/values/decimal.hpp"
#include "numerics/measured.hpp"

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
/// error supports none of its digits, prints as uncertain() does, -0.0047 ± 0.0018, and so do one
/// that would be zero and has a standard uncertainty, which is no bound, -0.6(16), and one of which
/// nothing but zeros before the point would be left, 12 ± 34.
class Format {
 public:
  /// The same format for a ratio that is printed in per cent: 0.125 as 12.5 %.
  Format in_percent() const;

  /// The same format, rounding up: for bounds that a sentence states. A number with an error prints
  /// no less than their sum, with any digits down to the second of the error: as a bound each of
  /// them is true. Refuses negative sums.
  Format rounded_up() const;

  /// uncertain() with each kind of standard uncertainty by itself: 994 ± 22 (statistics) ± 5
  /// (calibration). Refuses other notations.
  Format by_kind() const;

  Notation notation() const { return notation_; }
  /// Significant digits, or decimals of fixed(); 0 where the notation has no such number.
  int digits() const { return digits_; }
  bool is_percentage() const { return is_percentage_; }
  bool rounds_up() const { return rounds_up_; }
  bool tells_kinds() const { return tells_kinds_; }

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
  bool tells_kinds_ = false;
};

/// Prints `n_digits` significant digits, 1 ≤ n_digits ≤ 100, with an exponent outside
/// [1e-3, 1e6), or if the digits end before the point, as 4.12e4 does.
/// In a column of a table it is the largest number that has so many digits, and the power of ten
/// that all have in common stands below the heading.
Format significant(int n_digits);

/// Prints `decimals` digits after the point, 0 ≤ decimals ≤ 100.
Format fixed(int decimals);

/// Prints `n_digits` significant digits and always an exponent, except for a zero without error.
Format scientific(int n_digits);

/// fixed(decimals).in_percent().
Format percent(int decimals);

/// Prints a whole number with all its digits; refuses a fraction.
Format integer();

/// Prints the fewest digits that read back as the same double: for parameters.
Format exact();

/// Prints the digits that the error supports, at most `max_digits`. The last digit stands at 10^p,
/// the least power of ten that is no less than twice the error, so it is wrong by one at most. With
/// an error of 0 it prints as exact() does where that needs no more than `max_digits`, and else so
/// many.
Format supported(int max_digits = 12);

/// Prints the number with what is not known of it, to two digits. A standard uncertainty, rounded
/// to the nearest, stands in parentheses in units of the last digit: 994(22). A bound stands behind
/// ±, as JCGM 100:2008, 7.2.2, has it, and is rounded up with the rounding of the number in it:
/// 0.786151378 and 1.2e-7 are 0.78615138 ± 0.00000013. A bound that is another one to either side
/// stands behind + and −: 994 +22 −18. Beside a standard uncertainty it is left out where it is
/// less than half a unit of the last digit. Beside a bound that is much greater the number has that
/// bound's digits, and a standard uncertainty that is less than half of a third one is left out.
/// What the law of propagation neglects belongs to the bound where it is more than the standard
/// uncertainty, as of the cosine of 0 ± 0.3. With an error of 0 it prints as exact() does.
Format uncertain();

/// What is not known of a number, in its unit: the true one is no farther than `bound` from a
/// number that is distributed about the printed one.
struct Uncertainty {
  // NOLINTNEXTLINE(google-explicit-constructor): a bound alone is what most numbers have
  Uncertainty(double abs_error) : bound(abs_error) {}
  // NOLINTNEXTLINE(google-explicit-constructor): the same without the names of its sources
  Uncertainty(const numerics::Measured& number);

  /// A bound that is another one to either side: the true number lies in [number − below,
  /// number + above]. Digits and decisions count the greater as the bound.
  static Uncertainty to_sides(double below, double above);

  double bound;
  std::optional<std::pair<double, double>> sides = {};  ///< below and above, if they differ
  double standard = 0;                                  ///< of all kinds together
  std::map<std::string, double> kinds = {};
  double neglected = 0;  ///< by the law of propagation

  /// The bound with k standard uncertainties; what the law of propagation neglects grows with k².
  double error(double k = 1) const;

  /// Whether the law of propagation does not hold: it neglects more than it gives.
  bool is_nonlinear() const { return neglected > standard; }

  /// What stands behind ±: the bound, with what the law neglects where it does not hold.
  double told_bound() const;
};

/// The texts of which a printed number consists.
struct NumberPrint {
  struct Beside {
    std::string number;
    std::string what;        ///< such as «statistics»; empty if nothing has to be said
    std::string sign = "±";  ///< or «+» and «−» of a bound to one side
  };

  std::string number;          ///< with its standard uncertainty in parentheses: 0.786(12)
  std::vector<Beside> beside;  ///< what stands behind ±, or behind + and −
  std::string exponent;        ///< a power of ten of all of it; empty for none

  /// In one: 0.786(12), 4.7±1.8e-3.
  std::string text() const;
};

/// A number as a format rounds it.
struct RoundedNumber {
  /// What stands behind ± or another sign, and in parentheses what it is, if that has to be said.
  struct Beside {
    Decimal digits;
    std::string what = {};
    std::string sign = "±";
  };

  Decimal digits;
  enum class Style { plain, automatic, with_exponent } style = Style::plain;
  bool has_unknown_zeros = false;  ///< zeros left of the point would claim digits not known
  std::string standard = {};       ///< uncertainty in units of the last digit; empty for none
  std::vector<Beside> beside = {};

  /// The number divided by 10^exponent.
  NumberPrint printed(int exponent = 0) const;
};

/// Rounds a number, with what is not known of it if somebody told; of a percentage both are of the
/// ratio.
///
/// Throws std::invalid_argument for a number that is not finite, for a bound or a standard
/// uncertainty that is negative or not finite, for digits out of range, and for what the format
/// refuses: a fraction, a negative bound, an error beside an exact or whole number, none beside
/// supported() and uncertain(), a standard uncertainty where a bound is to be rounded up.
RoundedNumber rounded(const Format& format, double number,
                      const std::optional<Uncertainty>& uncertainty);

/// As rounded() for a format that fixes the place of the last digit: fixed() with decimals of the
/// number divided by 10^ones.
RoundedNumber rounded_at(double number, const std::optional<Uncertainty>& uncertainty, int place,
                         int ones = 0);

/// The least power of ten that is not less than the bound, as the place of a last digit; none for a
/// bound of 0.
std::optional<int> least_earned_place(double abs_error);

/// Throws std::invalid_argument unless a digit at 10^place is earned: 10^place ≥ abs_error. What is
/// printed is named in the message.
void require_earned(double number, int place, double abs_error, std::string_view printed);

/// Throws std::invalid_argument for an error bound that is negative or not finite.
void require_error_bound(double abs_error);

}  // namespace literate
