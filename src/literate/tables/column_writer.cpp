// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/column_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "literate/values/decimal.hpp"

namespace literate {
namespace {

/// The power of ten of the largest magnitude after rounding to `n_digits` digits.
int common_exponent_of(const std::vector<const Cell*>& cells, int n_digits) {
  double largest = 0;
  for (const Cell* cell : cells) {
    if (const double* number = cell->number()) largest = std::max(largest, std::abs(*number));
  }
  return leading_place(rounded_to_digits(largest, n_digits)) * (largest > 0 ? 1 : 0);
}

}  // namespace

ColumnWriter::ColumnWriter(ColumnFormat format, const std::vector<const Cell*>& cells)
    : format_(std::move(format)) {
  if (format_.kind == ColumnKind::common_exponent) {
    format_.exponent = common_exponent_of(cells, format_.digits);
    format_.kind = ColumnKind::fixed;
    --format_.digits;  // one of them stands before the point
  }
  for (const Cell* cell : cells) cells_.push_back(written(*cell));
}

std::string ColumnWriter::specification() const {
  return format_.kind == ColumnKind::text ? "l" : "c";
}

std::string ColumnWriter::cell(std::size_t row) const {
  const Written& cell = cells_[row];
  if (!cell.is_number) return cell.text;
  return fmt::format("\\LiterateCell{{{}}}{{{}}}{{{}}}", table_format(width_), cell.text,
                     aligned_number(cell.text, width_));
}

std::string ColumnWriter::heading() const {
  return format_.heading;
}

std::string ColumnWriter::unit() const {
  const std::string& unit = format_.unit;
  if (format_.exponent == 0) return unit.empty() ? "" : fmt::format("(\\unit{{{}}})", unit);
  if (unit.empty()) return fmt::format("(\\num{{e{}}})", format_.exponent);
  return fmt::format("(\\qty{{e{}}}{{{}}})", format_.exponent, unit);
}

ColumnWriter::Written ColumnWriter::written(const Cell& cell) {
  if (cell.is_empty()) return {};
  if (cell.text()) return {*cell.text()};
  if (format_.kind == ColumnKind::text) {
    throw std::invalid_argument(
        fmt::format("column '{}' holds text, not numbers", format_.heading));
  }
  const std::string number = number_text(cell);
  width_ = widest(width_, width_of(number));
  return {number, true};
}

std::string ColumnWriter::number_text(const Cell& cell) const {
  const double number = *cell.number();
  if (format_.kind == ColumnKind::scientific) {
    return scientific(cell.place() ? rounded_to_place(number, *cell.place())
                                   : rounded_to_digits(number, format_.digits));
  }
  if (format_.kind == ColumnKind::integer && std::trunc(number) != number) {
    throw std::invalid_argument(
        fmt::format("column '{}': {} is not a whole number", format_.heading, round_trip(number)));
  }
  // Moving the decimal point is exact, so the number is rounded only once; dividing it would round
  // it again.
  Decimal decimal =
      rounded_to_place(number, cell.place().value_or(format_.exponent - format_.digits));
  decimal.place -= format_.exponent;
  return plain(decimal);
}

}  // namespace literate
