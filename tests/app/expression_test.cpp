// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/load_choices.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "message_of.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(expression_test)

using app::parse_expression;

namespace {

std::string refusal_of(const std::string& formula, double x = 0.5) {
  return message_of<sys::InputError>([&] {
    parse_expression("p", formula, {{"p0", 3}, {"a", 2}})(x);
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_formula_of_x_and_constants_is_a_function) {
  const auto quartic = parse_expression("p", "p0*(1-(x/a)^4)", {{"p0", 2.385}, {"a", 0.75}});
  const auto waves = parse_expression("p", "sqrt(abs(x)) + sin(pi*x) + exp(-x) + 1.5e-1", {});

  for (const double x : {-0.75, -0.3, 0.0, 0.11, 0.7}) {
    const double t = x / 0.75;
    BOOST_TEST(std::abs(quartic(x) - 2.385 * (1 - t * t * t * t)) < 1e-15);
    BOOST_TEST(std::abs(waves(x) - (std::sqrt(std::abs(x)) + std::sin(std::numbers::pi * x) +
                                    std::exp(-x) + 0.15)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(functions_do_not_disturb_one_another) {
  const auto one = parse_expression("p", "x*c", {{"c", 2}});
  auto other = parse_expression("p", "x*c", {{"c", 5}});
  const auto copy = other;
  BOOST_TEST(one(3) + other(1) == 11);
  other = nullptr;
  BOOST_TEST(copy(2) == 10);
  BOOST_TEST(one(3) == 6);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_told_by_column) {
  struct Wrong {
    std::string formula;
    std::string place;
  };
  for (const Wrong& wrong : {Wrong{"p0*(1-(y/a)^4)", "column 8: unexpected token \"y\""},
                             {"p0*(1-(x/a)^4", "column 14: "},
                             {"p0**2", "column 4: "},
                             {"2 $ 3", "column 3: "},
                             {"sin()", "column 5: "},
                             {"p0+", "column 4: "}}) {
    const std::string refusal = refusal_of(wrong.formula);
    BOOST_TEST(refusal.starts_with("p \"" + wrong.formula + "\", " + wrong.place), refusal);
    BOOST_TEST(refusal.find('\n') == std::string::npos);
  }
  BOOST_TEST(refusal_of("x,1").find("holds 2 formulas") != std::string::npos, refusal_of("x,1"));
}

BOOST_AUTO_TEST_CASE(a_value_that_is_not_finite_is_told_with_its_x) {
  for (const char* formula : {"1/(x-0.5)", "sqrt(x-1)", "ln(x-0.5)"}) {
    const std::string refusal = refusal_of(formula);
    BOOST_TEST(refusal.find("has no finite value at x = 0.5") != std::string::npos, refusal);
  }
}

BOOST_AUTO_TEST_SUITE_END()
