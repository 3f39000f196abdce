// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/found.hpp"

#include <boost/test/unit_test.hpp>
#include <charconv>
#include <cmath>
#include <random>
#include <regex>
#include <stdexcept>
#include <string>

BOOST_AUTO_TEST_SUITE(found_test)

using literate::apart_phrase;
using literate::Distance;
using literate::exact;
using literate::fixed;
using literate::Format;
using literate::found_phrase;
using literate::integer;
using literate::percent;
using literate::scientific;
using literate::Side;
using literate::significant;
using literate::supported;
using literate::uncertain;
using literate::Value;

namespace {

std::string at_most(const Value& quantity, double limit) {
  return found_phrase(quantity, limit, Side::at_most).plain;
}

std::string at_least(const Value& quantity, double limit) {
  return found_phrase(quantity, limit, Side::at_least).plain;
}

double number_in(std::string text) {
  const auto digit = text.find_first_of("-0123456789");
  double number = 0;
  std::from_chars(text.data() + digit, text.data() + text.size(), number);
  return number;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_value_is_printed_and_not_the_decade_above_it) {
  BOOST_TEST(at_most(Value({3.43e-11, 1e-12}, scientific(1).rounded_up()), 1e-10) == "3.4e-11");
  BOOST_TEST(at_most(Value({1.41e-14, 4e-15}, scientific(1).rounded_up()), 1e-9) == "1e-14");
  BOOST_TEST(at_most(Value({0.0206, 1e-5}, percent(1).rounded_up()), 0.03) == "2.1 %");
  BOOST_TEST(at_most(Value({0.000213, 1e-9}, percent(2).rounded_up()), 0.01) == "0.021 %");
  BOOST_TEST(at_most(Value(4.7e-5, scientific(1).rounded_up()).as_is(), 1) == "4.7e-5");
}

BOOST_AUTO_TEST_CASE(a_bound_of_two_digits_is_printed_as_in_the_text_unless_it_crosses_the_limit) {
  BOOST_TEST(at_most(Value({7.41e-5, 1e-9}, scientific(2).rounded_up()), 1e-3) == "7.5e-5");
  BOOST_TEST(at_most(Value({0.00206, 1e-6}, percent(2).rounded_up()), 0.01) == "0.21 %");
  BOOST_TEST(at_most(Value({7.41e-5, 1e-9}, scientific(2).rounded_up()), 7.45e-5) == "7.41e-5");
}

BOOST_AUTO_TEST_CASE(the_digits_of_the_format_are_kept_where_the_verdict_can_be_read_off) {
  BOOST_TEST(at_most(Value({0.00074, 1e-6}, percent(3)), 0.001) == "0.074 %");
  BOOST_TEST(at_least(Value({15.987, 1e-3}, significant(4), "lbf/in"), 10) == "15.99 lbf/in");
  BOOST_TEST(at_most(Value(7, integer()), 9) == "7");
  BOOST_TEST(at_most(Value({2.3851, 0.02}, significant(4)), 9) == "2.4");
  BOOST_TEST(at_most(Value({2.3851, 0.02}, uncertain()), 9) == "2.385 ± 0.021");
}

BOOST_AUTO_TEST_CASE(a_value_below_its_error_is_told_by_what_it_is_at_most) {
  BOOST_TEST(at_most(Value({3e-15, 3.61e-11}, scientific(1).rounded_up()), 1e-10) ==
             "at most 3.7e-11");
  BOOST_TEST(at_most(Value({-3e-15, 3.61e-11}, significant(3), "in"), 1e-10) ==
             "at most 3.7e-11 in");
  BOOST_TEST(at_most(Value({0, 1.63e-6}, percent(2)), 0.1) == "at most 0.00017 %");
  BOOST_TEST(at_most(Value({0, 1.63e-9}, percent(2)), 0.1) == "at most 1.7e-7 %");
  BOOST_TEST(at_most(Value(0, significant(2)).as_is(), 1) == "0");
}

BOOST_AUTO_TEST_CASE(a_value_below_its_error_and_beyond_its_limit_is_told_from_the_limits_side) {
  BOOST_TEST(at_least(Value({2e-13, 8.55e-13}, scientific(1)), 1e-3) == "at most 1.1e-12");
  BOOST_TEST(at_most(Value({-2e-13, 8.55e-13}, scientific(1)), -1e-3) == "at least -1.1e-12");
  BOOST_TEST(at_least(Value({2e-13, 8.55e-13}, scientific(1)), -1e-3) == "at least -6.6e-13");
}

BOOST_AUTO_TEST_CASE(a_rounded_value_does_not_cross_its_limit) {
  BOOST_TEST(at_most(Value({1.0004, 1e-5}, significant(2)), 1) == "1.0004");
  BOOST_TEST(at_most(Value({0.9996, 1e-5}, significant(2)), 1) == "1.0");
  BOOST_TEST(at_least(Value({0.9996, 1e-5}, significant(2)), 1) == "0.9996");
  BOOST_TEST(at_least(Value({0.10004, 1e-7}, percent(0)), 0.1) == "10 %");
  BOOST_TEST(at_most(Value({0.10004, 1e-7}, percent(0)), 0.1) == "10.004 %");
  BOOST_TEST(at_most(Value(1.0004, fixed(1)).as_is(), 1) == "1.0004");
}

BOOST_AUTO_TEST_CASE(a_bound_does_not_cross_a_limit_that_it_satisfies) {
  BOOST_TEST(at_most(Value({0, 1.002e-9}, scientific(1)), 1.01e-9) == "at most 1.01e-9");
  BOOST_TEST(at_most(Value({0, 1.002e-9}, scientific(1)), 1e-9) == "at most 1.1e-9");
}

BOOST_AUTO_TEST_CASE(the_error_is_printed_where_it_supports_too_few_digits_to_see_the_side) {
  BOOST_TEST(at_most(Value({1.03, 0.02}, significant(4)), 1) == "1.030 ± 0.020");
  BOOST_TEST(at_most(Value({1.03, 0.02}, supported()), 1) == "1.030 ± 0.020");
  BOOST_TEST(at_most(Value({0.0103, 2e-4}, percent(2)), 0.01) == "(1.030 ± 0.020) %");
}

BOOST_AUTO_TEST_CASE(what_is_printed_is_on_the_side_of_what_was_found_for_any_number) {
  std::mt19937_64 random(20017);
  std::uniform_real_distribution<double> exponent(-5, 1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Format formats[] = {significant(2), scientific(1), fixed(2), scientific(1).rounded_up(),
                            fixed(1).rounded_up()};
  for (int i = 0; i < 5000; ++i) {
    const double limit = 1.25;
    const double value = limit * (1 + uniform(random) * std::pow(10, exponent(random)));
    const double error = std::abs(value) * std::pow(10, exponent(random) - 1.5);
    if (value - error < 0 || std::abs(value - limit) <= error) continue;
    const Value quantity({value, error}, formats[i % 5]);
    BOOST_TEST((number_in(at_most(quantity, limit)) <= limit) == (value <= limit),
               value << " with " << error << " is printed " << at_most(quantity, limit));
    BOOST_TEST((number_in(at_least(quantity, limit)) >= limit) == (value >= limit),
               value << " with " << error << " is printed " << at_least(quantity, limit));
  }
}

BOOST_AUTO_TEST_CASE(a_printed_bound_is_never_below_number_and_error) {
  std::mt19937_64 random(20018);
  std::uniform_real_distribution<double> exponent(-20, 5);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    const double error = std::pow(10, exponent(random));
    const double value = 0.999 * share(random) * error;
    const double limit = std::pow(10, exponent(random));
    const std::string printed = at_most(Value({value, error}, scientific(1)), limit);
    const bool is_upper = printed.starts_with("at most");
    BOOST_TEST(
        (is_upper ? number_in(printed) >= value + error : number_in(printed) <= value - error),
        value << " with " << error << " is printed " << printed);
    if (value + error <= limit) BOOST_TEST(number_in(printed) <= limit);
  }
}

BOOST_AUTO_TEST_CASE(what_is_printed_apart_is_the_difference_of_its_printed_numbers) {
  std::mt19937_64 random(20019);
  std::uniform_real_distribution<double> exponent(-6, 0);
  std::uniform_real_distribution<double> share(-1, 1);
  const Format formats[] = {significant(2), scientific(3), fixed(1), supported(), uncertain()};
  const std::string number = "\\(?(-?\\d+(?:\\.\\d+)?)( ± [.0-9]+)?\\)?(e-?\\d+)?";
  const std::regex sentence(number + ", (at most )?" + number + " from " + number);
  int n_with_error = 0;
  for (const Side side : {Side::at_most, Side::at_least})
    for (int i = 0; i < 5000; ++i) {
      const double stated = 1 + share(random);
      const double computed = stated + share(random) * std::pow(10, exponent(random));
      const double error = std::pow(10, exponent(random) - 1);
      const double difference = std::abs(computed - stated);
      const double limit = difference * std::pow(10, exponent(random) + 3);

      const std::string printed =
          apart_phrase(Value({computed, error}, formats[i % 5]),
                       Value(stated, significant(2)).as_is(),
                       Value({difference, error}, significant(2)), limit, side, Distance::absolute)
              .plain;

      std::smatch parts;
      BOOST_TEST_REQUIRE(std::regex_match(printed, parts, sentence), printed);
      const auto number_at = [&](std::size_t group) {
        return std::stod(parts[group].str() + parts[group + 2].str());
      };
      const double seen = std::abs(number_at(1) - number_at(8));
      const double told = number_at(5);
      const bool is_bound = parts[4].matched;
      const bool has_error = parts[6].matched;
      n_with_error += has_error ? 1 : 0;
      if (seen < 1e-13) {
        BOOST_TEST((is_bound || has_error || (side == Side::at_most && difference <= limit)),
                   printed);
      } else if (is_bound) {
        BOOST_TEST(seen <= told + 1e-13, printed << " of " << computed << " " << stated);
      } else {
        const std::string digits = parts[5];
        const auto point = std::min(digits.find('.'), digits.size() - 1);
        const double exponent_told = parts[7].matched ? std::stod(parts[7].str().substr(1)) : 0;
        const double unit =
            std::pow(10, exponent_told - static_cast<double>(digits.size() - 1 - point));
        BOOST_TEST(std::abs(seen - told) < (has_error ? 1.6 : 0.49999999) * unit,
                   printed << " of " << computed << " ± " << error << " and " << stated);
        if (!has_error) BOOST_TEST((seen < limit) == (difference < limit), printed);
      }
    }
  BOOST_TEST(n_with_error < 5000);
}

BOOST_AUTO_TEST_CASE(what_has_no_number_or_no_error_is_refused) {
  BOOST_CHECK_THROW(at_most(Value::text("eleven"), 1), std::invalid_argument);
  BOOST_CHECK_THROW(at_most(Value(0.5, fixed(1)), 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(latex_has_the_same_numbers) {
  BOOST_TEST(found_phrase(Value({0, 3.61e-11}, scientific(1), "in"), 1, Side::at_most).latex ==
             "at most \\qty{3.7e-11}{in}");
  BOOST_TEST(found_phrase(Value({0.5, 1e-4}, percent(0)), 1, Side::at_most).latex ==
             "\\qty{50}{\\percent}");
}

BOOST_AUTO_TEST_SUITE_END()
