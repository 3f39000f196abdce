// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/edge_study.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

BOOST_AUTO_TEST_SUITE(edge_study_test)

namespace {

parameters::ContactCase cylinders() {
  const elasticity::Material steel(206e3, 0.28);
  const elasticity::Material aluminium(71.5e3, 0.345);
  const auto radius1 = line_contact::Radius::of_cylinder("radius1", 23.85);
  const auto radius2 = line_contact::Radius::of_cylinder("radius2", 71);
  return {{steel, radius1},
          {aluminium, radius2},
          {steel, radius1, aluminium, radius2},
          781,
          10,
          91,
          {},
          {}};
}

// Nodes that end on the edge of Hertz and lie closer there.
std::vector<double> nodes(double half_width, int n) {
  std::vector<double> x;
  for (int j = -n; j <= n; ++j) x.push_back(half_width * std::sin(std::numbers::pi / 2 * j / n));
  return x;
}

}  // namespace

BOOST_AUTO_TEST_CASE(triangles_on_unequal_nodes_carry_the_load) {
  const parameters::ContactCase c = cylinders();
  const line_contact::Hertz hertz(c.cylinders, c.line_load);
  const std::vector<double> x = nodes(hertz.half_width(), 31);

  const std::vector<double> pressure = paper::pressures_on_nodes(c, x);

  double load = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    load += (pressure[i] + pressure[i + 1]) / 2 * (x[i + 1] - x[i]);
  }
  BOOST_TEST(load == c.line_load, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(pressure.front() == 0);
  BOOST_TEST(pressure.back() == 0);
}

BOOST_AUTO_TEST_CASE(twice_as_many_graded_triangles_halve_the_largest_error) {
  const parameters::ContactCase c = cylinders();
  const line_contact::Hertz hertz(c.cylinders, c.line_load);
  const auto largest_error = [&](int n) {
    const std::vector<double> x = nodes(hertz.half_width(), n);
    const std::vector<double> pressure = paper::pressures_on_nodes(c, x);
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      largest = std::max(largest, std::abs(pressure[i] - hertz.pressure(x[i])));
    }
    return largest / hertz.peak_pressure();
  };

  BOOST_TEST(largest_error(20) < 0.02);
  BOOST_TEST(std::abs(largest_error(20) / largest_error(40) - 2) < 0.2);
}

BOOST_AUTO_TEST_SUITE_END()
