// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solver.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "line_contact/dense_methods.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(approach_control_test)

using line_contact::Element;
using line_contact::grid_of_width;
using line_contact::Method;
using line_contact::one_sided_grid;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::Solution;
using line_contact::solve_for_approach;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double load = 3.461;
constexpr double datum = 2.385;

const Method by_fft = [](const Problem& problem, double line_load) {
  return line_contact::solve_by_fft(problem, line_load, 1e-12);
};

struct NamedMethod {
  const char* name;
  Method method;
};
const std::vector<NamedMethod> methods{
    {"matrix inversion", line_contact::solve_by_matrix_inversion},
    {"variational", line_contact::solve_by_variational_method},
    {"fft", by_fft}};

Problem problem_of(const Profile& profile, double width, double centre = 0) {
  return {profile, modulus, grid_of_width(width, 97, centre), Element::triangular};
}

// A hollow 0.0123 deep, off the middle: the least gap is not zero.
Profile measured() {
  std::vector<double> x, gap;
  for (int i = 0; i <= 60; ++i) {
    x.push_back(-0.2 + 0.01 * i);
    gap.push_back(0.4 * std::pow(x.back() - 0.1, 2) - 0.0123);
  }
  return Profile::tabulated(x, gap);
}

const Problem cylinders = problem_of(Profile::parabola(0.571), 0.2385);

// Domains wider than the contacts, whose half-widths are 0.092, 0.102, 0.085 and 0.08.
const std::vector<Problem> problems{cylinders, problem_of(Profile::wedge(0.0371), 0.25),
                                    problem_of(Profile::rounded_punch(0.063, 1.7), 0.25),
                                    problem_of(Profile::power_law(57, 2), 0.25),
                                    problem_of(measured(), 0.25, 0.11)};

auto names(const char* quantity) {
  return [=](const InvalidQuantity& e) { return e.quantity() == quantity; };
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_approach_of_a_load_needs_that_load) {
  for (const NamedMethod& named : methods) {
    for (const Problem& problem : problems) {
      for (const double at : {datum, -0.27}) {
        BOOST_TEST_CONTEXT(named.name << " to " << problem.grid.end() << ", datum " << at) {
          const double approach = named.method(problem, load).approach(at);
          const Solution s = solve_for_approach(problem, approach, at, named.method);

          BOOST_TEST(relative_difference(s.line_load(), load) < 5e-12);
          BOOST_TEST(relative_difference(s.approach(at), approach) < 5e-12);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(one_side_needs_the_same_load) {
  Problem half = cylinders;
  half.grid = one_sided_grid(0.2385, 49);
  const double approach = by_fft(cylinders, load).approach(datum);

  for (const NamedMethod& named : methods) {
    const Solution s = solve_for_approach(half, approach, datum, named.method);
    BOOST_TEST(s.grid.is_one_sided);
    BOOST_TEST(relative_difference(s.line_load(), load) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(the_larger_the_approach_the_larger_the_load) {
  double previous = 0;
  for (const double approach : {1e-9, 1e-6, 1e-4, 0.002, 0.01}) {
    const Solution s = solve_for_approach(cylinders, approach, datum, by_fft);
    BOOST_TEST(s.line_load() > previous);
    BOOST_TEST(relative_difference(s.approach(datum), approach) < 1e-11);
    previous = s.line_load();
  }
}

BOOST_AUTO_TEST_CASE(more_nodes_than_the_coarse_grid_need_few_solves) {
  Problem problem = cylinders;
  problem.grid = grid_of_width(0.2385, 4001);
  const double approach = by_fft(problem, load).approach(datum);
  int n_solves = 0;
  const Method counted = [&](const Problem& p, double line_load) {
    ++n_solves;
    return by_fft(p, line_load);
  };
  const Solution s = solve_for_approach(problem, approach, datum, counted);

  BOOST_TEST(relative_difference(s.line_load(), load) < 5e-12);
  BOOST_TEST(n_solves <= 6);
}

BOOST_AUTO_TEST_CASE(the_bodies_may_touch_far_from_the_origin) {
  std::vector<double> x, gap;
  for (int i = 0; i <= 60; ++i) {
    x.push_back(23.85 + 0.01 * i);
    gap.push_back(0.4 * std::pow(0.01 * i - 0.3, 2));
  }
  const Problem far = problem_of(Profile::tabulated(x, gap), 0.25, 24.16);
  const Solution s = solve_for_approach(far, by_fft(far, load).approach(datum), datum, by_fft);

  BOOST_TEST(relative_difference(s.line_load(), load) < 5e-12);
}

BOOST_AUTO_TEST_CASE(any_units_of_length_and_stress_will_do) {
  const double approach = by_fft(cylinders, load).approach(datum);
  const double inch = 25.4;
  const double psi = 6.894757e-3;
  const Problem metric{Profile::parabola(0.571 / inch), modulus * psi,
                       grid_of_width(0.2385 * inch, 97), Element::triangular};
  const Solution s = solve_for_approach(metric, approach * inch, datum * inch, by_fft);

  BOOST_TEST(relative_difference(s.line_load(), load * psi * inch) < 5e-12);
}

BOOST_AUTO_TEST_CASE(an_approach_that_leaves_no_contact_is_refused) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -0.1, double(NAN), infinity}) {
    BOOST_CHECK_EXCEPTION(
        solve_for_approach(problem_of(Profile::parabola(1), 1), bad, datum, by_fft),
        InvalidQuantity, names("approach"));
  }
  const Problem hollow = problem_of(measured(), 0.25, 0.11);
  BOOST_CHECK_EXCEPTION(solve_for_approach(hollow, -0.0124, datum, by_fft), InvalidQuantity,
                        names("approach"));
  BOOST_TEST(solve_for_approach(hollow, -0.0122, datum, by_fft).line_load() > 0);
}

BOOST_AUTO_TEST_CASE(what_the_method_and_the_approach_refuse_is_refused) {
  BOOST_CHECK_EXCEPTION(solve_for_approach(cylinders, 0.01, 0.1, by_fft), InvalidQuantity,
                        names("datum"));
  BOOST_CHECK_EXCEPTION(solve_for_approach(cylinders, 0.1, datum, by_fft), InvalidQuantity,
                        names("domain"));
  Problem soft = cylinders;
  soft.contact_modulus = 0;
  BOOST_CHECK_EXCEPTION(solve_for_approach(soft, 0.01, datum, by_fft), InvalidQuantity,
                        names("contact_modulus"));
}

BOOST_AUTO_TEST_SUITE_END()
