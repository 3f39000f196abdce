// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/printed_number.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(printed_number_test)

using parameters::PrintedNumber;

BOOST_AUTO_TEST_CASE(digits_and_last_place_are_counted_as_printed) {
  const PrintedNumber matlab("1.6236048e-006");
  BOOST_TEST(matlab.n_digits() == 8);
  BOOST_TEST(matlab.value() == 1.6236048e-6);
  BOOST_TEST(matlab.last_place() == 1e-13, boost::test_tools::tolerance(1e-12));

  const PrintedNumber sheet("0.050");
  BOOST_TEST(sheet.n_digits() == 2);
  BOOST_TEST(sheet.last_place() == 1e-3, boost::test_tools::tolerance(1e-12));

  BOOST_TEST(PrintedNumber("0.000").n_digits() == 1);
  BOOST_TEST(PrintedNumber("-1.600000E+01").value() == -16);
  BOOST_TEST(PrintedNumber("37").last_place() == 1);
}

BOOST_AUTO_TEST_CASE(a_printed_number_agrees_with_every_number_that_rounds_to_it) {
  const PrintedNumber printed("2.6");

  BOOST_TEST(printed.agrees_with(2.5501));
  BOOST_TEST(printed.agrees_with(2.6499));
  BOOST_TEST(!printed.agrees_with(2.5499));
  BOOST_TEST(!printed.agrees_with(2.6501));
  BOOST_TEST(!printed.agrees_with(-2.6));
}

BOOST_AUTO_TEST_CASE(agreement_counts_across_a_carry) {
  BOOST_TEST(PrintedNumber("9.996").agrees_with(9.99601));
  BOOST_TEST(PrintedNumber("10.00").agrees_with(9.9996));
}

BOOST_AUTO_TEST_CASE(texts_that_are_not_decimal_numbers_are_rejected) {
  for (const char* text : {"", "abc", "1.2.3", "1e", "0x10", "inf", " 1", "1,5"}) {
    BOOST_CHECK_THROW(PrintedNumber{text}, std::invalid_argument);
  }
}

BOOST_AUTO_TEST_SUITE_END()
