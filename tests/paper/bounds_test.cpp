// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/bounds.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"

BOOST_AUTO_TEST_SUITE(bounds_test)

using config::PrintedNumber;
using elasticity::Material;
using line_contact::Solution;
using numerics::Estimate;

namespace {

parameters::ContactCase cylinders_of(double radius1, double radius2) {
  const Material steel(206e3, 0.28);
  const Material aluminium(71.5e3, 0.345);
  const auto r1 = line_contact::Radius::of_cylinder("radius1", radius1);
  const auto r2 = line_contact::Radius::of_cylinder("radius2", radius2);
  return {{steel, r1}, {aluminium, r2}, {steel, r1, aluminium, r2}, 780, 30, 91, {}, {}};
}

bool contains(Estimate estimate, double truth) {
  return std::abs(estimate.value - truth) <= estimate.abs_error;
}

// The same discrete contact by every method there is.
std::vector<Solution> by_all_methods(const parameters::ContactCase& c, long n_nodes) {
  const line_contact::Hertz hertz(c.cylinders, c.line_load);
  const line_contact::Problem problem{c.cylinders.profile(), c.cylinders.contact_modulus(),
                                      line_contact::grid_around(hertz.half_width(), n_nodes)};
  return {line_contact::solve_by_matrix_inversion(problem, c.line_load),
          line_contact::solve_by_variational_method(problem, c.line_load),
          line_contact::solve_by_fft(problem, c.line_load),
          line_contact::solve_by_fft(problem, c.line_load, 1e-12)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_printed_number_is_half_a_unit_of_its_last_place_wrong) {
  const Estimate printed = paper::as_estimate(PrintedNumber("-1.6236048e-006"));
  BOOST_TEST(printed.value == -1.6236048e-6);
  BOOST_TEST(printed.abs_error == 5e-14, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(paper::as_estimate(PrintedNumber("16")).abs_error == 0.5);
}

BOOST_AUTO_TEST_CASE(how_far_a_number_is_off_a_print_holds_the_errors_of_both) {
  const Estimate off = paper::percent_off({1.5, 0.01}, PrintedNumber("1.25"));
  BOOST_TEST(off.value == 20, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(contains(off, 100 * (1.51 / 1.245 - 1)));
  BOOST_TEST(!contains(off, 100 * (1.52 / 1.244 - 1)));
}

BOOST_AUTO_TEST_CASE(the_edges_that_all_methods_find_lie_within_their_errors) {
  for (const long n_nodes : {23L, 91L, 181L}) {
    const std::vector<Solution> solutions = by_all_methods(cylinders_of(25, 75), n_nodes);
    const Solution& first = solutions.front();
    for (const Solution& solution : solutions) {
      const double apart = std::abs(solution.regions().back().end - first.regions().back().end);
      BOOST_TEST(apart <= paper::edge_error(solution) + paper::edge_error(first));
      BOOST_TEST(paper::edge_error(solution) < 1e-6 * solution.grid.spacing);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_edge_is_known_to_a_spacing_even_if_no_pressure_is) {
  Solution solution = by_all_methods(cylinders_of(25, 75), 23).front();
  solution.residuals.pressure = solution.peak_pressure();
  BOOST_TEST(paper::edge_error(solution) == solution.grid.spacing);
}

BOOST_AUTO_TEST_CASE(where_curvatures_cancel_closed_forms_are_less_certain) {
  BOOST_TEST(paper::rounded(cylinders_of(25, 75), 3) == paper::rounded(3));
  // 1/25 − 1/25.1 is a 251st of either, and there are two.
  BOOST_TEST(paper::rounded(cylinders_of(25, -25.1), 3) == 501 * paper::rounded(3),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(closed_forms_are_within_their_roundings_of_extended_precision) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.2, 5);
  for (int i = 0; i < 2000; ++i) {
    const double r1 = 25 * uniform(random);
    const double r2 = -40 * r1 / (30 + 9 * uniform(random));  // a hollow, from near to wide
    if (1 / r1 + 1 / r2 <= 0) continue;
    const parameters::ContactCase c = cylinders_of(r1, r2);
    const line_contact::Hertz hertz(c.cylinders, c.line_load);
    const auto compliance = [](const Material& m) {
      const long double nu = m.poisson();
      return (1 - nu * nu) / m.young();
    };
    const long double modulus = 1 / (compliance(c.body1.material) + compliance(c.body2.material));
    const long double curvature =
        1 / static_cast<long double>(r1) + 1 / static_cast<long double>(r2);
    const long double pi = std::numbers::pi_v<long double>;
    const long double a = std::sqrt(4 * c.line_load / (pi * modulus * curvature));
    const auto wrong = [](double x, long double truth) {
      return static_cast<double>(std::abs(x - truth));
    };
    BOOST_TEST(wrong(hertz.half_width(), a) <= paper::rounded(c, hertz.half_width()));
    BOOST_TEST(wrong(hertz.peak_pressure(), 2 * c.line_load / (pi * a)) <=
               paper::rounded(c, hertz.peak_pressure()));
    BOOST_TEST(wrong(c.cylinders.contact_modulus(), modulus) <=
               paper::rounded(c.cylinders.contact_modulus()));
  }
}

BOOST_AUTO_TEST_CASE(methods_differ_by_no_more_than_the_errors_of_their_pressures) {
  const parameters::ContactCase c = cylinders_of(25, 75);
  for (const long n_nodes : {20L, 91L, 181L, 500L}) {
    const std::vector<Solution> solutions = by_all_methods(c, n_nodes);
    const double peak = solutions.front().peak_pressure();
    for (const Solution& one : solutions) {
      BOOST_TEST(paper::pressure_error(one) < 1e-9);
      for (const Solution& other : solutions) {
        const double apart = (one.pressure - other.pressure).lpNorm<Eigen::Infinity>() / peak;
        BOOST_TEST(apart <= paper::pressure_error(one) + paper::pressure_error(other));
        BOOST_TEST(std::abs(one.half_width() / other.half_width() - 1) <=
                   paper::half_width_error(one) + paper::half_width_error(other));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_looser_tolerance_is_seen_in_the_error_of_the_pressures) {
  const parameters::ContactCase c = cylinders_of(25, 75);
  const line_contact::Hertz hertz(c.cylinders, c.line_load);
  const line_contact::Problem problem{c.cylinders.profile(), c.cylinders.contact_modulus(),
                                      line_contact::grid_of_width(2.2 * hertz.half_width(), 4096)};
  const Solution tight = line_contact::solve_by_fft(problem, c.line_load, 1e-13);
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Solution loose = line_contact::solve_by_fft(problem, c.line_load, tolerance);
    const double apart =
        (loose.pressure - tight.pressure).lpNorm<Eigen::Infinity>() / tight.peak_pressure();
    BOOST_TEST(apart <= paper::pressure_error(loose) + paper::pressure_error(tight), tolerance);
  }
}

BOOST_AUTO_TEST_SUITE_END()
