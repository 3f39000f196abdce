// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/column.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"

namespace literate {
namespace {

[[noreturn]] void refuse(const Place& place, std::string_view heading, std::string_view why) {
  fail_at(place, fmt::format("column '{}': {}", heading, why));
}

std::string heading_of(const std::string& heading, const Place& place) {
  try {
    return author_latex(heading);
  } catch (const std::invalid_argument& error) {
    refuse(place, heading, error.what());
  }
}

}  // namespace

Column::Column(std::string heading, const Format& numbers, std::string unit, const Place& place)
    : heading_(heading_of(heading, place)), numbers_(numbers), unit_(std::move(unit)) {
  const Notation notation = numbers.notation();
  is_exact_ = notation == Notation::integer || notation == Notation::exact;
  try {
    if (plain_unit(unit_).empty()) unit_.clear();
  } catch (const std::invalid_argument& error) {
    refuse(place, heading_, error.what());
  }
  if (numbers.is_percentage() && !unit_.empty()) {
    refuse(place, heading_, fmt::format("a percentage has no other unit, such as {}", unit_));
  }
  if (numbers.rounds_up() && notation == Notation::significant) {
    refuse(place, heading_, "only scientific() and fixed() numbers of a column round up");
  }
}

Column Column::text(std::string heading, double width_cm, const Place& place) {
  Column column;
  column.heading_ = heading_of(heading, place);
  column.width_cm_ = width_cm;
  if (!(std::isfinite(width_cm) && width_cm >= 0)) {
    refuse(place, heading, fmt::format("a width of {} cm", width_cm));
  }
  return column;
}

Column Column::scaled(int exponent, const Place& place) const {
  if (!numbers_ || numbers_->notation() != Notation::fixed || numbers_->rounds_up()) {
    refuse(place, heading_,
           "only fixed() numbers are scaled: fixed(3) has three digits after the point of the "
           "scaled number");
  }
  Column column = *this;
  column.exponent_ = exponent;
  return column;
}

Column Column::exact() const {
  Column column = *this;
  column.is_exact_ = true;
  return column;
}

Column Column::under(std::string group, const Place& place) const {
  Column column = *this;
  column.group_ = heading_of(group, place);
  return column;
}

Cell::Cell(std::string_view text) : content_(latex_escaped(text)), given_(text) {}

Cell Cell::quoted(double number, int place) {
  Cell cell(number);
  cell.place_ = place;
  return cell;
}

Cell Cell::latex(std::string text) {
  Cell cell;
  cell.given_ = text;
  cell.content_ = std::move(text);
  cell.is_latex_ = true;
  return cell;
}

}  // namespace literate
