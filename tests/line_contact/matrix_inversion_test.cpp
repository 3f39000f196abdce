// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/dense_methods.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/surface_quadrature.hpp"
#include "line_contact/cylinders.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(matrix_inversion_test)

using contact::Residuals;
using elasticity::Material;
using line_contact::CylinderPair;
using line_contact::Element;
using line_contact::Grid;
using line_contact::grid_around;
using line_contact::grid_of_width;
using line_contact::Hertz;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::Radius;
using line_contact::Solution;
using line_contact::solve_by_matrix_inversion;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

const Material steel(30e6, 0.3);
const CylinderPair paper(steel, Radius::of_cylinder("radius1", 1), steel,
                         Radius::of_cylinder("radius2", 3));
constexpr double load = 2500;

Problem problem_on(const Grid& grid, const CylinderPair& cylinders = paper,
                   Element element = Element::triangular) {
  return {cylinders.profile(), cylinders.contact_modulus(), grid, element};
}

Solution solve(const CylinderPair& cylinders, Eigen::Index n_nodes,
               Element element = Element::triangular) {
  const Grid grid = grid_around(Hertz(cylinders, load).half_width(), n_nodes);
  return solve_by_matrix_inversion(problem_on(grid, cylinders, element), load);
}

}  // namespace

BOOST_AUTO_TEST_CASE(forty_elements_give_the_hertz_peak_to_1e_4_and_half_width_to_2e_4) {
  const Hertz hertz(paper, load);
  const Solution solution = solve(paper, 91);

  BOOST_TEST(relative_difference(solution.peak_pressure(), hertz.peak_pressure()) < 1e-4);
  BOOST_TEST(relative_difference(solution.half_width(), hertz.half_width()) < 2e-4);
}

BOOST_AUTO_TEST_CASE(any_materials_and_radii_agree_with_hertz) {
  RandomInputs random(41);
  for (int i = 0; i < 30; ++i) {
    const double radius1 = random.log_uniform(0.1, 100);
    const double radius2 = i % 3 == 0 ? -2 * radius1 : random.log_uniform(0.1, 100);
    const CylinderPair cylinders(
        Material(random.log_uniform(1e5, 1e8), random.uniform(-0.5, 0.49)),
        Radius::of_cylinder("radius1", radius1),
        Material(random.log_uniform(1e5, 1e8), random.uniform(-0.5, 0.49)),
        i % 3 == 1 ? Radius::of_plane() : Radius::of_cylinder("radius2", radius2));
    const Hertz hertz(cylinders, load);
    const Solution solution = solve(cylinders, 91);
    BOOST_TEST(relative_difference(solution.peak_pressure(), hertz.peak_pressure()) < 1e-4);
    BOOST_TEST(relative_difference(solution.half_width(), hertz.half_width()) < 2e-4);
  }
}

BOOST_AUTO_TEST_CASE(the_conditions_of_contact_hold_to_rounding) {
  const Solution solution = solve(paper, 181);
  const double indentation = paper.profile().gap(solution.half_width());

  BOOST_TEST(solution.residuals.gap < 1e-12 * indentation);
  BOOST_TEST(solution.residuals.separation < 1e-12 * indentation);
  BOOST_TEST(solution.residuals.pressure < 1e-11 * solution.peak_pressure());
  BOOST_TEST(solution.residuals.load < 1e-13 * load);
}

BOOST_AUTO_TEST_CASE(outside_the_contact_there_is_no_pressure_and_inside_no_gap) {
  const Solution solution = solve(paper, 91);
  const double indentation = paper.profile().gap(solution.half_width());
  for (Eigen::Index i = 0; i < solution.grid.n_nodes; ++i) {
    const bool in_contact = solution.pressure[i] > 0;
    BOOST_TEST((in_contact || solution.pressure[i] == 0));
    BOOST_TEST(
        (in_contact ? std::abs(solution.gap[i]) < 1e-12 * indentation : solution.gap[i] > 0));
  }
}

BOOST_AUTO_TEST_CASE(the_gap_is_that_of_the_pressures_by_quadrature) {
  // u_z1 + u_z2 + h − δ at nodes in and out of contact, from the piecewise linear pressure itself,
  // by the logarithmic kernel and for both bodies; δ relative to a point 1 in away.
  const Material rubber(2e6, 0.45);
  const CylinderPair unlike(steel, Radius::of_cylinder("radius1", 1), rubber,
                            Radius::of_cylinder("radius2", 3));
  const Solution s = solve(unlike, 21);
  std::vector<numerics::Piece> pieces;
  for (Eigen::Index i = 0; i + 1 < s.grid.n_nodes; ++i) {
    const double begin = s.grid.x(i);
    const double left = s.pressure[i];
    const double slope = (s.pressure[i + 1] - left) / s.grid.spacing;
    pieces.push_back(
        {begin, s.grid.x(i + 1), [=](double x) { return left + slope * (x - begin); }});
  }
  elasticity::Load pressure;
  pressure.normal = numerics::PiecewiseFunction(pieces);
  const double datum = 1;
  const elasticity::SurfaceQuadrature body1(steel, pressure, datum);
  const elasticity::SurfaceQuadrature body2(rubber, pressure, datum);
  for (const Eigen::Index i : {0, 3, 10, 14, 20}) {
    const double x = s.grid.x(i);
    const double gap = body1.normal_displacement(x).value + body2.normal_displacement(x).value +
                       unlike.profile().gap(x) - s.approach(datum);
    BOOST_TEST(std::abs(gap - s.gap[i]) < 1e-11 * s.approach(datum));
  }
}

BOOST_AUTO_TEST_CASE(pressures_converge_to_hertz_inside_with_order_two) {
  // Away from the edge, where the error has order 1/2 only. The edge falls differently between the
  // nodes of each grid, which scatters the single errors: hence a fit over eight grids.
  const Hertz hertz(paper, load);
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  const int n_grids = 8;
  for (int k = 0; k < n_grids; ++k) {
    const Eigen::Index n_nodes = 2 * std::lround(12 * std::pow(1.5, k)) + 1;
    const Solution s = solve(paper, n_nodes);
    double squares = 0;
    int n_inside = 0;
    for (Eigen::Index i = 0; i < s.grid.n_nodes; ++i) {
      const double x = s.grid.x(i);
      if (std::abs(x) > 0.5 * hertz.half_width()) continue;
      squares += std::pow(s.pressure[i] / hertz.pressure(x) - 1, 2);
      ++n_inside;
    }
    const double log_c = std::log(s.grid.spacing);
    const double log_error = std::log(std::sqrt(squares / n_inside));
    sum_x += log_c;
    sum_y += log_error;
    sum_xx += log_c * log_c;
    sum_xy += log_c * log_error;
  }
  const double order = (n_grids * sum_xy - sum_x * sum_y) / (n_grids * sum_xx - sum_x * sum_x);

  BOOST_TEST(order > 1.5);
  BOOST_TEST(order < 2.5);
}

BOOST_AUTO_TEST_CASE(the_pressure_is_symmetric) {
  for (const Eigen::Index n_nodes : {40, 41}) {
    const Solution s = solve(paper, n_nodes);
    const double asymmetry = (s.pressure - s.pressure.reverse()).cwiseAbs().maxCoeff();
    BOOST_TEST(asymmetry < 1e-11 * s.peak_pressure());
  }
}

BOOST_AUTO_TEST_CASE(lengths_and_stresses_scale) {
  // All lengths ×25.4 and all stresses ×0.0069: the same numbers in other units.
  const double inch = 25.4;
  const double psi = 6.894757e-3;
  const CylinderPair metric(Material(30e6 * psi, 0.3), Radius::of_cylinder("radius1", inch),
                            Material(30e6 * psi, 0.3), Radius::of_cylinder("radius2", 3 * inch));
  const double metric_load = load * psi * inch;
  const Solution us = solve(paper, 41);
  const Grid grid = grid_around(Hertz(metric, metric_load).half_width(), 41);
  const Solution si = solve_by_matrix_inversion(problem_on(grid, metric), metric_load);

  BOOST_TEST(relative_difference(si.half_width(), us.half_width() * inch) < 1e-12);
  BOOST_TEST(relative_difference(si.peak_pressure(), us.peak_pressure() * psi) < 1e-12);
  BOOST_TEST(relative_difference(si.approach(inch), us.approach(1) * inch) < 1e-12);
}

BOOST_AUTO_TEST_CASE(each_factor_e_in_the_datum_adds_the_same_to_the_approach) {
  const Solution s = solve(paper, 41);
  const double step = 2 * load / (std::numbers::pi * paper.contact_modulus());

  BOOST_TEST(relative_difference(s.approach(std::exp(1.0)) - s.approach(1), step) < 1e-4);
  BOOST_TEST(relative_difference(s.approach(std::exp(9.0)) - s.approach(std::exp(8.0)), step) <
             1e-9);
}

BOOST_AUTO_TEST_CASE(a_contact_that_reaches_the_end_of_its_grid_is_refused) {
  const Grid too_narrow = grid_around(0.5 * Hertz(paper, load).half_width(), 41);

  BOOST_CHECK_EXCEPTION(solve_by_matrix_inversion(problem_on(too_narrow), load), InvalidQuantity,
                        [](const InvalidQuantity& e) { return e.quantity() == "domain"; });
}

BOOST_AUTO_TEST_CASE(loads_data_and_sizes_out_of_range_are_refused_by_name) {
  const Problem problem = problem_on(grid_around(0.012, 41));
  const auto names = [](const char* quantity) {
    return [=](const InvalidQuantity& e) { return e.quantity() == quantity; };
  };

  for (const double bad : {0.0, -1.0, double(NAN)}) {
    BOOST_CHECK_EXCEPTION(solve_by_matrix_inversion(problem, bad), InvalidQuantity, names("load"));
  }
  BOOST_CHECK_EXCEPTION(solve(paper, 41).approach(0.001), InvalidQuantity, names("datum"));
  BOOST_CHECK_EXCEPTION(
      solve_by_matrix_inversion(problem_on(grid_around(0.012, line_contact::max_dense_nodes + 1)),
                                load),
      InvalidQuantity, names("nodes"));
  Problem soft = problem;
  soft.contact_modulus = -1;
  BOOST_CHECK_EXCEPTION(solve_by_matrix_inversion(soft, load), InvalidQuantity,
                        names("contact_modulus"));
}

BOOST_AUTO_TEST_CASE(every_element_gives_the_hertz_peak_and_half_width) {
  const Hertz hertz(paper, load);
  for (const Element element : {Element::point, Element::uniform, Element::triangular}) {
    const Solution s = solve(paper, 91, element);

    BOOST_TEST_CONTEXT(name_of(element)) {
      BOOST_TEST((s.element == element));
      BOOST_TEST(relative_difference(s.peak_pressure(), hertz.peak_pressure()) < 5e-4);
      BOOST_TEST(relative_difference(s.half_width(), hertz.half_width()) < 5e-4);
    }
  }
}

BOOST_AUTO_TEST_CASE(one_side_with_its_mirror_image_is_the_same_contact) {
  const double width = 2.385 * Hertz(paper, load).half_width();
  for (const Element element : {Element::point, Element::uniform, Element::triangular}) {
    const Solution both =
        solve_by_matrix_inversion(problem_on(grid_of_width(width, 121), paper, element), load);
    const Solution half = solve_by_matrix_inversion(
        problem_on(line_contact::one_sided_grid(width, 61), paper, element), load);
    const double difference = (both.pressure.tail(61) - half.pressure).cwiseAbs().maxCoeff();

    BOOST_TEST_CONTEXT(name_of(element)) {
      BOOST_TEST(difference < 1e-12 * both.peak_pressure());
      BOOST_TEST((both.gap.tail(61) - half.gap).cwiseAbs().maxCoeff() <
                 1e-12 * half.gap.maxCoeff());
      BOOST_TEST(relative_difference(half.approach(1), both.approach(1)) < 1e-12);
      BOOST_TEST(half.residuals.load < 1e-13 * load);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_smaller_load_has_a_smaller_contact_down_to_a_single_node) {
  const Problem odd = problem_on(grid_of_width(0.04, 41));
  const Problem even = problem_on(grid_of_width(0.04, 40));
  Eigen::Index previous = 41;
  for (const double fraction : {1.0, 0.3, 0.1, 0.03, 1e-6}) {
    const Solution s = solve_by_matrix_inversion(odd, fraction * load);
    BOOST_TEST(s.n_in_contact() < previous);
    previous = s.n_in_contact();
  }

  BOOST_TEST(previous == 1);
  BOOST_TEST(solve_by_matrix_inversion(even, 1e-6 * load).n_in_contact() == 2);
}

BOOST_AUTO_TEST_CASE(the_residuals_are_those_of_the_pressures_and_gaps) {
  Residuals largest{};
  for (const Eigen::Index n_nodes : {31, 41, 91, 180}) {
    const Solution s = solve(paper, n_nodes);
    double misfit = 0;
    double penetration = 0;
    for (Eigen::Index i = 0; i < s.grid.n_nodes; ++i) {
      if (s.pressure[i] > 0) misfit = std::max(misfit, std::abs(s.gap[i]));
      if (s.pressure[i] == 0) penetration = std::max(penetration, -s.gap[i]);
    }
    BOOST_TEST(s.residuals.gap == misfit);
    BOOST_TEST(s.residuals.separation == penetration);
    BOOST_TEST(relative_difference(s.residuals.pressure, misfit * s.pressure_per_phi) < 1e-14);
    BOOST_TEST(s.residuals.load == std::abs(s.line_load() - load));
    largest.gap = std::max(largest.gap, s.residuals.gap);
    largest.load = std::max(largest.load, s.residuals.load);
  }

  // Rounding leaves something of either on one of the grids at least.
  BOOST_TEST(largest.gap > 0);
  BOOST_TEST(largest.load > 0);
}

BOOST_AUTO_TEST_SUITE_END()
