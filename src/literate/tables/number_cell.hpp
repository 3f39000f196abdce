// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace literate {

/// The width of a number, or the width that holds all of a column: the signs, and the digits before
/// the point, after it and in the exponent, and the uncertainty.
struct NumberWidth {
  bool negative = false;
  std::size_t n_whole = 1;
  std::size_t n_decimals = 0;
  bool negative_exponent = false;
  std::size_t n_exponent = 0;
  std::string uncertainty = {};  ///< the longest: «(12)», «±0.012»
};

/// Measures a number as `plain` or `scientific` writes it.
NumberWidth width_of(std::string_view number);

/// The least width that holds both.
NumberWidth widest(const NumberWidth& a, const NumberWidth& b);

/// Writes a width as siunitx's table-format, such as -1.2e-2.
std::string table_format(const NumberWidth& width);

/// Writes a number as mathematics, padded with blanks to the width of the column, which must not be
/// less than its own. The points of centred cells then stand below one another; a power of ten
/// follows its digits at once. Five digits or more are grouped by thin spaces. `mark` is LaTeX of
/// no width, which stands beside the last digit.
std::string aligned_number(std::string_view number, const NumberWidth& column,
                           std::string_view mark = "");

/// Writes a number as HTML, padded on the right so that the points of cells that are flush right
/// stand below one another. `mark` is HTML behind the last digit.
std::string number_html(std::string_view number, const NumberWidth& column,
                        std::string_view mark = "");

}  // namespace literate
