// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/accuracy.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "refused.hpp"

BOOST_AUTO_TEST_SUITE(accuracy_test)

using contact::require_resolved;
using contact::require_tolerance;
using contact::resolution_warning;

BOOST_AUTO_TEST_CASE(a_contact_of_few_nodes_is_rejected_with_sufficient_nodes_and_domain) {
  check_refused({
      {"number of nodes in contact = 4: must be 8 or more: use at least 500 nodes instead of "
       "100, "
       "or a domain of 0.4 or less",
       [] {
         require_resolved({4, 4, 100, 2});
       }},
      {"number of nodes in contact = 0",
       [] {
         require_resolved({0, 0, 100, 2});
       }},
      {"tolerance = 1e-14: must be from 1e-13, the rounding error, to 0.01",
       [] { require_tolerance(1e-14, 1e-13); }},
      {"tolerance = nan", [] { require_tolerance(NAN, 1e-13); }},
      {"tolerance = inf",
       [] { require_tolerance(std::numeric_limits<double>::infinity(), 1e-13); }},
  });
  BOOST_CHECK_NO_THROW(require_resolved({8, 8, 100, 2}));
  BOOST_TEST(require_tolerance(0.01, 1e-13) == 0.01);
}

BOOST_AUTO_TEST_CASE(a_coarse_contact_causes_a_warning_with_the_size_of_the_error) {
  BOOST_TEST(resolution_warning({20, 20, 100, 2}).empty());
  const std::string warning = resolution_warning({12, 12, 100, 2});
  BOOST_TEST((warning.find("12 nodes lie across the contact") != warning.npos));
  BOOST_TEST((warning.find("about 1 %") != warning.npos));
}

BOOST_AUTO_TEST_CASE(residuals_are_the_greatest_gap_in_contact_and_penetration_outside) {
  const Eigen::Vector4d pressure(0, 1, 2, 0);
  const Eigen::Vector4d gap(-0.2, 0.1, -0.3, 7);
  const contact::Residuals residuals = contact::residuals_of_gaps(pressure, gap);
  BOOST_TEST(residuals.gap == 0.3);
  BOOST_TEST(residuals.separation == 0.2);
}

BOOST_AUTO_TEST_SUITE_END()
