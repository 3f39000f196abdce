// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/column_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "literate/decimal.hpp"

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
  if (column_.kind_ == Column::Kind::text) return "l";
  std::string format = width_.negative ? "-" : "";
  format += fmt::format("{}", width_.n_integer);
  if (width_.n_decimals > 0) format += fmt::format(".{}", width_.n_decimals);
  if (width_.n_exponent > 0) {
    format += fmt::format("e{}{}", width_.negative_exponent ? "-" : "", width_.n_exponent);
  }
  return fmt::format("S[table-format={}]", format);
}

std::string ColumnWriter::heading() const {
  return fmt::format("{{{}}}", column_.heading());
}

std::string ColumnWriter::unit() const {
  const std::string& unit = column_.unit();
  if (exponent_ == 0) return unit.empty() ? "" : fmt::format("{{(\\unit{{{}}})}}", unit);
  if (unit.empty()) return fmt::format("{{(\\num{{e{}}})}}", exponent_);
  return fmt::format("{{(\\qty{{e{}}}{{{}}})}}", exponent_, unit);
}

std::string ColumnWriter::written(const Cell& cell) {
  const bool is_text_column = column_.kind_ == Column::Kind::text;
  if (cell.is_empty()) return "";
  if (cell.text()) return is_text_column ? *cell.text() : fmt::format("{{{}}}", *cell.text());
  if (is_text_column) {
    throw std::invalid_argument(
        fmt::format("column '{}' holds text, not numbers", column_.heading()));
  }
  const std::string number = number_text(cell);
  widen_for(number);
  return number;
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

void ColumnWriter::widen_for(std::string_view number) {
  if (number.front() == '-') {
    width_.negative = true;
    number.remove_prefix(1);
  }
  const auto e = number.find('e');
  const auto mantissa = number.substr(0, e);
  const auto point = mantissa.find('.');
  width_.n_integer = std::max(width_.n_integer, mantissa.substr(0, point).size());
  if (point != std::string_view::npos) {
    width_.n_decimals = std::max(width_.n_decimals, mantissa.size() - point - 1);
  }
  if (e == std::string_view::npos) return;
  auto exponent = number.substr(e + 1);
  if (exponent.front() == '-') {
    width_.negative_exponent = true;
    exponent.remove_prefix(1);
  }
  width_.n_exponent = std::max(width_.n_exponent, exponent.size());
}

}  // namespace literate
