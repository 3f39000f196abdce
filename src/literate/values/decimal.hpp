// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "system/decimal.hpp"

namespace literate {

/// These functions round the exact binary value, ties to even, as std::to_chars does. They do not
/// depend on the locale, and take finite numbers only.
using sys::Decimal;
using sys::number_of;
using sys::shortest;

/// Rounds to a multiple of 10^place: (9.996, −2) is 10.00 and (1250, 2) is 12·10².
Decimal rounded_to_place(double value, int place);

/// Rounds to `n_digits` ≥ 1 significant digits. Zero has one digit.
Decimal rounded_to_digits(double value, int n_digits);

/// Rounds up, to the least such number that is not below `value` ≥ 0.
Decimal rounded_up_to_place(double value, int place);
Decimal rounded_up_to_digits(double value, int n_digits);

bool is_zero(const Decimal& number);

/// The power of ten of the first digit; of zero, that of its last place.
int leading_place(const Decimal& number);

/// a − b of the two decimal numbers that print as these doubles: 2.6 − 2.5 is 0.1.
double decimal_difference(double a, double b);

/// The exact rounding error of a + b: the sum less its rounded value (Knuth's TwoSum).
double error_of_sum(double a, double b);

/// Upper bounds on a + b and a·b, which are exact if the result is a double.
double add_up(double a, double b);
double multiply_up(double a, double b);

/// Writes without an exponent: -0.0123, 45500.
std::string plain(const Decimal& number);

/// The shortest text that reads back as the same double: 0.1, 1e-05.
std::string round_trip(double value);

}  // namespace literate
