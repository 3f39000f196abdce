// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/cell.hpp"

#include <utility>

#include "literate/text/latex.hpp"

namespace literate {

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
