// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/table.hpp"
#include "parameters/printed_number.hpp"

namespace paper {

/// A table cell that shows a printed number with its own digits, no more and no fewer.
inline literate::Cell quoted(const parameters::PrintedNumber& number) {
  return literate::Cell::to_place(number.value(), number.place());
}

}  // namespace paper
