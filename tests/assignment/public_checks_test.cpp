// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <set>

#include "assignment/programs.hpp"

BOOST_AUTO_TEST_SUITE(public_checks_test)

using judge::Numbers;
using judge::Program;
using programs::misled;
using programs::scaled;
using programs::spoiled;

namespace {

using Ids = std::set<std::string>;

Ids failed(const Program& program) {
  return programs::failed(programs::Kind::public_checks, program);
}

void require_failed(const Program& program, const Ids& expected) {
  const Ids found = failed(program);
  BOOST_TEST(found == expected, boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_CASE(correct_functions_pass_every_check_with_any_numbers) {
  programs::require_right(programs::Kind::public_checks);
}

BOOST_AUTO_TEST_CASE(a_wrong_sign_of_the_slope_is_detected) {
  require_failed(scaled("gradient", -1),
                 {"displacement-slope", "gradient-far", "quadrature-error", "quadrature-residual"});
}

BOOST_AUTO_TEST_CASE(a_wrong_factor_of_the_slope_is_detected_by_comparison) {
  require_failed(scaled("gradient", 2),
                 {"displacement-slope", "quadrature-error", "quadrature-residual"});
}

BOOST_AUTO_TEST_CASE(a_slope_that_is_not_odd_is_detected) {
  const Program shifted = misled("gradient", [](Numbers& in) {
    for (std::size_t i = 4; i < in.size(); ++i) in[i] += 0.01 * in[3];
  });
  require_failed(shifted, {"displacement-slope", "gradient-far", "gradient-odd", "quadrature-error",
                           "quadrature-residual"});
}

BOOST_AUTO_TEST_CASE(a_wrong_dependence_on_poissons_ratio_is_detected) {
  const Program squared = misled("gradient", [](Numbers& in) { in[1] *= in[1]; });
  require_failed(squared, {"displacement-slope", "gradient-scaling", "quadrature-error",
                           "quadrature-residual"});
}

BOOST_AUTO_TEST_CASE(an_error_of_zero_or_a_huge_error_is_detected) {
  for (const double claimed : {0., 1.}) {
    const Program claiming = spoiled("gradient_by_quadrature", [=](Numbers& out) {
      for (std::size_t i = 1; i < out.size(); i += 2) out[i] = claimed;
    });
    require_failed(claiming, {"quadrature-error"});
  }
}

BOOST_AUTO_TEST_CASE(a_difference_larger_than_the_error_is_detected) {
  const Program off = spoiled("gradient_by_quadrature", [](Numbers& out) {
    for (std::size_t i = 0; i < out.size(); i += 2) out[i] *= 1 + 1e-8;
  });
  require_failed(off, {"quadrature-error"});
}

BOOST_AUTO_TEST_CASE(a_displacement_without_datum_is_detected) {
  const Program sunk = spoiled("displacement", [](Numbers& out) {
    for (double& u : out) u += 1e-9;
  });
  require_failed(sunk, {"displacement-datum", "influence-displacement"});
}

BOOST_AUTO_TEST_CASE(a_wrong_sign_of_the_displacement_is_detected) {
  require_failed(scaled("displacement", -1),
                 {"displacement-shape", "displacement-slope", "influence-displacement"});
}

BOOST_AUTO_TEST_CASE(a_wrong_coefficient_of_the_neighbour_is_detected) {
  const Program wrong = spoiled("influence", [](Numbers& out) { out[1] *= 1.001; });
  const Ids found = failed(wrong);
  BOOST_TEST(found.contains("influence-refinement"));
  BOOST_TEST(found.contains("influence-shape"));
  BOOST_TEST(found.contains("influence-displacement"));
  BOOST_TEST(found.contains("contact-gap"));
}

BOOST_AUTO_TEST_CASE(a_contact_under_half_the_load_is_detected) {
  require_failed(misled("contact", [](Numbers& in) { in[6] /= 2; }), {"contact-load"});
}

BOOST_AUTO_TEST_CASE(a_contact_with_a_wrong_modulus_leaves_a_gap) {
  require_failed(misled("contact", [](Numbers& in) { in[0] = in[3] = 0.9 * in[0]; }),
                 {"contact-gap"});
}

BOOST_AUTO_TEST_CASE(tension_is_detected) {
  const Program pulled = spoiled("contact", [](Numbers& out) { out[2] = out.back() = -1; });
  const Ids found = failed(pulled);
  BOOST_TEST(found.contains("contact-pressure"));
  BOOST_TEST(found.contains("contact-gap"));
}

BOOST_AUTO_TEST_CASE(a_half_width_with_a_first_order_error_is_detected) {
  const Program rough =
      spoiled("contact", [](Numbers& out) { out[1] *= 1 + 0.1 / static_cast<double>(out.size()); });
  require_failed(rough, {"contact-convergence"});
}

BOOST_AUTO_TEST_SUITE_END()
