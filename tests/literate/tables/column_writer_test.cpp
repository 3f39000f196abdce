// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/column_writer.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(column_writer_test)

using literate::aligned_number;
using literate::NumberWidth;
using literate::widest;
using literate::width_of;

namespace {

NumberWidth of_all(const std::vector<std::string>& numbers) {
  NumberWidth width = width_of(numbers.front());
  for (const std::string& number : numbers) width = widest(width, width_of(number));
  return width;
}

// Digits, blanks for digits, separators and the rest, counted: what makes a cell as wide as it is.
std::string without_blanks(std::string text) {
  for (const std::string blank : {"\\hphantom{", "}"}) {
    for (auto at = text.find(blank); at != text.npos; at = text.find(blank)) {
      text.erase(at, blank.size());
    }
  }
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(thin_spaces_group_from_five_digits_on_away_from_the_point) {
  const auto alone = [](const std::string& number) {
    return aligned_number(number, width_of(number));
  };
  BOOST_TEST(alone("1234.5678") == "1234.5678");
  BOOST_TEST(alone("12345.67891") == "12\\,345.678\\,91");
  BOOST_TEST(alone("-1234567e-10") == "{-}1\\,234\\,567\\times10^{-10}");
}

BOOST_AUTO_TEST_CASE(cells_of_a_column_are_equally_wide) {
  const std::vector<std::string> numbers{"0.5",       "-12.25",      "1234567.1",     "3",
                                         "-8.125e-7", "4.0000001e3", "99999.99999e12"};
  const NumberWidth column = of_all(numbers);
  for (const std::string& number : numbers) {
    const std::string text = without_blanks(aligned_number(number, column));
    BOOST_TEST_CONTEXT(number << " as " << text) {
      const auto count = [&text](const std::string& characters) {
        return std::count_if(text.begin(), text.end(),
                             [&](char c) { return characters.find(c) != std::string::npos; });
      };
      BOOST_TEST(count("0123456789") == 7 + 7 + 2 + 2);
      BOOST_TEST(count(",") == 2 + 2);
      BOOST_TEST(count(".") == 1);
      BOOST_TEST(count("-") == 2);
      BOOST_TEST(count("^") == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_sign_behind_a_blank_is_no_operator) {
  BOOST_TEST(aligned_number("-9", of_all({"-9", "-37"})) == "\\hphantom{0}{-}9");
  BOOST_TEST(aligned_number("9", of_all({"-9", "-37"})) == "\\hphantom{0}\\hphantom{-}9");
}

BOOST_AUTO_TEST_CASE(a_power_of_ten_follows_its_digits_and_leaves_no_hole) {
  const NumberWidth column = of_all({"3.88e-5", "1e-10"});
  BOOST_TEST(aligned_number("1e-10", column) == "1\\times10^{-10}\\hphantom{.}\\hphantom{00}");
  BOOST_TEST(aligned_number("3.88e-5", column) == "3.88\\times10^{-5\\hphantom{0}}");
}

BOOST_AUTO_TEST_CASE(a_mark_stands_beside_the_last_digit_and_not_behind_the_blanks) {
  const auto marked = [](const std::string& number, const std::vector<std::string>& others) {
    std::vector<std::string> all = others;
    all.push_back(number);
    return aligned_number(number, of_all(all), "*");
  };
  BOOST_TEST(marked("1.5", {"1.2345"}) == "1.5*\\hphantom{000}");
  BOOST_TEST(marked("3", {"1.25"}) == "3*\\hphantom{.}\\hphantom{00}");
  BOOST_TEST(marked("0.12(34)", {"1.2345"}) == "0.12(34)*\\hphantom{00}");
  BOOST_TEST(marked("1.5e-6", {"2.5e-12"}) == "1.5\\times10^{-6\\hphantom{0}}*");
  BOOST_TEST(marked("7", {"2.5e-12"}).starts_with("7*\\hphantom{"));
}

BOOST_AUTO_TEST_SUITE_END()
