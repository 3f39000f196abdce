// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

enum class Notation { significant, fixed, scientific, integer, exact, uncertain };

/// significant, fixed, scientific, integer, exact or uncertain.
std::string_view name_of(Notation notation);

/// Whether the format of such numbers says how many digits there are.
bool has_digits(Notation notation);

/// How a number is printed, in the text and in the columns of tables.
///
///     significant(4)   992.8     four significant digits, with a power of ten outside 10⁻³…10⁶
///     fixed(2)         992.76    two digits after the point
///     scientific(3)    9.93e2    three significant digits and a power of ten
///     percent(1)       12.5 %    fixed(1) of a ratio, in per cent; = fixed(1).in_percent()
///     integer()        31220     a whole number with all its digits; refuses a fraction
///     exact()          9.80665   the fewest digits that read back as the same double: a parameter
///     uncertain()      994(22)   the number with what is not known of it
///
/// **Digits are earned.** All formats round half to even from the exact binary value, and print no
/// digit that the number's uncertainty does not support:
///
/// - A *bound* b supports the digit at 10^p if 10^p ≥ b: 5.002 with a bound of 0.11 is 5, and with
///   0.1 it is 5.0.
/// - A *standard uncertainty* u supports the digits down to that of its own first digit: 79.4 with
///   u = 0.3 is 79.4, and 0.095 with u = 0.022 is 0.10.
/// - Zeros that only fill the places up to the point are not printed unless they are known. 1250 to
///   two digits is 1.2e3, whether it is exact or not; the exact 1200 is 1200.
///
/// A number that fixed() would print as zero, though it is not zero, prints its first two digits
/// instead, or as many of them as it earned. Where no digit but zeros is earned, the number is
/// printed as uncertain() prints it: 0.0012 with a bound of 0.0018 and fixed(1) is 0.0 since it may
/// be zero, but −0.0047 with that bound is known to differ from zero and is −0.0047 ± 0.0018.
///
/// uncertain() gives a standard uncertainty two digits, in parentheses in units of the last digit
/// (994(22)), and a bound two digits behind ± (0.78615138 ± 0.00000013), rounded up together with
/// what rounding the number itself has moved it. Beside a standard uncertainty the bound is left
/// out where it is less than half a unit of the last digit: 1599.11(78) ± 0.04. An exact number is
/// printed as exact() prints it.
class Format {
 public:
  /// The same format for a ratio that is printed in per cent.
  Format in_percent() const;

  /// The same format, rounded up: for bounds that a sentence states. It prints no less than value +
  /// bound. Any digit of a bound is true, so none has to be earned, but there are none below the
  /// second digit of the number's own bound. Only for significant, fixed and scientific, for
  /// numbers whose sum is not negative and that have no standard uncertainty.
  Format rounded_up() const;

  /// The same format with another count of significant digits: what `\val[n]{key}` prints.
  Format with_digits(int n_digits) const;

  Notation notation() const { return notation_; }
  /// Significant digits, or decimals of fixed(); 0 where the notation has no such number.
  int digits() const { return digits_; }
  bool is_percentage() const { return is_percentage_; }
  bool rounds_up() const { return rounds_up_; }

  /// The format as it is spelt here: «significant(4)», «percent(1).rounded_up()».
  std::string text() const;

  /// Reads what text() writes. Throws std::invalid_argument for anything else.
  static Format parse(std::string_view text);

 private:
  Format(Notation notation, int digits) : notation_(notation), digits_(digits) {}

  friend Format significant(int n_digits);
  friend Format fixed(int decimals);
  friend Format scientific(int n_digits);
  friend Format integer();
  friend Format exact();
  friend Format uncertain();

  Notation notation_;
  int digits_;
  bool is_percentage_ = false;
  bool rounds_up_ = false;
};

/// Format explains them. Digits are 1 to 17, decimals 0 to 100; others are refused where the format
/// is used, so that the message can name what is printed.
Format significant(int n_digits);
Format fixed(int decimals);
Format scientific(int n_digits);
Format percent(int decimals);
Format integer();
Format exact();
Format uncertain();

}  // namespace literate
