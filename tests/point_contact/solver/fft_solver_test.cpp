// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/methods.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "point_contact/closed_forms/hertz_elliptic.hpp"
#include "point_contact/closed_forms/revolution.hpp"
#include "point_contact/closed_forms/spheres.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(fft_solver_test)

using Eigen::Index;
using point_contact::Accuracy;
using point_contact::Element;
using point_contact::Grid;
using point_contact::Hertz;
using point_contact::HertzElliptic;
using point_contact::hexagonal_grid;
using point_contact::Problem;
using point_contact::Profile;
using point_contact::rectangular_grid;
using point_contact::Solution;
using point_contact::solve_for_approach;
using point_contact::solve_for_load;
using point_contact::square_grid;
using point_contact::Vector2;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double load = 3.461;
constexpr double curvature = 0.571;
const Hertz hertz(modulus, curvature, load);

// A grid whose greatest circle has a 0.9th of itself in contact.
Grid grid_for(Element element, double radius, Index n, double stretch = 1) {
  const double width = 2 * radius / 0.9;
  if (element == Element::pyramid) return hexagonal_grid(width, n, stretch);
  return rectangular_grid(width, stretch * width, n);
}

Problem spheres(Element element, Index n) {
  return {Profile::paraboloid(curvature), modulus, grid_for(element, hertz.radius(), n), element};
}

// The greatest error of the pressure within 0.9 of an ellipse's axes, relative to the peak.
double error_inside(const Solution& solution, const Vector2& axes,
                    const std::function<double(const Vector2&)>& pressure, double peak) {
  double greatest = 0;
  const Grid& grid = solution.grid;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const Vector2 at = grid.node(i, j);
      if (at.cwiseQuotient(axes).norm() > 0.9) continue;
      const double error = std::abs(solution.pressure[grid.index(i, j)] - pressure(at));
      greatest = std::max(greatest, error / peak);
    }
  }
  return greatest;
}

double error_inside(const Solution& solution) {
  return error_inside(
      solution, Vector2::Constant(hertz.radius()),
      [](const Vector2& at) { return hertz.pressure(at.norm()); }, hertz.peak_pressure());
}

double error_of_peak(const Solution& solution) {
  return std::abs(solution.peak_pressure() / hertz.peak_pressure() - 1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_spheres_come_out_as_hertz_says_to_the_second_order) {
  for (const Element element : {Element::bilinear, Element::pyramid}) {
    const Solution coarse = solve_for_load(spheres(element, 64), load);
    const Solution fine = solve_for_load(spheres(element, 256), load);
    BOOST_TEST_CONTEXT(name_of(element)) {
      // at N = 1024 sixteen times less: 2e-6 and 5e-6 are wanted there
      BOOST_TEST(error_of_peak(fine) < 16 * 2e-6);
      BOOST_TEST(error_inside(fine) < 16 * 5e-6);
      const double order = std::log2(error_of_peak(coarse) / error_of_peak(fine)) / 2;
      BOOST_TEST(std::abs(order - 2) < 0.2);
      BOOST_TEST(std::log2(error_inside(coarse) / error_inside(fine)) / 2 > 1.8);
      BOOST_TEST(relative_difference(fine.approach, hertz.approach()) < 16 * 1e-6);
      BOOST_TEST(std::abs(fine.semi_axes()[0] / hertz.radius() - 1) < 3e-5);
      BOOST_TEST(std::abs(fine.semi_axes()[1] / hertz.radius() - 1) < 3e-5);
    }
  }
}

BOOST_AUTO_TEST_CASE(forces_and_uniform_pressures_come_out_as_hertz_says_too) {
  for (const Element element : {Element::point, Element::uniform}) {
    const Solution solution = solve_for_load(spheres(element, 128), load);
    BOOST_TEST(error_of_peak(solution) < 2e-4, name_of(element) << error_of_peak(solution));
    BOOST_TEST(relative_difference(solution.approach, hertz.approach()) < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(an_elliptical_contact_is_as_good_on_a_grid_stretched_like_it) {
  // Axes 5:1 on cells 5:1.
  const double ratio = 0.2;
  double curvature_x = 0.06;
  // the curvature across that makes b/a = 1/5, from the closed form itself
  double low = 0.06;
  double high = 6;
  for (int bit = 0; bit < 50; ++bit) {
    const double middle = (low + high) / 2;
    const HertzElliptic trial(modulus, curvature_x, middle, load);
    (trial.semi_axis_y() / trial.semi_axis_x() > ratio ? low : high) = middle;
  }
  const HertzElliptic ellipse(modulus, curvature_x, low, load);
  for (const Element element : {Element::bilinear, Element::pyramid}) {
    const Problem problem{Profile::elliptic_paraboloid(curvature_x, low), modulus,
                          grid_for(element, ellipse.semi_axis_x(), 256, ratio), element};
    const Solution solution = solve_for_load(problem, load);
    const double inside = error_inside(
        solution, {ellipse.semi_axis_x(), ellipse.semi_axis_y()},
        [&](const Vector2& at) { return ellipse.pressure(at); }, ellipse.peak_pressure());
    BOOST_TEST_CONTEXT(name_of(element)) {
      BOOST_TEST(std::abs(solution.peak_pressure() / ellipse.peak_pressure() - 1) < 16 * 2e-6);
      BOOST_TEST(inside < 16 * 5e-6);
      BOOST_TEST(relative_difference(solution.semi_axes()[0], ellipse.semi_axis_x()) < 5e-5);
      BOOST_TEST(relative_difference(solution.semi_axes()[1], ellipse.semi_axis_y()) < 5e-5);
      BOOST_TEST(relative_difference(solution.approach, ellipse.approach()) < 5e-5);
    }
  }
}

BOOST_AUTO_TEST_CASE(twenty_five_products_on_the_finest_grid_are_enough) {
  for (const Index n : {128, 200, 256, 512}) {
    const Solution solution = solve_for_load(spheres(Element::pyramid, n), load);
    BOOST_TEST(solution.work.products <= 25, n << ": " << solution.work.products);
    BOOST_TEST(solution.work.preconditionings <= 35);
    BOOST_TEST(solution.residuals.pressure <= 1e-8 * solution.peak_pressure());
  }
}

BOOST_AUTO_TEST_CASE(a_solution_satisfies_equations_1a_and_1b_and_carries_the_load) {
  const Solution solution =
      solve_for_load(spheres(Element::pyramid, 150), load, {.tolerance = 1e-11});
  const double scale = 1e-11 * hertz.approach();

  BOOST_TEST(solution.residuals.gap < scale);
  BOOST_TEST(solution.residuals.separation < scale);
  BOOST_TEST(solution.residuals.load < 1e-13 * load);
  BOOST_TEST(relative_difference(solution.load(), load) < 1e-13);
  BOOST_TEST(solution.pressure.minCoeff() == 0);
}

BOOST_AUTO_TEST_CASE(moments_of_the_pressure_are_those_of_the_symmetry) {
  const Solution solution =
      solve_for_load(spheres(Element::bilinear, 96), load, {.tolerance = 1e-11});
  double first = 0;
  double mixed = 0;
  const Grid& grid = solution.grid;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const Vector2 at = grid.node(i, j) / hertz.radius();
      const double p = solution.pressure[grid.index(i, j)] * grid.lattice.cell_area() / load;
      first += p * at.x();
      mixed += p * at.x() * at.y();
    }
  }
  BOOST_TEST(std::abs(first) < 1e-11);
  BOOST_TEST(std::abs(mixed) < 1e-11);
}

BOOST_AUTO_TEST_CASE(the_approach_given_instead_of_the_load_leads_to_the_same) {
  const Problem problem = spheres(Element::pyramid, 100);
  const Solution by_load = solve_for_load(problem, load, {.tolerance = 1e-11});
  const Solution by_approach = solve_for_approach(problem, by_load.approach, {.tolerance = 1e-11});

  BOOST_TEST(relative_difference(by_approach.load(), load) < 1e-10);
  BOOST_TEST((by_approach.pressure - by_load.pressure).cwiseAbs().maxCoeff() <
             1e-9 * hertz.peak_pressure());
  BOOST_TEST(by_approach.residuals.load == 0);
}

BOOST_AUTO_TEST_CASE(a_cone_comes_out_as_sneddon_says) {
  const point_contact::Cone cone(modulus, 0.0571, load);
  const Problem problem{Profile::cone(0.0571), modulus,
                        grid_for(Element::bilinear, cone.radius(), 256), Element::bilinear};
  const Solution solution = solve_for_load(problem, load);
  double worst = 0;
  for (const double share : {0.3, 0.6, 0.8}) {
    // the node nearest to the place
    const auto i = static_cast<Index>(128 + share * cone.radius() / problem.grid.spacing());
    const double r = problem.grid.node(i, Index{128}).norm();
    worst = std::max(worst, relative_difference(solution.pressure[problem.grid.index(i, 128)],
                                                cone.pressure(r)));
  }
  BOOST_TEST(worst < 2e-3);
  BOOST_TEST(relative_difference(solution.approach, cone.approach()) < 2e-4);
}

BOOST_AUTO_TEST_CASE(a_flat_punch_sinks_as_boussinesq_says) {
  const double radius = 0.4;
  const point_contact::FlatPunch punch(modulus, radius, load);
  const Problem problem{Profile::flat_punch(radius), modulus, square_grid(1, 256),
                        Element::uniform};
  const Solution solution = solve_for_load(problem, load);
  const double in_the_middle = solution.pressure[problem.grid.index(128, 128)];

  // the edge, where the pressure is infinite, is known to a node or so
  BOOST_TEST(relative_difference(in_the_middle, punch.pressure(0)) < 0.01);
  BOOST_TEST(relative_difference(solution.approach, punch.approach()) < 0.01);
  BOOST_TEST(
      solution.n_in_contact() ==
      (point_contact::initial_gaps(problem, point_contact::RowTeam(1)).array() == 0).count());
}

BOOST_AUTO_TEST_CASE(conforming_bodies_come_out_as_steuermann_says) {
  for (const int n : {2, 4}) {
    const point_contact::PowerLaw law(modulus, 0.3, n, load);
    const Problem problem{Profile::power_law(0.3, n), modulus,
                          grid_for(Element::pyramid, law.radius(), 256), Element::pyramid};
    const Solution solution = solve_for_load(problem, load);
    const double inside = error_inside(
        solution, Vector2::Constant(law.radius()),
        [&](const Vector2& at) { return law.pressure(at.norm()); }, solution.peak_pressure());
    BOOST_TEST(inside < 1e-3, "n = " << n << ": " << inside);
    BOOST_TEST(relative_difference(solution.approach, law.approach()) < 2e-4);
  }
}

BOOST_AUTO_TEST_CASE(a_rounded_punch_without_a_flat_is_a_sphere) {
  Problem problem = spheres(Element::pyramid, 64);
  const Solution sphere = solve_for_load(problem, load);
  problem.profile = Profile::rounded_punch(0, curvature);
  const Solution punch = solve_for_load(problem, load);

  BOOST_TEST((sphere.pressure - punch.pressure).cwiseAbs().maxCoeff() <
             1e-7 * hertz.peak_pressure());
}

BOOST_AUTO_TEST_CASE(a_height_map_of_a_sphere_is_a_sphere) {
  Problem problem = spheres(Element::bilinear, 64);
  const Solution sphere = solve_for_load(problem, load);
  const double spacing = hertz.radius() / 25;
  const Eigen::ArrayXXd heights = Eigen::ArrayXXd::NullaryExpr(61, 61, [&](Index i, Index j) {
    const double x = static_cast<double>(i - 30) * spacing;
    const double y = static_cast<double>(j - 30) * spacing;
    return curvature * (x * x + y * y) / 2;
  });
  problem.profile = Profile::height_map(heights, spacing);
  const Solution map = solve_for_load(problem, load);

  // natural splines bend less than the sphere at the ends of the map alone
  BOOST_TEST((sphere.pressure - map.pressure).cwiseAbs().maxCoeff() < 1e-4 * hertz.peak_pressure());
}

BOOST_AUTO_TEST_CASE(contact_off_the_middle_of_the_grid_is_the_same) {
  Problem problem = spheres(Element::bilinear, 100);
  const Solution middle = solve_for_load(problem, load, {.tolerance = 1e-10});
  problem.grid.centre = 3 * problem.grid.lattice.first - 2 * problem.grid.lattice.second;
  const Solution beside = solve_for_load(problem, load, {.tolerance = 1e-10});

  BOOST_TEST(relative_difference(beside.peak_pressure(), middle.peak_pressure()) < 1e-8);
  BOOST_TEST(relative_difference(beside.approach, middle.approach) < 1e-8);
}

BOOST_AUTO_TEST_CASE(two_threads_give_the_same_bytes) {
  const Problem problem = spheres(Element::pyramid, 256);
  const Solution one = solve_for_load(problem, load, {.n_threads = 1});
  const Solution two = solve_for_load(problem, load, {.n_threads = 2});

  BOOST_TEST((one.pressure.array() == two.pressure.array()).all());
  BOOST_TEST((one.gap.array() == two.gap.array()).all());
  BOOST_TEST(one.approach == two.approach);
}

BOOST_AUTO_TEST_CASE(contact_that_reaches_the_end_is_refused_with_a_domain_that_holds_it) {
  Problem problem = spheres(Element::pyramid, 64);
  problem.grid.lattice.first /= 3;
  problem.grid.lattice.second /= 3;
  double side = 0;
  BOOST_CHECK_EXCEPTION(solve_for_load(problem, load), InvalidQuantity,
                        [&](const InvalidQuantity& error) {
                          const std::string before = "a side of ";
                          const std::size_t at = error.allowed().find(before);
                          if (at == std::string::npos) return false;
                          side = std::stod(error.allowed().substr(at + before.size()));
                          return error.quantity() == "domain side";
                        });

  // the contact, and a little for the last nodes of a coarse grid
  BOOST_TEST(side > 2 * hertz.radius());
  BOOST_TEST(side < 1.2 * 2 * hertz.radius());
  problem.grid = hexagonal_grid(side, 64);
  BOOST_CHECK_NO_THROW(solve_for_load(problem, load));
}

BOOST_AUTO_TEST_CASE(a_grid_without_memory_is_refused_before_anything_is_computed) {
  Problem problem = spheres(Element::pyramid, 64);
  problem.grid.n1 = problem.grid.n2 = 3'000'000;
  BOOST_CHECK_EXCEPTION(solve_for_load(problem, load), InvalidQuantity,
                        [](const InvalidQuantity& error) { return error.quantity() == "nodes"; });
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  const Problem problem = spheres(Element::pyramid, 32);
  BOOST_CHECK_THROW(solve_for_load(problem, 0), InvalidQuantity);
  BOOST_CHECK_THROW(solve_for_load(problem, -1), InvalidQuantity);
  BOOST_CHECK_THROW(solve_for_load(problem, 1e200), InvalidQuantity);
  BOOST_CHECK_THROW(solve_for_approach(problem, 0), InvalidQuantity);
  BOOST_CHECK_THROW(solve_for_approach(problem, std::nan("")), InvalidQuantity);
  BOOST_CHECK_THROW(solve_for_load(problem, load, {.tolerance = 1e-13}), InvalidQuantity);
  BOOST_CHECK_THROW(solve_for_load(problem, load, {.tolerance = 0.1}), InvalidQuantity);
  BOOST_CHECK_THROW(solve_for_load(problem, load, {.n_threads = 0}), InvalidQuantity);
  Problem soft = problem;
  soft.contact_modulus = -1;
  BOOST_CHECK_THROW(solve_for_load(soft, load), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
