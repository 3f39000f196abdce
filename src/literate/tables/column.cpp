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

[[noreturn]] void refuse(const ColumnFormat& column, const Column::Location& location,
                         const std::string& why) {
  throw std::invalid_argument(fmt::format("{}:{}: column '{}': {}", location.file_name(),
                                          location.line(), column.name(), why));
}

std::string unit_of(const ColumnFormat& column, const Column::Location& location) {
  try {
    return plain_unit(column.unit).empty() ? "" : column.unit;
  } catch (const std::invalid_argument& error) {
    refuse(column, location, error.what());
  }
}

}  // namespace

Column::Column(ColumnFormat format, const Location& location) : format_(std::move(format)) {
  format_.unit = unit_of(format_, location);
  const auto& numbers = format_.numbers;
  if (numbers && numbers->is_percentage() && !format_.unit.empty()) {
    refuse(format_, location,
           fmt::format("it is in per cent and has no other unit, such as '{}'", format_.unit));
  }
  if (numbers && numbers->rounds_up() && numbers->notation() == Notation::significant) {
    refuse(format_, location, "only scientific() and fixed() numbers round up");
  }
}

Column::Column(std::string heading, const Format& numbers, std::string unit, Location location)
    : Column(ColumnFormat{.heading = std::move(heading),
                          .numbers = numbers,
                          .unit = std::move(unit),
                          .is_exact = prints_all_digits(numbers)},
             location) {}

Column Column::text(std::string heading, double width_cm, Location location) {
  ColumnFormat format{
      .heading = std::move(heading), .numbers = std::nullopt, .unit = "", .width_cm = width_cm};
  if (!(std::isfinite(width_cm) && width_cm >= 0)) {
    refuse(format, location, fmt::format("a width of {} cm", width_cm));
  }
  return {std::move(format), location};
}

Column Column::scaled(int exponent, Location location) const {
  if (!format_.numbers || format_.numbers->notation() != Notation::fixed ||
      format_.numbers->rounds_up()) {
    refuse(format_, location,
           "only fixed() numbers are scaled: fixed(3) has three digits behind the point of the "
           "scaled number");
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

Column Column::named(std::string plain) const {
  Column column = *this;
  column.format_.plain = std::move(plain);
  return column;
}

Column Column::under(std::string group) const {
  Column column = *this;
  column.format_.group = std::move(group);
  return column;
}

}  // namespace literate
