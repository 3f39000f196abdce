// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "elasticity/material.hpp"
#include "elasticity/triangular_load.hpp"

namespace assignment {
namespace {

// The slope's bracket as it stands in eq. (3).
double three_terms(double xi) {
  const double above = xi + 1;
  const double below = xi - 1;
  return above * std::log(above) + below * std::log(below) - 2 * xi * std::log(xi);
}

}  // namespace

literate::Figure setting() {
  // Five triangles at neighbouring nodes, with a gap after each, and the sum of their pressures.
  const std::vector<double> node = {-3, -2, -1, 0, 1, 2, 3};
  const std::vector<double> height = {0, 0.62, 0.9, 1, 0.9, 0.62, 0};
  std::vector<double> x;
  std::vector<double> p;
  for (std::size_t j = 1; j + 1 < node.size(); ++j) {
    x.insert(x.end(), {node[j] - 1, node[j], node[j] + 1, node[j] + 1});
    p.insert(p.end(), {0, height[j], 0, literate::gap});
  }
  return {.width_cm = 15.5,
          .height_cm = 3.5,
          .data = {{"triangle", {{"x", {-1, 0, 1}}, {"p", {0, 1, 0}}}},
                   {"row", {{"x", x}, {"p", p}}},
                   {"sum", {{"x", node}, {"p", height}}}}};
}

literate::Figure lost_digits() {
  // A unit load on a body without Poisson's ratio whose slope is the bracket itself.
  const elasticity::Material material(2 / std::numbers::pi, 0);
  const elasticity::TriangularLoad load(1, 1);
  std::vector<double> distance;
  std::vector<double> error;
  for (double exponent = 0.2; exponent <= 8; exponent += 0.025) {
    const double xi = std::pow(10, exponent);
    const double exact = -elasticity::normal_gradient(material, load, xi);
    distance.push_back(xi);
    error.push_back(std::max(1e-16, std::abs(three_terms(xi) / exact - 1)));
  }
  return {.width_cm = 13.5,
          .height_cm = 4.8,
          .data = {{"slope", {{"distance", distance}, {"error", error}}}}};
}

}  // namespace assignment
