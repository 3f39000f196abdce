// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/problem.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(problem_test)

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
