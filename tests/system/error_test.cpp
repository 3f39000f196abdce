// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/error.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "messages.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(error_test)

using namespace sys;

namespace {

int code_of(const Error& error) {
  return static_cast<int>(error.exit_code());
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_kind_of_error_has_a_separate_exit_code) {
  BOOST_TEST(code_of(ComputationError("no convergence")) == 1);
  BOOST_TEST(code_of(InputError("a flag")) == 2);
  BOOST_TEST(code_of(OutputError("a folder")) == 2);
  BOOST_TEST(code_of(InvalidQuantity("radius", 0, "greater than 0")) == 2);
  BOOST_TEST(code_of(ToolError("gnuplot")) == 3);
}

BOOST_AUTO_TEST_CASE(the_message_of_a_failed_computation_names_the_reason) {
  BOOST_TEST(ComputationError("no convergence").what() ==
             std::string("the computation failed: no convergence"));
}

BOOST_AUTO_TEST_CASE(an_allowed_value_is_returned_unchanged) {
  BOOST_TEST(require_finite("slope", -2.385) == -2.385);
  BOOST_TEST(require_positive("radius", 2.385) == 2.385);
}

BOOST_AUTO_TEST_CASE(an_invalid_quantity_is_named_with_its_value_and_range) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(message_of<InvalidQuantity>([&] { require_finite("slope", infinity); }) ==
             "slope = inf: must be a finite number");
  for (const double number : {0.0, -1.0, infinity, nan}) {
    BOOST_CHECK_THROW(require_positive("radius", number), InvalidQuantity);
  }
  BOOST_TEST(message_of<InvalidQuantity>([] { require_positive("radius", 0); }) ==
             "radius = 0: must be a finite number greater than 0");
}

BOOST_AUTO_TEST_SUITE_END()
