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

/// A point that is not there: a gap in a curve. It is a NaN that no computation makes by accident.
inline const double gap = std::nan("1");

/// One block of data: columns of equal length under their names.
struct FigureData {
  using Column = std::pair<std::string, std::vector<double>>;

  FigureData() = default;
  FigureData(std::initializer_list<Column> named_columns) : columns(named_columns) {}
  FigureData(std::vector<Column> named_columns, std::size_t points_per_row)
      : columns(std::move(named_columns)), row_length(points_per_row) {}

  std::vector<Column> columns;

  /// For a surface over a grid of points: how many points make one row of the grid. A blank line
  /// follows each row in the file, as gnuplot's `splot` needs it. 0 for curves.
  std::size_t row_length = 0;
};

/// What a program knows of one figure: what there is to draw, not how. How it looks is the business
/// of a gnuplot script, figures/NAME.gp, which finds here
///
/// - the name of each data block as a variable that holds the file's name, so that the script says
///   `plot loads using "x":"triangular"`;
/// - each number as a floating-point variable, which reads back as the same double;
/// - each text as a string variable, LaTeX where it becomes a label;
/// - `width_cm` and `height_cm`.
///
/// The names of blocks, numbers and texts are identifiers of gnuplot (letters, digits and
/// underscores, no digit first) and differ from one another.
struct Figure {
  double width_cm = 0;
  double height_cm = 0;
  std::map<std::string, FigureData> data = {};
  std::map<std::string, double> numbers = {};
  std::map<std::string, std::string> texts = {};
};

/// Throws std::invalid_argument for what no script could read: a size that is not positive, a name
/// that is no identifier or is given twice, a block without columns or points, columns of unequal
/// length or equal names, a number that is neither finite nor a gap, a text of several lines.
void require_drawable(const Figure& figure);

/// The prelude, data.gp, that gnuplot reads before the figure's script: terminal, output NAME.tex
/// with NAME.pdf, separators, variables. gnuplot has to run in the folder of the figure.
std::string figure_prelude(const std::string& name, const Figure& figure);

/// A block as CSV, with the names of its columns in the first line. Numbers are written as whole
/// numbers with an exponent, 125e-2, which read back as the same doubles under any decimal sign.
std::string figure_csv(const FigureData& data);

}  // namespace literate
