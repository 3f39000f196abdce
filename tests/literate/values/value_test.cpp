// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/value.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "literate/values/rounding.hpp"
#include "messages.hpp"
#include "numbers.hpp"

using literate::exact;
using literate::fixed;
using literate::Format;
using literate::integer;
using literate::Number;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::uncertain;
using literate::Value;
using numerics::Estimate;

namespace {

std::string problem_of(const Value& value) {
  return message_of<std::invalid_argument>([&] { value.require_valid(); });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(value_test)

BOOST_AUTO_TEST_CASE(latex_groups_digits_and_works_in_text_and_in_formulas) {
  const auto latex = [](const Value& value) { return value.latex(); };
  BOOST_TEST(latex(Value(31220, integer())) == "\\ensuremath{31\\,220}");
  BOOST_TEST(latex(Value(1234, integer())) == "\\ensuremath{1234}");
  BOOST_TEST(latex(Value({0.786151378, 1.2e-7}, uncertain())) ==
             "\\ensuremath{0.786\\,151\\,38\\pm 0.000\\,000\\,13}");
  BOOST_TEST(latex(Value(Estimate{-1250, 1}, significant(2), "N")) ==
             "\\ensuremath{-1.2\\times10^{3}\\,\\mathrm{N}}");
  BOOST_TEST(latex(Value({1251.2, 0.66, 51.5}, uncertain(), "psi")) ==
             "\\ensuremath{(1251(52)\\pm 1)\\,\\mathrm{psi}}");
  BOOST_TEST(latex(Value({4.7e-9, 0, 1.8e-9}, uncertain(), "m")) ==
             "\\ensuremath{4.7(18)\\times10^{-9}\\,\\mathrm{m}}");
  BOOST_TEST(latex(Value(90, exact(), "degree")) == "\\ensuremath{90^{\\circ}}");
  BOOST_TEST(latex(Value(Estimate{0.125, 1e-9}, percent(1))) == "\\ensuremath{12.5\\,\\%}");
  BOOST_TEST(latex(Value::text("--nodes 91")) == "-{}-nodes 91");
}

BOOST_AUTO_TEST_CASE(only_earned_digits_are_printed) {
  RandomInputs random(20261128);
  for (int i = 0; i < 2000; ++i) {
    const double number = random.sign() * random.log_uniform(1e-9, 1e9);
    const double bound = std::abs(number) * random.log_uniform(1e-6, 10);
    for (const Format& format : {significant(9), fixed(9), scientific(9), percent(9)}) {
      const auto printed = literate::rounded(format, number, Number(number, bound));
      if (!printed.bound.empty()) continue;  // printed with its error
      const double unit = std::pow(10, printed.decimal.place);
      BOOST_REQUIRE_GE(unit * (1 + 1e-9), bound);
      BOOST_REQUIRE_LE(std::abs(number_of(printed.decimal) - number), unit / 2 * (1 + 1e-9));
    }
    // The printed bound includes the rounding of the printed number.
    const auto with_bound = literate::rounded(uncertain(), number, Number(number, bound));
    const double stated =
        std::stod(with_bound.bound) * std::pow(10, with_bound.exponent.value_or(0));
    BOOST_REQUIRE_GE(stated * (1 + 1e-9), bound + std::abs(number_of(with_bound.decimal) - number));
    if (number < 0) continue;
    for (const Format& format : {significant(2), fixed(3), scientific(1)}) {
      const auto up = literate::rounded(format.rounded_up(), number, Number(number, bound));
      BOOST_REQUIRE_GE(number_of(up.decimal), number + bound);
    }
  }
}

BOOST_AUTO_TEST_CASE(earned_digits_limit_val) {
  BOOST_TEST(Value(Estimate{2.0064, 3e-4}, significant(2), "s").n_earned_digits() == 4);
  BOOST_TEST(Value({79.4, 0, 0.3}, uncertain()).n_earned_digits() == 3);
  BOOST_TEST(Value(Estimate{9.996, 0.01}, significant(2)).n_earned_digits() == 4);  // 10.00
  BOOST_TEST(Value(9.80665, exact()).n_earned_digits() == 6);
  BOOST_TEST(Value(31220, integer()).n_earned_digits() == 5);
  BOOST_TEST(Value(Estimate{1.0 / 3, 1e-16}, significant(2)).n_earned_digits() == 12);
  BOOST_TEST(Value(1.0 / 3, significant(3)).as_is().n_earned_digits() == 3);
  BOOST_TEST(Value(Estimate{0.31, 0.01}, significant(1).rounded_up()).n_earned_digits() == 3);
  BOOST_TEST(Value(Estimate{0.1, 0.5}, significant(3)).n_earned_digits() == 0);
  BOOST_TEST(Value::text("x").n_earned_digits() == 0);

  const Value value(Estimate{1250.4, 0.4}, fixed(1), "N");
  const auto with_digits = [&](int n) {
    return value.formatted(value.format().with_digits(n)).printed();
  };
  BOOST_TEST(with_digits(2) == "1.3e3 N");
  BOOST_TEST(with_digits(4) == "1250 N");
  BOOST_TEST(with_digits(9) == "1250 N");
}

BOOST_AUTO_TEST_CASE(the_use_of_an_invalid_value_is_an_error) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  BOOST_TEST(problem_of({nan, exact()}) == "nan is not finite");
  BOOST_TEST(problem_of({{1, nan}, fixed(1)}) == "the bound nan is not finite or below zero");
  BOOST_TEST(problem_of({{1, -0.1}, fixed(1)}) == "the bound -0.1 is not finite or below zero");
  BOOST_TEST(problem_of({{1, 0, infinite}, uncertain()}) ==
             "the standard uncertainty inf is not finite or below zero");
  BOOST_TEST(holds(problem_of({2.9, fixed(1)}), "2.9 has no error"));
  BOOST_TEST(problem_of({2.5, integer()}) == "2.5 is not a whole number");
  BOOST_TEST(problem_of({{2, 0.1}, integer()}) ==
             "2 has an error and cannot be printed as integer()");
  BOOST_TEST(problem_of(Value(2.5, uncertain()).as_is()) ==
             "2.5 has no error, which uncertain() prints");
  BOOST_TEST(problem_of({{1, 0.1}, significant(0)}) == "0 significant digits: there are 1 to 17");
  BOOST_TEST(problem_of({{1, 0.1}, fixed(-1)}) == "-1 decimals: there are 0 to 100");
  BOOST_TEST(holds(problem_of({1, exact(), "{ }"}), "'{ }' is not a unit"));
  BOOST_TEST(problem_of({{0.1, 0.01}, percent(1), "m"}) ==
             "a percentage has no other unit, such as m");
  BOOST_TEST(holds(problem_of({{-3, 1}, fixed(1).rounded_up()}), "-2 is negative"));
  BOOST_TEST(holds(problem_of({{3, 0, 1}, fixed(1).rounded_up()}), "which is not a bound"));
  BOOST_TEST(problem_of({3, exact().rounded_up()}) == "exact() cannot round up");
  BOOST_TEST(holds(problem_of(Value::text("x").as_is()), "it is a text"));
  BOOST_TEST(holds(problem_of(Value::text("\xff")), "not UTF-8"));
}

BOOST_AUTO_TEST_CASE(a_format_reads_back_from_its_text) {
  for (const char* text : {"significant(4)", "fixed(2)", "scientific(3)", "percent(1)", "integer()",
                           "exact()", "uncertain()", "significant(2).in_percent()",
                           "percent(0).rounded_up()", "scientific(1).in_percent().rounded_up()"}) {
    BOOST_TEST(Format::parse(text).text() == text);
  }
  for (const char* text : {"", "fixed", "fixed()", "fixed(2", "fixed(x)", "exact(2)", "round(2)",
                           "fixed(2).up()", "fixed)2("}) {
    BOOST_CHECK_THROW(Format::parse(text), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_SUITE_END()
