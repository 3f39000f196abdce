// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page_numbers.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(page_numbers_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(digits_from_five_on_are_grouped_from_the_point) {
  BOOST_TEST(number_html("1234") == "1234");
  BOOST_TEST(number_html("12345.678901") == "12\u202F345.678\u202F901");
}

BOOST_AUTO_TEST_CASE(a_minus_is_one_and_an_exponent_is_raised) {
  BOOST_TEST(number_html("-1.5e-6") == "\u22121.5\u202F×\u202F10<sup>\u22126</sup>");
  BOOST_TEST(number_html("e-5") == "10<sup>\u22125</sup>");
}

BOOST_AUTO_TEST_CASE(an_uncertainty_stands_in_parentheses) {
  BOOST_TEST(number_html("2.345679(20)") == "2.345\u202F679(20)");
}

BOOST_AUTO_TEST_CASE(what_is_no_number_stays) {
  BOOST_TEST(number_html("a<b") == "a&lt;b");
  BOOST_TEST(number_html("1.(2)") == "1.(2)");
}

BOOST_AUTO_TEST_CASE(units_are_set_apart_and_their_powers_raised) {
  BOOST_TEST(quantity_html("1.2", "N.m^{-2}") == "1.2\u202FN\u202Fm<sup>\u22122</sup>");
  BOOST_TEST(quantity_html("5", "\\percent") == "5\u202F%");
}

BOOST_AUTO_TEST_CASE(numbers_of_a_column_have_one_width) {
  // Two digits before the point and one behind it, with a sign.
  BOOST_TEST(number_cell_html("-2.1", "-37.5") == "\u221237.5");
  BOOST_TEST(number_cell_html("-2.1", "8.9") == "\u2007\u2007\u20058.9");
  BOOST_TEST(number_cell_html("-2.1", "2") == "\u2007\u2007\u20052\u2008\u2007");
}

BOOST_AUTO_TEST_CASE(a_mark_stands_behind_the_last_digit) {
  BOOST_TEST(number_cell_html("1.3", "0.5", "<sup>a</sup>") == "0.5<sup>a</sup>\u2007\u2007");
}

BOOST_AUTO_TEST_CASE(in_a_formula_a_number_is_one_token) {
  BOOST_TEST(number_mathml("-1.5e3") ==
             "<mrow><mo form=\"prefix\">\u2212</mo><mn>1.5</mn><mo>×</mo><msup><mn>10</mn><mrow>"
             "<mn>3</mn></mrow></msup></mrow>");
}

BOOST_AUTO_TEST_SUITE_END()
