// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/estimate.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "multiprecision.hpp"
#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(estimate_test)

using numerics::Estimate;

namespace {

Precise end_of(Estimate e, double share) {
  return Precise(e.value) + Precise(share) * Precise(e.abs_error);
}

struct Operation {
  std::string name;
  std::function<Estimate(Estimate, Estimate)> estimate;
  std::function<Precise(const Precise&, const Precise&)> exact;
};
const std::vector<Operation> operations{
    {"+", [](Estimate a, Estimate b) { return a + b; },
     [](const Precise& a, const Precise& b) { return Precise(a + b); }},
    {"-", [](Estimate a, Estimate b) { return a - b; },
     [](const Precise& a, const Precise& b) { return Precise(a - b); }},
    {"*", [](Estimate a, Estimate b) { return a * b; },
     [](const Precise& a, const Precise& b) { return Precise(a * b); }},
    {"/", [](Estimate a, Estimate b) { return a / b; },
     [](const Precise& a, const Precise& b) { return Precise(a / b); }},
    {"number *", [](Estimate a, Estimate b) { return a.value * b; },
     [](const Precise& a, const Precise& b) { return Precise(a * b); }},
    {"number /", [](Estimate a, Estimate b) { return a.value / b; },
     [](const Precise& a, const Precise& b) { return Precise(a / b); }},
    {"max", [](Estimate a, Estimate b) { return max(a, b); },
     [](const Precise& a, const Precise& b) { return a > b ? a : b; }},
    {"abs", [](Estimate a, Estimate) { return abs(-a); },
     [](const Precise& a, const Precise&) { return Precise(abs(a)); }},
    {"sqrt", [](Estimate a, Estimate) { return sqrt(a); },
     [](const Precise& a, const Precise&) { return Precise(sqrt(a)); }},
    {"log", [](Estimate a, Estimate) { return log(a); },
     [](const Precise& a, const Precise&) { return Precise(log(a)); }},
    {"exp", [](Estimate a, Estimate) { return exp(a); },
     [](const Precise& a, const Precise&) { return Precise(exp(a)); }}};

}  // namespace

BOOST_AUTO_TEST_CASE(the_bound_holds_for_any_numbers_within_those_of_the_operands) {
  RandomInputs random(17);
  for (const Operation& operation : operations) {
    const bool is_exact_first = operation.name.starts_with("number");
    for (int i = 0; i < 3000; ++i) {
      const double x = random.log_uniform(1e-2, 1e2), y = random.log_uniform(1e-2, 1e2);
      const Estimate a{x, is_exact_first ? 0 : x * random.log_uniform(1e-18, 0.9)};
      const Estimate b{y, y * random.log_uniform(1e-18, 0.9)};
      const Estimate found = operation.estimate(a, b);
      for (const double share : {-1.0, -0.385, 1.0}) {
        for (const double other : {-1.0, 0.7, 1.0}) {
          const Precise exact = operation.exact(end_of(a, share), end_of(b, other));
          BOOST_TEST_CONTEXT(operation.name << " " << a.value << " ± " << a.abs_error << ", "
                                            << b.value << " ± " << b.abs_error) {
            BOOST_TEST(abs(found.value - exact).toDouble() <= found.abs_error);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_bound_is_not_much_larger_than_its_operands_require) {
  const Estimate a{2.5, 1e-6}, b{-1.25, 1e-7};
  BOOST_TEST(std::abs((a + b).abs_error / 1.1e-6 - 1) < 1e-8);
  BOOST_TEST(std::abs((a - b).abs_error / 1.1e-6 - 1) < 1e-8);
  BOOST_TEST(std::abs((a * b).abs_error / 1.5e-6 - 1) < 1e-6);
  BOOST_TEST(std::abs((a / b).abs_error / 0.96e-6 - 1) < 1e-6);
  BOOST_TEST(std::abs((-4.0 * a).abs_error / 4e-6 - 1) < 1e-8);
  BOOST_TEST(std::abs(exp(a).abs_error / (1e-6 * std::exp(2.5)) - 1) < 1e-6);
  BOOST_TEST(std::abs(log(a).abs_error / 0.4e-6 - 1) < 1e-6);
  BOOST_TEST(sqrt(a).abs_error < 1e-6);
}

BOOST_AUTO_TEST_CASE(where_no_bound_exists_it_is_infinite) {
  BOOST_TEST(std::isinf((Estimate{1, 0} / Estimate{0.5, 0.5}).abs_error));
  BOOST_TEST(std::isinf((1.0 / Estimate{0, 0}).abs_error));
  BOOST_TEST(std::isinf(log(Estimate{0.5, 0.7}).abs_error));
  BOOST_TEST(sqrt(Estimate{0, 0.04}).abs_error >= 0.2);
}

BOOST_AUTO_TEST_SUITE_END()
