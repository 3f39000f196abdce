// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line/exit_codes.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "block/element.hpp"
#include "config/table.hpp"
#include "contact/contact_search.hpp"
#include "numerics/quadrature.hpp"
#include "system/error.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(exit_codes_test)

using command_line::ExitCode;

namespace {

template <class Error>
int code_of(const Error& error) {
  return static_cast<int>(command_line::run_guarded([&]() -> ExitCode { throw error; }));
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_exit_code_of_a_command_is_returned) {
  BOOST_TEST((command_line::run_guarded([] { return ExitCode::success; }) == ExitCode::success));
  BOOST_TEST((command_line::run_guarded([] { return ExitCode::failed; }) == ExitCode::failed));
}

BOOST_AUTO_TEST_CASE(every_kind_of_bad_input_exits_with_2) {
  BOOST_TEST(code_of(sys::InvalidQuantity("young", -1, "greater than 0")) == 2);
  BOOST_TEST(code_of(config::Error("case.toml:1:1: wrong")) == 2);
  BOOST_TEST(code_of(config::UnitError("unknown unit")) == 2);
  BOOST_TEST(code_of(sys::InputError("--x")) == 2);
  BOOST_TEST(code_of(sys::OutputError("cannot write")) == 2);
}

BOOST_AUTO_TEST_CASE(a_missing_or_failed_tool_exits_with_3) {
  BOOST_TEST(code_of(sys::ToolError("gnuplot is not installed")) == 3);
}

BOOST_AUTO_TEST_CASE(a_failed_computation_exits_with_1) {
  BOOST_TEST(code_of(numerics::QuadratureError("did not converge")) == 1);
  BOOST_TEST(code_of(contact::ContactError("did not settle")) == 1);
  BOOST_TEST(code_of(block::FactorizationError("not positive definite")) == 1);
  BOOST_TEST(code_of(std::runtime_error("anything else")) == 1);
}

BOOST_AUTO_TEST_SUITE_END()
