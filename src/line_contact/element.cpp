// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/element.hpp"

#include <cmath>
#include <numbers>

#include "elasticity/line_potential.hpp"

namespace line_contact {

std::string_view name_of(Element element) {
  switch (element) {
    case Element::point:
      return "point";
    case Element::uniform:
      return "uniform";
    case Element::triangular:
      break;
  }
  return "triangular";
}

double influence_coefficient(Element element, double k) {
  switch (element) {
    case Element::triangular:
      return elasticity::triangle_potential(k);
    case Element::uniform:
      return elasticity::strip_potential(k);
    case Element::point:
      break;
  }
  return k == 0 ? -std::log(2 * std::numbers::pi) : std::log(std::abs(k));
}

double influence_difference(Element element, Eigen::Index k) {
  const auto here = static_cast<double>(k);
  switch (element) {
    case Element::triangular:
      return elasticity::triangle_rise(here);
    case Element::uniform:
      return elasticity::strip_rise(here);
    case Element::point:
      break;
  }
  return k == 0 ? -influence_coefficient(element, 0) : std::log1p(1 / here);
}

}  // namespace line_contact
