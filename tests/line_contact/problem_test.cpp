// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/problem.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(problem_test)

BOOST_AUTO_TEST_SUITE(grid)

using Eigen::Index;
using line_contact::Grid;
using line_contact::grid_around;
using line_contact::grid_of_width;
using line_contact::one_sided_grid;
using sys::InvalidQuantity;
using tolerance::relative_difference;

BOOST_AUTO_TEST_CASE(nodes_lie_symmetrically_about_the_point_of_first_contact) {
  for (const Index n_nodes : {5, 6, 41}) {
    const Grid grid = grid_around(2.385, n_nodes);
    const Eigen::VectorXd x = grid.nodes();
    BOOST_TEST(x.size() == n_nodes);
    BOOST_TEST((x + x.reverse()).cwiseAbs().maxCoeff() == 0);
  }
}

BOOST_AUTO_TEST_CASE(there_is_a_free_node_on_either_side_of_the_contact) {
  for (const Index n_nodes : {5, 6, 7, 41, 1000}) {
    const Grid grid = grid_around(2.385, n_nodes);
    BOOST_TEST(grid.x(n_nodes - 2) >= 2.385 * 1.0999999);
  }
}

BOOST_AUTO_TEST_CASE(ninety_one_nodes_put_40_elements_on_the_half_width) {
  BOOST_TEST(relative_difference(grid_around(1, 91).spacing, 1.0 / 40) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_grid_of_some_width_fills_it_with_spacings_about_its_centre) {
  for (const Index n_nodes : {5, 8, 239}) {
    const Grid grid = grid_of_width(2.385, n_nodes, 0.71);

    BOOST_TEST(grid.n_nodes == n_nodes);
    BOOST_TEST(!grid.is_one_sided);
    BOOST_TEST(relative_difference(grid.begin(), 0.71 - 2.385 / 2) < 1e-14);
    BOOST_TEST(relative_difference(grid.end(), 0.71 + 2.385 / 2) < 1e-14);
    BOOST_TEST(relative_difference(grid.x(0) - grid.begin(), grid.spacing / 2) < 1e-12);
    BOOST_TEST(relative_difference(grid.x(3) - grid.x(2), grid.spacing) < 1e-12);
    BOOST_TEST(relative_difference((grid.x(0) + grid.x(n_nodes - 1)) / 2, 0.71) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(a_one_sided_grid_has_the_same_domain_with_its_mirror_images) {
  const Grid grid = one_sided_grid(2.385, 7);
  const Grid both = grid_of_width(2.385, 13);

  BOOST_TEST(grid.is_one_sided);
  BOOST_TEST(relative_difference(grid.spacing, both.spacing) < 1e-15);
  BOOST_TEST(grid.x(0) == 0);
  BOOST_TEST((grid.nodes() - both.nodes().tail(7)).cwiseAbs().maxCoeff() < 1e-15);
  BOOST_TEST(relative_difference(grid.end(), 2.385 / 2) < 1e-15);
  BOOST_TEST(grid.begin() == -grid.end());
}

BOOST_AUTO_TEST_CASE(mirror_images_count_double_and_the_middle_once) {
  const Grid one_sided = one_sided_grid(2.385, 6);
  const Grid both = grid_of_width(2.385, 6);

  BOOST_TEST(one_sided.weight(0) == 1);
  BOOST_TEST(one_sided.weight(1) == 2);
  BOOST_TEST(one_sided.weight(5) == 2);
  BOOST_TEST(both.weight(0) == 1);
  BOOST_TEST(both.weight(5) == 1);
}

BOOST_AUTO_TEST_CASE(too_few_or_too_many_nodes_are_refused) {
  for (const Index n_nodes : {Index{4}, Index{-7}, line_contact::max_nodes + 1}) {
    BOOST_CHECK_THROW(grid_around(1, n_nodes), InvalidQuantity);
    BOOST_CHECK_THROW(grid_of_width(1, n_nodes), InvalidQuantity);
    BOOST_CHECK_THROW(one_sided_grid(1, n_nodes), InvalidQuantity);
  }
  BOOST_CHECK_NO_THROW(grid_of_width(1, line_contact::min_nodes));
  BOOST_CHECK_NO_THROW(grid_of_width(1, line_contact::max_nodes));
}

BOOST_AUTO_TEST_CASE(widths_and_centres_out_of_range_are_refused_by_name) {
  const auto names = [](const char* quantity) {
    return [=](const InvalidQuantity& e) { return e.quantity() == quantity; };
  };
  for (const double bad : {0.0, -2.385, double(NAN), std::numeric_limits<double>::infinity()}) {
    BOOST_CHECK_EXCEPTION(grid_around(bad, 41), InvalidQuantity, names("half_width"));
    BOOST_CHECK_EXCEPTION(grid_of_width(bad, 41), InvalidQuantity, names("domain"));
    BOOST_CHECK_EXCEPTION(one_sided_grid(bad, 41), InvalidQuantity, names("domain"));
  }
  BOOST_CHECK_EXCEPTION(grid_of_width(1, 41, NAN), InvalidQuantity, names("centre"));
}

BOOST_AUTO_TEST_SUITE_END()

using line_contact::Element;
using line_contact::grid_of_width;
using line_contact::one_sided_grid;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::require_valid;
using sys::InvalidQuantity;

namespace {

const Profile measured = Profile::tabulated({-1, -0.4, 0.3, 0.9, 2}, {1, 0.2, 0, 0.7, 2.385});

auto names(const char* quantity) {
  return [=](const InvalidQuantity& e) { return e.quantity() == quantity; };
}

}  // namespace

BOOST_AUTO_TEST_CASE(elements_are_triangles_unless_said_otherwise) {
  const Problem problem{Profile::parabola(1), 1, grid_of_width(1, 41)};

  BOOST_TEST((problem.element == Element::triangular));
}

BOOST_AUTO_TEST_CASE(a_formula_is_valid_on_any_grid) {
  for (const double width : {1e-9, 2.385, 1e9}) {
    BOOST_CHECK_NO_THROW(require_valid({Profile::wedge(0.1), 1, grid_of_width(width, 41, 2.385)}));
    BOOST_CHECK_NO_THROW(require_valid({Profile::wedge(0.1), 1, one_sided_grid(width, 41)}));
  }
}

BOOST_AUTO_TEST_CASE(the_modulus_must_be_positive_and_finite) {
  for (const double bad : {0.0, -1.0, double(NAN), std::numeric_limits<double>::infinity()}) {
    BOOST_CHECK_EXCEPTION(require_valid({Profile::wedge(0.1), bad, grid_of_width(1, 41)}),
                          InvalidQuantity, names("contact_modulus"));
  }
}

BOOST_AUTO_TEST_CASE(gaps_whose_squares_are_no_doubles_are_refused) {
  BOOST_CHECK_NO_THROW(require_valid({Profile::wedge(0.1), 1, grid_of_width(1e-120, 41)}));
  BOOST_CHECK_EXCEPTION(require_valid({Profile::wedge(0.1), 1, grid_of_width(1e-140, 41)}),
                        InvalidQuantity, names("largest gap on the grid"));
}

BOOST_AUTO_TEST_CASE(nodes_must_lie_within_a_measured_profile) {
  // Of the domain 3 wide about 0.5 the end nodes lie c/2 inside: exactly the profile's ends count.
  BOOST_CHECK_NO_THROW(require_valid({measured, 1, grid_of_width(3, 41, 0.5)}));
  BOOST_CHECK_NO_THROW(require_valid({measured, 1, {4, 1, 0.5}}));
  for (const double centre : {0.45, 0.55}) {
    BOOST_CHECK_EXCEPTION(require_valid({measured, 1, grid_of_width(3, 41, centre)}),
                          InvalidQuantity, names("domain"));
  }
}

BOOST_AUTO_TEST_CASE(a_one_sided_grid_wants_a_symmetric_profile) {
  BOOST_CHECK_EXCEPTION(require_valid({measured, 1, one_sided_grid(0.5, 41)}), InvalidQuantity,
                        names("one-sided grid's end"));
}

BOOST_AUTO_TEST_SUITE_END()
