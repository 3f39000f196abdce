// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "literate/tables/table.hpp"
#include "literate/values/value.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// A table cell that shows a printed number with its own digits, no more and no fewer.
inline Cell quoted(const PrintedNumber& number) {
  return literate::Cell::quoted(number.value(), number.place());
}

/// The same as a value, with an exponent if it was printed with one.
inline Value quoted_value(const PrintedNumber& number, const std::string& unit = "") {
  const bool has_exponent = number.text().find_first_of("eE") != std::string::npos;
  if (has_exponent) return Value(number.value(), scientific(number.n_digits()), unit);
  return Value(number.value(), fixed(-number.place()), unit);
}

}  // namespace paper
