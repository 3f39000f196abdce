// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "numerics/estimate.hpp"

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "error bounds and digits need IEEE arithmetic: compile without -ffast-math and -Ofast"
#endif

namespace literate {

/// A number with its bound and its standard uncertainty, all in one unit.
///
/// The true number lies within `bound` of a number distributed about `value` with the standard
/// deviation `standard`. Computations have a bound, measurements and fits a standard uncertainty
/// (JCGM 100:2008, 2.3.1), and results computed from measurements may have both. An exact number
/// has neither.
struct Number {
  Number(double number, double error_bound, double standard_uncertainty = 0)
      : value(number), bound(error_bound), standard(standard_uncertainty) {}
  // NOLINTNEXTLINE(google-explicit-constructor): a computation returns estimates
  Number(numerics::Estimate estimate) : value(estimate.value), bound(estimate.abs_error) {}

  bool is_exact() const { return bound == 0 && standard == 0; }

  double value;
  double bound;         ///< ≥ 0
  double standard = 0;  ///< ≥ 0
};

enum class Notation { significant, fixed, scientific, integer, exact, uncertain };

/// Returns significant, fixed, scientific, integer, exact or uncertain.
std::string_view name_of(Notation notation);

/// Whether a format with this notation has a number of digits.
bool has_digits(Notation notation);

/// How a number is printed, in the text and in the columns of tables.
///
///     significant(4)   992.8     four significant digits, with a power of ten outside 10⁻³…10⁶
///     fixed(2)         992.76    two digits after the point
///     scientific(3)    9.93e2    three significant digits and a power of ten
///     percent(1)       12.5 %    fixed(1) of a ratio, in per cent; = fixed(1).in_percent()
///     integer()        31220     a whole number with all of its digits; refuses a fraction
///     exact()          9.80665   the fewest digits that read back as the same double: a parameter
///     uncertain()      994(22)   the number with its error
///
/// **Digits are earned.** All formats round half to even from the exact binary value, and omit
/// digits that the number's error does not support:
///
/// - A *bound* b supports the digit at 10^p if 10^p ≥ b: 5.002 with a bound of 0.11 is 5, and with
///   0.1 it is 5.0.
/// - A *standard uncertainty* u supports digits down to the place of its first digit: 79.4 with
///   u = 0.3 is 79.4, and 0.095 with u = 0.022 is 0.10.
/// - Zeros that only fill the places up to the point are omitted unless they are known. 1250 to two
///   digits is 1.2e3, whether it is exact or not; the exact 1200 is 1200.
///
/// If fixed() would print zero for a number that is not zero, it prints the number's first two
/// digits, as far as they are earned. A number that has earned nothing but zeros, yet is known to
/// differ from zero, is printed as by uncertain(): with fixed(1) and a bound of 0.0018, 0.0012 is
/// 0.0 since it may be zero, but −0.0047 is −0.0047 ± 0.0018.
///
/// uncertain() prints two digits of a standard uncertainty in parentheses, in units of the last
/// digit (994(22)), and two digits of a bound after ± (0.78615138 ± 0.00000013). The printed bound
/// is rounded up and includes the rounding of the number. Beside a standard uncertainty a bound
/// below half a unit of the last digit is omitted; a larger one is printed: 1599.11(78) ± 0.04. An
/// exact number is printed as by exact().
class Format {
 public:
  explicit Format(Notation notation, int digits = 0) : notation_(notation), digits_(digits) {}

  /// Returns this format for a ratio printed in per cent.
  Format in_percent() const {
    Format format = *this;
    format.is_percentage_ = true;
    return format;
  }

  /// Returns this format rounding up, for bounds that a sentence states: it prints no less than
  /// value + bound. Every digit of a bound is true, so none has to be earned, but digits below the
  /// second one of the number's own bound are omitted. Only for significant, fixed and scientific,
  /// and for numbers without a standard uncertainty whose sum is not negative.
  Format rounded_up() const {
    Format format = *this;
    format.rounds_up_ = true;
    return format;
  }

  /// Returns this format with a different number of significant digits, for `\val[n]{key}`.
  Format with_digits(int n_digits) const;

  Notation notation() const { return notation_; }
  /// Significant digits, or decimals of fixed(); 0 if the notation has neither.
  int digits() const { return digits_; }
  bool is_percentage() const { return is_percentage_; }
  bool rounds_up() const { return rounds_up_; }

  /// The format in the spelling of C++: «significant(4)», «percent(1).rounded_up()».
  std::string text() const;

  /// Parses the output of text(). Throws std::invalid_argument for anything else.
  static Format parse(std::string_view text);

 private:
  Notation notation_;
  int digits_;
  bool is_percentage_ = false;
  bool rounds_up_ = false;
};

/// Format explains them. The range is 1 to 17 for digits and 0 to 100 for decimals. The use of a
/// format outside it is an error, whose message can then name the value.
inline Format significant(int n_digits) {
  return Format(Notation::significant, n_digits);
}
inline Format fixed(int decimals) {
  return Format(Notation::fixed, decimals);
}
inline Format scientific(int n_digits) {
  return Format(Notation::scientific, n_digits);
}
inline Format percent(int decimals) {
  return fixed(decimals).in_percent();
}
inline Format integer() {
  return Format(Notation::integer);
}
inline Format exact() {
  return Format(Notation::exact);
}
inline Format uncertain() {
  return Format(Notation::uncertain);
}

}  // namespace literate
