// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace literate {

/// A gap in a curve: a NaN with bits that no computation produces by accident.
inline const double gap = std::nan("1");

/// One block of data: named columns of equal length.
struct FigureData {
  using Column = std::pair<std::string, std::vector<double>>;

  FigureData() = default;
  FigureData(std::initializer_list<Column> named_columns) : columns(named_columns) {}
  FigureData(std::vector<Column> named_columns, std::size_t points_per_row)
      : columns(std::move(named_columns)), row_length(points_per_row) {}

  std::vector<Column> columns;

  /// For a surface: the number of points in each row of its grid. A blank line follows each row in
  /// the file, as gnuplot's `splot` requires. 0 for curves.
  std::size_t row_length = 0;
};

/// The data of one figure. A gnuplot script, figures/NAME.gp, decides how it looks. These are
/// variables of the script:
///
/// - each data block: a string with the name of its file, as in `plot loads using
/// "x":"triangular"`;
/// - each number: a floating-point variable, which reads back as the same double;
/// - each text: a string, LaTeX if it becomes a label;
/// - `width_cm` and `height_cm`.
///
/// The names of blocks, numbers and texts are distinct gnuplot identifiers: letters, digits and
/// underscores, not starting with a digit.
struct Figure {
  double width_cm = 0;
  double height_cm = 0;
  std::map<std::string, FigureData> data = {};
  std::map<std::string, double> numbers = {};
  std::map<std::string, std::string> texts = {};
};

/// Throws std::invalid_argument if no script could draw the figure: for a size that is not
/// positive, an invalid name, a block without points, columns of unequal length, and a number that
/// is neither finite nor a gap.
void require_drawable(const Figure& figure);

/// Returns data.gp, which gnuplot reads before the figure's script: terminal, output NAME.tex with
/// NAME.pdf, separators and variables. gnuplot must run in the folder of the figure.
std::string figure_prelude(const std::string& name, const Figure& figure);

/// Returns a block as CSV with the names of its columns in the first line. Numbers are integers
/// with an exponent, 125e-2, which read back as the same doubles under any decimal sign.
std::string figure_csv(const FigureData& data);

}  // namespace literate
