// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace literate {

/// How wide a number is, or the widest of a column: digits before and after the point, and of the
/// exponent.
struct NumberWidth {
  bool negative = false;
  std::size_t n_whole = 1;
  std::size_t n_decimals = 0;
  bool negative_exponent = false;
  std::size_t n_exponent = 0;
};

/// The width of a number as `plain` or `scientific` writes it.
NumberWidth width_of(std::string_view number);

/// What holds both.
NumberWidth widest(const NumberWidth& a, const NumberWidth& b);

/// As siunitx's table-format, such as -1.2e-2.
std::string table_format(const NumberWidth& width);

/// The number in mathematics, with blanks to the width of the column, which must hold it: cells
/// that are centred then stand point below point. Thin spaces group from five digits on.
std::string aligned_number(std::string_view number, const NumberWidth& column);

}  // namespace literate
