// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <string>

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

/// Throws std::invalid_argument for a whole number beyond ±2^53, written as text, of which there
/// may be no double.
[[noreturn]] void refuse_whole_number(const std::string& number);

/// A whole number as a double, which is the same number; throws as refuse_whole_number does.
template <std::integral Integer>
double double_of(Integer number) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  if constexpr (sizeof(Integer) >= sizeof most) {
    const bool is_below = std::signed_integral<Integer> && number < static_cast<Integer>(-most);
    if (is_below || number > static_cast<Integer>(most))
      refuse_whole_number(std::to_string(number));
  }
  return static_cast<double>(number);
}

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
