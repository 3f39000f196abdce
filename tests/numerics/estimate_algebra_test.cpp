// SPDX-License-Identifier: GPL-3.0-or-later
// Random expressions, each computed a second time with a hundred digits from numbers that its
// operands hold: at their ends and between.
#include "numerics/estimate_algebra.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "multiprecision.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(estimate_algebra_test)

using numerics::Estimate;

namespace {

// An expression in which each operand stands once.
struct Expression {
  enum Kind {
    operand,
    add,
    subtract,
    multiply,
    divide,
    greater,
    scale,
    root,
    power,
    exponential,
    logarithm,
    sine,
    cosine,
    arctangent,
    magnitude,
    n_kinds
  };

  Kind kind = operand;
  double constant = 0;  // the factor or the exponent
  Estimate of_operand = {};
  std::vector<Expression> parts = {};
};

Expression random_expression(RandomInputs& random, int depth) {
  using enum Expression::Kind;
  if (depth == 0 || random.uniform(0, 1) < 0.2) {
    const double value = random.sign() * random.log_uniform(1e-3, 1e3);
    const bool is_exact = random.uniform(0, 1) < 0.2;
    const double error = is_exact ? 0 : std::abs(value) * random.log_uniform(1e-18, 0.3);
    return {.of_operand = {value, error}};
  }
  Expression made;
  made.kind = static_cast<Expression::Kind>(static_cast<int>(random.uniform(add, n_kinds)));
  made.constant = made.kind == power ? std::floor(random.uniform(-4, 5)) : random.uniform(-10, 10);
  if (made.kind == power && random.sign() > 0) made.constant += 0.5;
  made.parts.push_back(random_expression(random, depth - 1));
  if (made.kind >= add && made.kind <= greater) {
    made.parts.push_back(random_expression(random, depth - 1));
  }
  return made;
}

// With the operands as `value_of` gives them, in any arithmetic.
template <class Number, class ValueOf>
Number computed(const Expression& e, const ValueOf& value_of) {
  using std::abs, std::atan, std::cos, std::exp, std::log, std::max, std::pow, std::sin, std::sqrt;
  using enum Expression::Kind;
  if (e.kind == operand) return value_of(e);
  const Number a = computed<Number>(e.parts[0], value_of);
  switch (e.kind) {
    case add:
      return a + computed<Number>(e.parts[1], value_of);
    case subtract:
      return a - computed<Number>(e.parts[1], value_of);
    case multiply:
      return a * computed<Number>(e.parts[1], value_of);
    case divide:
      return a / computed<Number>(e.parts[1], value_of);
    case greater:
      return max(a, computed<Number>(e.parts[1], value_of));
    case scale:
      return e.constant * a;
    case root:
      return sqrt(a);
    case power:
      return pow(a, e.constant);
    case exponential:
      return exp(a);
    case logarithm:
      return log(a);
    case sine:
      return sin(a);
    case cosine:
      return cos(a);
    case arctangent:
      return atan(a);
    default:
      return abs(a);
  }
}

bool holds(Estimate bound, const Precise& number) {
  const Precise rounding = mpfr::abs(number) * 1e-98;  // of the hundred digits themselves
  return mpfr::abs(number - bound.value) <= bound.abs_error + rounding;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bounds_hold_what_random_expressions_are_and_are_not_much_wider) {
  constexpr int n_wanted = 20'000;
  RandomInputs random(29);
  std::vector<double> widths;  // over the widest that was met
  int n_tried = 0;
  for (int n = 0; n < n_wanted; ++n_tried) {
    const Expression e = random_expression(random, 3);
    Estimate bound;
    try {
      bound = computed<Estimate>(e, [](const Expression& leaf) { return leaf.of_operand; });
    } catch (const sys::InvalidQuantity&) {
      continue;
    }
    ++n;
    Precise widest = std::abs(bound.value) * 0x1p-53;
    for (int k = 0; k < 12; ++k) {
      const Precise number = computed<Precise>(e, [&](const Expression& leaf) {
        const double where = k < 8 ? random.sign() : random.uniform(-1, 1);
        return Precise(leaf.of_operand.value) + Precise(where) * leaf.of_operand.abs_error;
      });
      BOOST_TEST_REQUIRE(holds(bound, number));
      widest = mpfr::max(widest, mpfr::abs(number - bound.value));
    }
    if (bound.abs_error > 0) widths.push_back((bound.abs_error / widest).toDouble());
  }
  BOOST_TEST(n_tried < 4 * n_wanted);
  std::ranges::nth_element(widths, widths.begin() + std::ssize(widths) / 2);
  BOOST_TEST(widths[widths.size() / 2] < 4);
}

BOOST_AUTO_TEST_CASE(what_is_exact_stays_exact) {
  const Estimate sum = Estimate{2, 0} + 3 - Estimate{0.5, 0};
  const Estimate product = Estimate{3, 0} * Estimate{0.25, 0};
  const Estimate quotient = Estimate{3, 0} / 4;
  const Estimate root = sqrt(Estimate{9, 0});

  BOOST_TEST(sum.abs_error == 0);
  BOOST_TEST(product.abs_error == 0);
  BOOST_TEST(quotient.abs_error == 0);
  BOOST_TEST(root.abs_error == 0);
  BOOST_TEST(root.value == 3);
}

BOOST_AUTO_TEST_CASE(a_quotient_has_the_errors_of_both) {
  const Estimate quotient = Estimate{6, 0.6} / Estimate{2, 0.5};  // from 5.4/2.5 to 6.6/1.5

  BOOST_TEST(quotient.value == 3);
  BOOST_TEST(quotient.abs_error == 1.4, boost::test_tools::tolerance(1e-15));
  BOOST_TEST((1 / Estimate{4, 1}).abs_error == 1.0 / 12, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(an_even_power_of_what_may_be_zero_reaches_the_greater_end) {
  const Estimate square = pow(Estimate{1, 2}, 2);

  BOOST_TEST(square.value == 1);
  BOOST_TEST(square.abs_error == 9, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(pow(Estimate{-2, 1}, 2).abs_error == 5, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(pow(Estimate{-1, 0.5}, 3).abs_error == 2.375, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(an_angle_changes_a_sine_no_more_than_the_sine_can_change) {
  BOOST_TEST(sin(Estimate{0, 100}).abs_error == 2, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(cos(Estimate{0, 1e-3}).abs_error < 6e-7);
}

BOOST_AUTO_TEST_CASE(what_has_no_bound_is_refused) {
  const auto message_of = [](const auto& call) {
    try {
      call();
    } catch (const sys::InvalidQuantity& error) {
      return std::string(error.what());
    }
    return std::string();
  };

  BOOST_TEST(message_of([] {
               return 1 / Estimate{1e-3, 1e-3};
             }) == "divisor = 0.001: must be farther from 0 than its error, 0.001");
  BOOST_TEST(message_of([] {
               return log(Estimate{1, 1});
             }) == "argument of log = 1: must be above 0 by more than its error, 1");
  BOOST_TEST(message_of([] {
               return sqrt(Estimate{1, 2});
             }) == "radicand = 1: must be above 0 by at least its error, 2");
  BOOST_TEST(message_of([] {
               return pow(Estimate{-1, 0}, 0.5);
             }) == "base of a power = -1: must be above 0 by more than its error, 0");
  BOOST_TEST(message_of([] {
               return exp(Estimate{700, 20});
             }) == "a number with a bound = inf: must be a finite number");
  BOOST_CHECK_THROW(pow(Estimate{0, 0}, -1), sys::InvalidQuantity);
  BOOST_CHECK_THROW((Estimate{1e200, 0} * Estimate{1e200, 0}), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
