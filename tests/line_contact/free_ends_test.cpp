// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solver.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "line_contact/dense_methods.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(free_ends_test)

using Eigen::VectorXd;
using line_contact::Grid;
using line_contact::grid_of_width;
using line_contact::one_sided_grid;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::require_free_ends;
using line_contact::solve_by_matrix_inversion;
using sys::InvalidQuantity;

namespace {

constexpr double load = 3.461;
constexpr double modulus = 913.7;

// What is refused and, if it is the domain, how wide that must be.
struct Refusal {
  std::string quantity;
  std::string allowed;
  double width = 0;
};

std::optional<Refusal> refusal_of(const Problem& problem, const VectorXd& pressure,
                                  double line_load = load) {
  try {
    require_free_ends(problem, pressure, line_load);
  } catch (const InvalidQuantity& e) {
    const std::string at_least = "at least ";
    const bool says_how_wide = e.allowed().starts_with(at_least);
    return Refusal{e.quantity(), e.allowed(),
                   says_how_wide ? std::stod(e.allowed().substr(at_least.size())) : 0};
  }
  return {};
}

VectorXd everywhere(const Problem& problem) {
  return VectorXd::Ones(problem.grid.n_nodes);
}

}  // namespace

BOOST_AUTO_TEST_CASE(contact_with_free_ends_passes) {
  const Problem problem{Profile::parabola(1), modulus, grid_of_width(1, 5)};
  VectorXd pressure = VectorXd::Zero(5);
  pressure.segment(1, 3).setConstant(1e-300);

  BOOST_TEST(!refusal_of(problem, pressure));
}

BOOST_AUTO_TEST_CASE(contact_at_either_end_is_refused_and_the_end_named) {
  const Problem problem{Profile::parabola(1), modulus, grid_of_width(0.5, 8, 0.25)};
  const auto left = refusal_of(problem, VectorXd::Unit(8, 0));
  const auto right = refusal_of(problem, VectorXd::Unit(8, 7));

  BOOST_REQUIRE((left && right));
  BOOST_TEST(left->quantity == "domain");
  BOOST_TEST(left->allowed.ends_with("x = 0"));
  BOOST_TEST(right->allowed.ends_with("x = 0.5"));
}

BOOST_AUTO_TEST_CASE(the_middle_of_one_side_is_no_end) {
  const Problem problem{Profile::parabola(1), modulus, one_sided_grid(0.01, 5)};

  BOOST_TEST(!refusal_of(problem, VectorXd::Unit(5, 0)));
  BOOST_TEST(refusal_of(problem, VectorXd::Unit(5, 4)).has_value());
}

BOOST_AUTO_TEST_CASE(the_width_that_is_named_holds_the_contact_and_little_else) {
  const Profile profiles[] = {Profile::parabola(0.571), Profile::wedge(0.0371),
                              Profile::rounded_punch(0.063, 1.7), Profile::power_law(57, 3)};
  for (const Profile& profile : profiles) {
    for (const double too_narrow : {1e-3, 0.02385, 0.1}) {
      for (const bool is_one_sided : {false, true}) {
        Problem problem{profile, modulus, grid_of_width(too_narrow, 41)};
        if (is_one_sided) problem.grid = one_sided_grid(too_narrow, 21);
        const auto refusal = refusal_of(problem, everywhere(problem));

        BOOST_REQUIRE(refusal.has_value());
        problem.grid =
            is_one_sided ? one_sided_grid(refusal->width, 61) : grid_of_width(refusal->width, 121);
        const double half_width = solve_by_matrix_inversion(problem, load).half_width_by_count();
        BOOST_TEST(refusal->width > 2 * 1.05 * half_width);
        BOOST_TEST(refusal->width < 2 * 1.25 * half_width);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(few_nodes_are_told_a_width_that_is_enough_for_as_few) {
  for (const Eigen::Index n_nodes : {5, 6, 7, 11}) {
    Problem problem{Profile::parabola(0.571), modulus, grid_of_width(0.02, n_nodes)};
    problem.grid = grid_of_width(refusal_of(problem, everywhere(problem)).value().width, n_nodes);

    BOOST_CHECK_NO_THROW(solve_by_matrix_inversion(problem, load));
  }
}

BOOST_AUTO_TEST_CASE(the_width_is_about_the_centre_of_the_grid) {
  // The contact lies at x = 0, the grid about 0.2: it must reach 0.2 and the half-width to the
  // left.
  Problem problem{Profile::parabola(0.571), modulus, grid_of_width(0.3, 41, 0.2)};
  const auto refusal = refusal_of(problem, VectorXd::Unit(41, 0));

  BOOST_REQUIRE(refusal.has_value());
  problem.grid = grid_of_width(refusal->width, 121, 0.2);
  BOOST_CHECK_NO_THROW(solve_by_matrix_inversion(problem, load));
  BOOST_TEST(refusal->width < 2 * 1.2 * (0.2 + 0.093));
}

BOOST_AUTO_TEST_CASE(a_measured_profile_may_be_used_to_its_last_point) {
  // Of half-width 0.0919, in a domain of half-width 0.07 in a profile given to 0.12: less than
  // twice the domain.
  std::vector<double> x, gap;
  for (int i = -24; i <= 24; ++i) {
    x.push_back(0.005 * i);
    gap.push_back(0.571 / 2 * x.back() * x.back());
  }
  Problem problem{Profile::tabulated(x, gap), modulus, grid_of_width(0.14, 41)};
  const auto refusal = refusal_of(problem, everywhere(problem));

  BOOST_REQUIRE(refusal.has_value());
  BOOST_TEST(refusal->quantity == "domain");
  problem.grid = grid_of_width(refusal->width, 121);
  BOOST_CHECK_NO_THROW(solve_by_matrix_inversion(problem, load));

  const auto too_much = refusal_of(problem, everywhere(problem), 3 * load);
  BOOST_REQUIRE(too_much.has_value());
  BOOST_TEST(too_much->quantity == "domain");
  BOOST_TEST(too_much->allowed.find(
                 "wider than the profile, which is given only from x = -0.12 to 0.12") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
