// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/element.hpp"

#include <cmath>
#include <numbers>

#include "elasticity/triangular_load.hpp"

namespace line_contact {
namespace {

// From this distance on, five terms of the series below are right to rounding.
constexpr double far = 16;

double times_log(double t) {
  return t == 0 ? 0 : t * std::log(std::abs(t));
}

// T(k) − ln k for k ≥ far, in powers of 1/k²:
//   triangular  −Σ 2 k^{−2m}/(2m(2m+1)(2m+2)),  uniform  −Σ (2k)^{−2m}/(2m(2m+1)),  m = 1, 2, …
double beyond_logarithm(Element element, double k) {
  const double e = 1 / (k * k);
  switch (element) {
    case Element::triangular:
      return -e * (1. / 12 + e * (1. / 60 + e * (1. / 168 + e * (1. / 360 + e / 660))));
    case Element::uniform:
      return -e * (1. / 24 + e * (1. / 320 + e * (1. / 2688 + e * (1. / 18432 + e / 112640))));
    case Element::point:
      break;
  }
  return 0;
}

// (k+1) ln|k+1| − 2k ln|k| + (k−1) ln|k−1|, beyond k = 1 by terms that hardly cancel.
double triangular_gradient(double k) {
  if (k <= 1) return times_log(k + 1) - 2 * times_log(k) + times_log(k - 1);
  return k * std::log1p(-1 / (k * k)) + std::log((k + 1) / (k - 1));
}

double uniform_coefficient(double k) {
  if (k <= 1) return times_log(k + 0.5) - times_log(k - 0.5) - 1;
  return std::log((k + 0.5) * (k - 0.5)) / 2 + k * std::log((k + 0.5) / (k - 0.5)) - 1;
}

double near_coefficient(Element element, double k) {
  switch (element) {
    case Element::triangular:
      return elasticity::triangular_potential(k, 1);
    case Element::uniform:
      return uniform_coefficient(k);
    case Element::point:
      break;
  }
  return k == 0 ? -std::log(2 * std::numbers::pi) : std::log(k);
}

}  // namespace

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
  k = std::abs(k);
  return k < far ? near_coefficient(element, k) : std::log(k) + beyond_logarithm(element, k);
}

double influence_difference(Element element, Eigen::Index k) {
  const auto here = static_cast<double>(k);
  if (here < far) {
    // the slope of a triangle of pressure is that of two uniform pressures of opposite sign
    if (element == Element::uniform) return triangular_gradient(here + 0.5);
    return influence_coefficient(element, here + 1) - influence_coefficient(element, here);
  }
  return std::log1p(1 / here) +
         (beyond_logarithm(element, here + 1) - beyond_logarithm(element, here));
}

}  // namespace line_contact
