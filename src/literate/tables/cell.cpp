// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/cell.hpp"

#include <utility>

#include "literate/text/latex.hpp"

namespace literate {

Cell::Cell(std::string_view text) : content_(escape_latex(text)) {}

Cell Cell::to_place(double number, int place) {
  Cell cell(number);
  cell.place_ = place;
  return cell;
}

Cell Cell::latex(std::string text) {
  Cell cell;
  cell.content_ = std::move(text);
  return cell;
}

}  // namespace literate
