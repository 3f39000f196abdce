// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "system/decimal.hpp"

namespace literate {

/// All functions here that make a decimal number round the exact binary value half to even (as
/// std::to_chars does), do not depend on the locale, and throw std::invalid_argument for a NaN or
/// an infinity.
using sys::Decimal;
using sys::number_of;

/// Rounds to a multiple of 10^place: (9.996, −2) → 10.00.
Decimal rounded_to_place(double value, int place);

/// Rounds to `n_digits` significant digits, 1 ≤ n_digits ≤ 100; zero stays a plain 0.
Decimal rounded_to_digits(double value, int n_digits);

/// Round as rounded_to_place and rounded_to_digits do, but never below the value, which must not be
/// negative: for bounds.
Decimal rounded_up_to_place(double value, int place);
Decimal rounded_up_to_digits(double value, int n_digits);

/// Returns the fewest digits that read back as the same double.
Decimal shortest(double value);

/// a − b, and a/b − 1, of the decimal numbers that print as these doubles, rounded once: 2.6 − 2.5
/// is 0.1, and 110/100 − 1 is 0.1, which they are not as doubles. `b` of the latter is not 0.
double decimal_difference(double a, double b);
double decimal_relative_difference(double a, double b);

/// A whole number of ±2^53 or beyond, of which there may be no double, as text; empty for any
/// other.
template <std::integral Integer>
std::string not_held(Integer number) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  if constexpr (sizeof(Integer) >= sizeof most) {
    const bool is_below = std::signed_integral<Integer> && number <= static_cast<Integer>(-most);
    if (is_below || number >= static_cast<Integer>(most)) return std::to_string(number);
  }
  return {};
}

/// Throws std::invalid_argument for what not_held() gave, unless that is empty. `text` is what
/// prints such a number: «Value::text».
void require_held(const std::string& not_held, std::string_view text);

bool is_zero(const Decimal& number);

/// The power of ten of the first digit; of zero, that of its last place.
int leading_place(const Decimal& number);

/// Writes without an exponent: -0.0123, 45500.
std::string plain(const Decimal& number);

/// Writes one digit before the point and an exponent: -1.23e-2.
std::string scientific(const Decimal& number);

/// Writes zero and magnitudes in [1e-3, 1e6) without an exponent, all others with one.
std::string plain_or_scientific(const Decimal& number);

/// Writes the shortest text that reads back as the same double, for scripts and data files; a NaN
/// becomes "nan".
std::string round_trip(double value);

/// Writes the shortest digits that read back as the same double, without an exponent, which TeX
/// does not read in a length.
std::string bare_digits(double value);

}  // namespace literate
