// SPDX-License-Identifier: GPL-3.0-or-later
// Two methods and matrix inversion, two kinds of elements, one contact.
#include "point_contact/methods.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "contact/reference_methods.hpp"
#include "numbers.hpp"
#include "point_contact/cases.hpp"

BOOST_AUTO_TEST_SUITE(methods_test)

using namespace point_cases;
using Eigen::Index;
using Eigen::VectorXd;
using point_contact::Solution;
using point_contact::solve_by_variational_method;
using point_contact::solve_for_load;
using tolerance::relative_difference;

namespace {

double difference(const VectorXd& a, const VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.maxCoeff();
}

// The nodal pressures and the approach by matrix inversion, which uses neither FFT nor nested
// grids.
struct Inverted {
  VectorXd pressure, gap;
  double approach;
};
Inverted inverted(const Problem& problem) {
  const Grid& grid = problem.grid;
  const double total = point_contact::total_phi(problem, load);
  const auto influence = [&](Index i, Index j) {
    return -influence_coefficient(problem.element,
                                  {static_cast<double>(i % grid.n1 - j % grid.n1),
                                   static_cast<double>(i / grid.n1 - j / grid.n1)});
  };
  const contact::ContactLoads loads =
      contact::invert({initial_gaps(problem), total, 1e-14 * total}, influence);
  return {std::numbers::pi * modulus / grid.spacing * loads.phi, loads.gap, loads.approach};
}

// Root mean square of p − Hertz over r ≤ 0.8 a, relative to the peak.
double error_inside(const Solution& s) {
  double squares = 0;
  double n_inside = 0;
  for (Index j = 0; j < s.grid.n2; ++j) {
    for (Index i = 0; i < s.grid.n1; ++i) {
      const double r = s.grid.node(i, j).norm();
      if (r > 0.8 * hertz.radius()) continue;
      squares += std::pow(s.pressure[s.grid.index(i, j)] - hertz.pressure(r), 2);
      n_inside += 1;
    }
  }
  return std::sqrt(squares / n_inside) / hertz.peak_pressure();
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_methods_find_the_pressure_gap_and_approach_of_matrix_inversion) {
  for (const auto& c : cases) {
    for (const Element element : elements) {
      for (const Index n : {18, 25}) {
        const Problem problem = problem_of(c, n, element);
        const Inverted exact = inverted(problem);
        const Solution fast = solve_for_load(problem, load, 1e-12);
        const Solution least = solve_by_variational_method(problem, load, 1e-11);
        BOOST_TEST_CONTEXT(c.name << ", " << name_of(element) << ", " << n) {
          BOOST_TEST(fast.n_in_contact() == (exact.pressure.array() > 0).count());
          BOOST_TEST(difference(fast.pressure, exact.pressure) < 1e-11);
          BOOST_TEST(difference(fast.gap, exact.gap) < 1e-11);
          BOOST_TEST(relative_difference(fast.approach, exact.approach) < 1e-11);
          BOOST_TEST(difference(least.pressure, exact.pressure) < 1e-9);
          BOOST_TEST(relative_difference(least.approach, exact.approach) < 1e-10);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_conditions_of_contact_hold) {
  for (const auto& c : cases) {
    const Solution s = solve_for_load(problem_of(c, 128), load);
    const double length = s.peak_pressure() * s.grid.spacing / modulus;
    BOOST_TEST_CONTEXT(c.name) {
      BOOST_TEST(s.pressure.minCoeff() == 0);
      BOOST_TEST(s.residuals.gap < 1e-7 * length);
      BOOST_TEST(s.residuals.separation < 1e-7 * length);
      BOOST_TEST(s.residuals.pressure <= 1e-8 * s.peak_pressure());
      BOOST_TEST(relative_difference(s.load(), load) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(spheres_approach_hertz_with_order_two) {
  for (const Element element : elements) {
    double before = 0;
    for (const Index n : {64, 128, 256}) {
      // The mean of a few grids: single errors scatter with the position of the edge between nodes.
      double inside = 0, peak = 0;
      for (const Index more : {0, 3, 7}) {
        const Solution s = solve_for_load(spheres_on(n + more, element), load, 1e-9);
        inside += error_inside(s) / 3;
        peak += std::abs(s.peak_pressure() / hertz.peak_pressure() - 1) / 3;
      }
      BOOST_TEST_CONTEXT(name_of(element) << ", n = " << n) {
        const double square = std::pow(2.5 / static_cast<double>(n), 2);  // (c/a)²
        BOOST_TEST(inside < 0.3 * square);
        BOOST_TEST(peak < 0.4 * square);
        if (before > 0) BOOST_TEST(std::abs(std::log2(before / inside) - 2) < 0.35);
      }
      before = inside;
    }
  }
}

BOOST_AUTO_TEST_CASE(bodies_of_any_shape_approach_their_closed_forms) {
  const Solution sphere = solve_for_load(spheres_on(256), load);
  BOOST_TEST(relative_difference(sphere.semi_axes()[0], hertz.radius()) < 1e-4);
  BOOST_TEST(relative_difference(sphere.semi_axes()[1], hertz.radius()) < 1e-4);
  BOOST_TEST(relative_difference(sphere.approach, hertz.approach()) < 2e-5);

  const Solution oval = solve_for_load(problem_of(cases[1], 256), load);
  BOOST_TEST(oval.grid.n2 < oval.grid.n1 / 2);
  BOOST_TEST(relative_difference(oval.semi_axes()[0], ellipse.semi_axis_x()) < 3e-4);
  BOOST_TEST(relative_difference(oval.semi_axes()[1], ellipse.semi_axis_y()) < 3e-4);
  BOOST_TEST(relative_difference(oval.peak_pressure(), ellipse.peak_pressure()) < 1e-4);
  BOOST_TEST(relative_difference(oval.approach, ellipse.approach()) < 5e-5);

  // The sphere as a measured surface.
  const double spacing = 2.6 * hertz.radius() / 100;
  const Eigen::ArrayXXd heights = Eigen::ArrayXXd::NullaryExpr(101, 101, [&](Index i, Index j) {
    return curvature / 2 * spacing * spacing *
           static_cast<double>((i - 50) * (i - 50) + (j - 50) * (j - 50));
  });
  Problem measured = spheres_on(100);
  measured.profile = Profile::height_map(heights, spacing);
  BOOST_TEST(difference(solve_for_load(measured, load).pressure,
                        solve_for_load(spheres_on(100), load).pressure) < 1e-7);
}

BOOST_AUTO_TEST_CASE(other_units_of_length_and_stress_change_nothing) {
  const double length = 2.54e-2, stress = 6.895e3;
  Problem scaled = spheres_on(64);
  scaled.profile = Profile::paraboloid(curvature / length);
  scaled.contact_modulus *= stress;
  scaled.grid.spacing *= length;
  const Solution theirs = solve_for_load(scaled, load * stress * length * length);
  const Solution ours = solve_for_load(spheres_on(64), load);
  BOOST_TEST(difference(theirs.pressure / stress, ours.pressure) < 1e-9);
  BOOST_TEST(relative_difference(theirs.approach / length, ours.approach) < 1e-9);
}

BOOST_AUTO_TEST_CASE(pressures_are_accurate_to_the_tolerance) {
  for (const auto& c : cases) {
    const Problem problem = problem_of(c, 100);
    const Solution best = solve_for_load(problem, load, point_contact::min_tolerance);
    for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
      const Solution s = solve_for_load(problem, load, tolerance);
      BOOST_TEST_CONTEXT(c.name << ", tolerance " << tolerance) {
        BOOST_TEST(difference(s.pressure, best.pressure) < tolerance);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(products_on_the_finest_grid_do_not_increase_with_its_nodes) {
  for (const Index n : {64, 128, 256, 512}) {
    const Solution s = solve_for_load(spheres_on(n), load);
    BOOST_TEST_CONTEXT("n = " << n) {
      BOOST_TEST(s.work.products <= 20);
      BOOST_TEST(s.work.preconditionings <= 26);
      BOOST_TEST(s.work.revisions <= 5);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
