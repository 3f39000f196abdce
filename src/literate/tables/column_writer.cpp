// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/column_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "literate/values/decimal.hpp"

namespace literate {
namespace {

/// The power of ten of the largest number, as it prints with `n_digits` digits.
int common_exponent_of(const std::vector<const Cell*>& cells, int n_digits) {
  double largest = 0;
  for (const Cell* cell : cells) {
    if (const double* number = cell->number()) largest = std::max(largest, std::abs(*number));
  }
  return leading_place(rounded_to_digits(largest, n_digits)) * (largest > 0 ? 1 : 0);
}

}  // namespace

ColumnWriter::ColumnWriter(const Column& column, const std::vector<const Cell*>& cells)
    : column_(column), exponent_(column.exponent_), decimals_(column.digits_) {
  if (column.kind_ == Column::Kind::common_exponent) {
    exponent_ = common_exponent_of(cells, column.digits_);
    decimals_ = column.digits_ - 1;
  }
  for (const Cell* cell : cells) cells_.push_back(written(*cell));
}

std::string ColumnWriter::specification() const {
  return column_.kind_ == Column::Kind::text ? "l" : "c";
}

std::string ColumnWriter::cell(std::size_t row) const {
  const Written& cell = cells_[row];
  if (!cell.is_number) return cell.text;
  return fmt::format("\\LiterateCell{{{}}}{{{}}}{{{}}}", table_format(width_), cell.text,
                     aligned_number(cell.text, width_));
}

std::string ColumnWriter::heading() const {
  return column_.heading();
}

std::string ColumnWriter::unit() const {
  const std::string& unit = column_.unit();
  if (exponent_ == 0) return unit.empty() ? "" : fmt::format("(\\unit{{{}}})", unit);
  if (unit.empty()) return fmt::format("(\\num{{e{}}})", exponent_);
  return fmt::format("(\\qty{{e{}}}{{{}}})", exponent_, unit);
}

ColumnWriter::Written ColumnWriter::written(const Cell& cell) {
  if (cell.is_empty()) return {};
  if (cell.text()) return {*cell.text()};
  if (column_.kind_ == Column::Kind::text) {
    throw std::invalid_argument(
        fmt::format("column '{}' holds text, not numbers", column_.heading()));
  }
  const std::string number = number_text(cell);
  width_ = widest(width_, width_of(number));
  return {number, true};
}

std::string ColumnWriter::number_text(const Cell& cell) const {
  const double number = *cell.number();
  if (column_.kind_ == Column::Kind::scientific) {
    return scientific(cell.place() ? rounded_to_place(number, *cell.place())
                                   : rounded_to_digits(number, decimals_));
  }
  if (column_.kind_ == Column::Kind::integer && std::trunc(number) != number) {
    throw std::invalid_argument(fmt::format("column '{}': {} is not a whole number",
                                            column_.heading(), round_trip(number)));
  }
  // Moving the point, unlike a division, leaves one rounding.
  Decimal decimal = rounded_to_place(number, cell.place().value_or(exponent_ - decimals_));
  decimal.place -= exponent_;
  return plain(decimal);
}

}  // namespace literate
