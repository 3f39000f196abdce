// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/column.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "literate/text/unit.hpp"

namespace literate {
namespace {

bool prints_all_digits(const Format& numbers) {
  return numbers.notation() == Notation::integer || numbers.notation() == Notation::exact;
}

}  // namespace

Column::Column(ColumnFormat format) : format_(std::move(format)) {
  if (plain_unit(format_.unit).empty()) format_.unit.clear();
  const auto& numbers = format_.numbers;
  if (numbers && numbers->is_percentage() && !format_.unit.empty()) {
    throw std::invalid_argument(
        fmt::format("column '{}' is in per cent and has no other unit, such as '{}'",
                    format_.heading, format_.unit));
  }
  if (numbers && numbers->rounds_up() && numbers->notation() == Notation::significant) {
    throw std::invalid_argument(fmt::format(
        "column '{}': only scientific() and fixed() numbers round up", format_.heading));
  }
}

Column::Column(std::string heading, const Format& numbers, std::string unit)
    : Column(ColumnFormat{.heading = std::move(heading),
                          .numbers = numbers,
                          .unit = std::move(unit),
                          .is_exact = prints_all_digits(numbers)}) {}

Column Column::text(std::string heading, double width_cm) {
  if (!(std::isfinite(width_cm) && width_cm >= 0)) {
    throw std::invalid_argument(fmt::format("column '{}': a width of {} cm", heading, width_cm));
  }
  return Column(ColumnFormat{
      .heading = std::move(heading), .numbers = std::nullopt, .unit = "", .width_cm = width_cm});
}

Column Column::scaled(int exponent) const {
  if (!format_.numbers || format_.numbers->notation() != Notation::fixed ||
      format_.numbers->rounds_up()) {
    throw std::invalid_argument(
        fmt::format("column '{}': only fixed() numbers can be scaled", format_.heading));
  }
  Column column = *this;
  column.format_.exponent = exponent;
  return column;
}

Column Column::exact() const {
  Column column = *this;
  column.format_.is_exact = true;
  return column;
}

Column Column::under(std::string group) const {
  Column column = *this;
  column.format_.group = std::move(group);
  return column;
}

}  // namespace literate
