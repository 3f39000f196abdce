// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/cell.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "literate/text/latex.hpp"
#include "literate/values/format.hpp"

namespace literate {

Cell::Cell(std::string_view text) : content_(escape_latex(text)), plain_(text) {}

Cell Cell::quoted(double number, int place, const std::optional<Uncertainty>& uncertainty) {
  const double printed = number_of(rounded_to_place(number, place));
  // A decimal number that was read as a double is off by half a rounding; two more may come from
  // arithmetic such as 5 · 0.01.
  constexpr double of_reading = 4 * std::numeric_limits<double>::epsilon();
  if (std::abs(printed - number) > of_reading * std::abs(number)) {
    throw std::invalid_argument(fmt::format("{} has more digits than one quoted to the place 1e{}",
                                            round_trip(number), place));
  }
  Cell cell(number);
  cell.uncertainty_ = uncertainty;
  cell.place_ = std::max(place, least_earned_place(cell.error()).value_or(place));
  return cell;
}

Cell Cell::latex(std::string text) {
  Cell cell;
  cell.content_ = std::move(text);
  return cell;
}

Cell Cell::marked(std::string mark) const {
  Cell cell = *this;
  cell.mark_ = std::move(mark);
  return cell;
}

}  // namespace literate
