// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/limit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "message_of.hpp"

BOOST_AUTO_TEST_SUITE(formula_test, *boost::unit_test::tolerance(1e-15))

using literate::evaluated;

BOOST_AUTO_TEST_CASE(a_formula_has_the_number_that_a_reader_gives_it) {
  BOOST_TEST(evaluated("2 + 3·4", {}) == 14.0);
  BOOST_TEST(evaluated("7 − 2 − 1.5", {}) == 3.5);
  BOOST_TEST(evaluated("12/2/3", {}) == 2.0);
  BOOST_TEST(evaluated("(c/a)²(a/z)⁴", {{"c", 3}, {"a", 2}, {"z", 4}}) == 2.25 / 16);
  BOOST_TEST(evaluated("2(a/d)² + 2δ/s", {{"a", 1}, {"d", 10}, {"δ", 1e-3}, {"s", 4}}) == 0.0205);
  BOOST_TEST(evaluated("ε[1 + ln(2/ε)]", {{"ε", 1e-9}}) == 1e-9 * (1 + std::log(2e9)));
  BOOST_TEST(evaluated("−a² + 2", {{"a", 3}}) == -7.0);
  BOOST_TEST(evaluated("2(-a + 5)", {{"a", 3}}) == 4.0);
  BOOST_TEST(evaluated("0.95·2 ln(𝑟)", {{"𝑟", 1000}}) == 1.9 * std::log(1000));
}

BOOST_AUTO_TEST_CASE(a_name_that_begins_with_another_one_is_read_whole) {
  BOOST_TEST(evaluated("a₁a", {{"a", 2}, {"a₁", 5}}) == 10.0);
}

BOOST_AUTO_TEST_CASE(what_is_no_formula_is_refused_with_its_text) {
  for (const char* wrong : {"", "2 +", "2/", "(a", "[a)", "b", "a b", "ln", "a)", "a^2", "a²³",
                            "2²²", "1 000 a", "1.5.2", "a 2", "(a)2", "−", "2·−a", "a − −a"}) {
    const std::string message = message_of<std::invalid_argument>([&] {
      (void)evaluated(wrong, {{"a", 2}});
    });
    BOOST_TEST(message.starts_with("the formula '" + std::string(wrong) + "': "), message);
  }
}

BOOST_AUTO_TEST_CASE(a_term_that_the_formula_does_not_have_and_what_is_not_finite_are_refused) {
  BOOST_TEST(message_of<std::invalid_argument>([] {
               evaluated("a/b a", {{"a", 2}, {"b", 3}});
             }) == "the formula 'a/b a': «a/b c» may be read in two ways: a/(b c), or a/b·c");
  BOOST_TEST(message_of<std::invalid_argument>([] {
               evaluated("a+z", {{"a", 2}});
             }) == "the formula 'a+z': no number is given for 'z'");
  BOOST_TEST(message_of<std::invalid_argument>([] {
               evaluated("a + ζ²·(a + 1)", {{"a", 2}});
             }).ends_with(": no number is given for 'ζ'"));
  BOOST_TEST(message_of<std::invalid_argument>([] {
               evaluated("a + ·a", {{"a", 2}});
             }).ends_with(": a number, a term or a parenthesis is missing"));
  BOOST_TEST(message_of<std::invalid_argument>([] {
               (void)evaluated("a", {{"a", 2}, {"c", 1}});
             }) == "the formula 'a': a number is given for 'c', which it does not have");
  BOOST_CHECK_THROW(evaluated("1/a", {{"a", 0}}), std::invalid_argument);
  BOOST_CHECK_THROW(evaluated("ln(a)", {{"a", -1}}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
