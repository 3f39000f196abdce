// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "config/printed_number.hpp"
#include "literate/tables/table.hpp"
#include "literate/values/value.hpp"

namespace paper {

/// A table cell that shows a printed number with its own digits, no more and no fewer.
inline literate::Cell quoted(const config::PrintedNumber& number) {
  return literate::Cell::quoted(number.value(), number.place());
}

/// The same as a value, with an exponent if it was printed with one.
inline literate::Value quoted_value(const config::PrintedNumber& number,
                                    const std::string& unit = "") {
  const bool has_exponent = number.text().find_first_of("eE") != std::string::npos;
  if (has_exponent)
    return literate::Value(number.value(), literate::scientific(number.n_digits()), unit);
  return literate::Value(number.value(), literate::fixed(-number.place()), unit);
}

}  // namespace paper
