// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "literate/tables/cell.hpp"
#include "literate/tables/column.hpp"

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

/// Puts a separator after every third of five digits or more, counted from the decimal point, at
/// which they begin or end.
std::string grouped(std::string_view digits, bool point_is_left,
                    std::string_view separator = "\\,");

/// Measures a number as `plain` or `scientific` writes it.
NumberWidth width_of(std::string_view number);

/// The least width that holds both.
NumberWidth widest(const NumberWidth& a, const NumberWidth& b);

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

/// Throws std::invalid_argument for a cell that the column cannot print, or whose digits are not
/// earned: a number that is not finite, a bare number unless the column is exact, a number in a
/// column of texts, a fraction among whole numbers, and a bound that does not support all digits.
/// What two columns of one table decide together, a common exponent, is not known here.
void require_printable(const ColumnFormat& column, const Cell& cell);

/// Writes one column of a table as LaTeX: header lines, and cells of equal width, so that the
/// decimal points stand below one another. (An S column of siunitx does the same, but takes 1 ms
/// for each cell in each run of LaTeX.)
class ColumnWriter {
 public:
  /// Writes all cells, each of which must be printable.
  ColumnWriter(ColumnFormat format, const std::vector<const Cell*>& cells);

  /// The column type: `l` for text, or `p` if it has a width, `c` for numbers.
  std::string specification() const;

  std::string heading() const;
  const std::string& group() const { return format_.group; }

  /// The unit in parentheses, with the power of ten factored out; empty if there is none.
  std::string unit() const;

  /// One cell; a number is mathematics, padded to the width of the column.
  std::string cell(std::size_t row) const;

  /// The text of a cell, or its digits with the power of ten that the column's head tells, 3.5e-2.
  std::string printed(std::size_t row) const;

  /// What HTML says of heads and texts: those of numbers end where the numbers do, and a column of
  /// numbers without a common form is centred.
  std::string html_class() const;

  /// The same cell as HTML, in which LaTeX stands in <tex></tex>.
  std::string cell_html(std::size_t row) const;

 private:
  struct Written {
    std::string text;
    std::string mark;
    bool is_number = false;
  };
  Written written(const Cell& cell);

  ColumnFormat format_;  // a common exponent is turned into the fixed one that the cells have
  NumberWidth width_;
  std::vector<Written> cells_;
};

}  // namespace literate
