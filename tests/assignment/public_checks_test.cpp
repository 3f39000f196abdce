// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <set>

#include "assignment/programs.hpp"

BOOST_AUTO_TEST_SUITE(public_checks_test)

using judge::Numbers;
using judge::Program;
using programs::misled;
using programs::reporting;
using programs::scaled;
using programs::spoiled;

namespace {

struct Mistake {
  const char* description;
  Program program;
  std::set<std::string> failed;  // all public checks that detect it
};

const Mistake mistakes[] = {
    {"wrong sign of the slope",
     scaled("gradient", -1),
     {"displacement-slope", "gradient-far", "quadrature-error", "quadrature-residual"}},
    {"wrong factor of the slope",
     scaled("gradient", 2),
     {"displacement-slope", "quadrature-error", "quadrature-residual"}},
    {"slope that is not odd",
     misled("gradient",
            [](Numbers& in) {
              for (std::size_t i = 4; i < in.size(); ++i) in[i] += 0.01 * in[3];
            }),
     {"displacement-slope", "gradient-far", "gradient-odd", "quadrature-error",
      "quadrature-residual"}},
    {"wrong dependence on Poisson's ratio",
     misled("gradient", [](Numbers& in) { in[1] *= in[1]; }),
     {"displacement-slope", "gradient-scaling", "quadrature-error", "quadrature-residual"}},
    {"error of zero", reporting([](double, double) { return 0; }), {"quadrature-error"}},
    {"huge error", reporting([](double, double) { return 1; }), {"quadrature-error"}},
    {"difference larger than the error",
     spoiled("gradient_by_quadrature",
             [](Numbers& out) {
               for (std::size_t i = 0; i < out.size(); i += 2) out[i] *= 1 + 1e-8;
             }),
     {"quadrature-error"}},
    {"displacement without datum",
     spoiled("displacement",
             [](Numbers& out) {
               for (double& u : out) u += 1e-9;
             }),
     {"displacement-datum", "influence-displacement"}},
    {"wrong sign of the displacement",
     scaled("displacement", -1),
     {"displacement-shape", "displacement-slope", "influence-displacement"}},
    {"wrong coefficient of the neighbour",
     spoiled("influence", [](Numbers& out) { out[1] *= 1.001; }),
     {"contact-gap", "influence-displacement", "influence-refinement", "influence-shape"}},
    {"half the load", misled("contact", [](Numbers& in) { in[6] /= 2; }), {"contact-load"}},
    {"wrong modulus",
     misled("contact", [](Numbers& in) { in[0] = in[3] = 0.9 * in[0]; }),
     {"contact-gap"}},
    {"tension",
     spoiled("contact", [](Numbers& out) { out[2] = out.back() = -1; }),
     {"contact-gap", "contact-pressure"}},
    {"first-order error of the half-width",
     spoiled("contact", [](Numbers& out) { out[1] *= 1 + 0.1 / static_cast<double>(out.size()); }),
     {"contact-convergence"}}};

}  // namespace

BOOST_AUTO_TEST_CASE(correct_functions_pass_every_check_with_any_numbers) {
  programs::require_right(programs::Kind::public_checks);
}

BOOST_AUTO_TEST_CASE(each_mistake_is_detected_by_the_checks_of_its_property) {
  for (const Mistake& mistake : mistakes) {
    BOOST_TEST_CONTEXT(mistake.description) {
      const auto found = programs::failed(programs::Kind::public_checks, mistake.program);
      BOOST_TEST(found == mistake.failed, boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
