// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 4: your tests of any influence_coefficient, for instance
//
//   check(influence_coefficient(1e11, 1e-5, 0.1, 0) > 0, "the surface sinks under the load");
//
// A right function may differ from yours by roundings: compare within a tolerance.
#include <cmath>

#include "tested.hpp"

using namespace tested;

void tests() {
  // BEGIN SOLUTION
  const double modulus = 1.1e11;
  const double c = 8e-6;
  const auto a = [&](int k, double spacing = 8e-6) {
    return influence_coefficient(modulus, spacing, 0.25, k);
  };
  const auto is_near = [](double one, double other, double tolerance) {
    return std::abs(one - other) <= tolerance;
  };
  const double unit = 2 * c / (3.141592653589793 * modulus);

  check(is_near(a(3), a(-3), 1e-9 * a(3)), "the same on both sides");
  check(is_near(a(0) - a(1), 2 * std::log(2.0) * unit, 1e-7 * unit), "the nearest neighbour");
  check(is_near(a(1) - a(2), (4.5 * std::log(3.0) - 6 * std::log(2.0)) * unit, 1e-7 * unit),
        "the next one");
  const double halved = a(0, 2 * c) - a(1, 2 * c);
  const double composed = a(0) + a(1) - (a(1) / 2 + a(2) + a(3) / 2);
  check(is_near(halved, composed, 1e-6 * unit), "one large triangle is three small ones");
  check(is_near(influence_coefficient(modulus, c, 10 * c, 10), 0, 1e-9 * unit),
        "zero at a datum nearby");
  // END SOLUTION
}
