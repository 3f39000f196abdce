// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/decimal.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <string>

BOOST_AUTO_TEST_SUITE(decimal_test)

using sys::number_of;
using sys::parse_decimal;
using sys::parsed;

BOOST_AUTO_TEST_CASE(text_beside_the_number_is_an_error) {
  BOOST_TEST((parsed<double>("0.1") == 0.1));
  BOOST_TEST((parsed<int>("-12") == -12));
  for (const char* text : {"", "1 ", " 1", "1,5", "0x1", "+1", "1e999", "one"}) {
    BOOST_TEST(!parsed<double>(text).has_value(), text);
  }
  BOOST_TEST(!parsed<int>("3000000000").has_value());
}

BOOST_AUTO_TEST_CASE(a_decimal_keeps_all_digits) {
  const auto written = [](const char* text) -> std::string {
    const auto number = parse_decimal(text);
    if (!number) return "none";
    return (number->negative ? "-" : "") + number->digits + "e" + std::to_string(number->place);
  };

  BOOST_TEST(written("1.6236048e-006") == "16236048e-13");
  BOOST_TEST(written("-1.50e3") == "-150e1");
  BOOST_TEST(written("+.5") == "5e-1");
  BOOST_TEST(written("12E+2") == "12e2");
  BOOST_TEST(written("007.") == "7e0");
  BOOST_TEST(written("-0.00") == "0e-2");
  for (const char* text :
       {"", "-", ".", "e5", "1e", "1e+", "1e+-2", "1.2.3", "1x", "0x10", "nan", "--1"}) {
    BOOST_TEST(written(text) == "none", text);
  }
}

BOOST_AUTO_TEST_CASE(a_decimal_is_rounded_to_the_nearest_double_infinity_or_zero) {
  BOOST_TEST(number_of({false, "16236048", -13}) == 1.6236048e-6);
  BOOST_TEST(number_of({true, "1", -1}) == -0.1);
  BOOST_TEST(number_of({false, "1", 999}) == std::numeric_limits<double>::infinity());
  BOOST_TEST(number_of({true, "12", 999}) == -std::numeric_limits<double>::infinity());
  BOOST_TEST(number_of({false, "1", -999}) == 0.0);
}

BOOST_AUTO_TEST_CASE(the_shortest_digits_of_a_double_have_no_trailing_zero) {
  const auto text_of = [](double number) {
    const auto [negative, digits, place] = sys::shortest(number);
    return (negative ? "-" : "") + digits + "e" + std::to_string(place);
  };
  BOOST_TEST(text_of(-45500) == "-455e2");
  BOOST_TEST(text_of(0.1) == "1e-1");
  BOOST_TEST(text_of(1e22) == "1e22");
  BOOST_TEST(text_of(-0.0) == "0e0");
}

BOOST_AUTO_TEST_SUITE_END()
