// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line/options.hpp"

#include <bit>
#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <iostream>
#include <limits>
#include <locale>
#include <sstream>

#include "random_inputs.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(options_test)

using command_line::parse_number;
using command_line::parse_numbers;
using command_line::read_numbers;
using command_line::shortest;
using sys::InputError;

namespace {

// The message of the InputError that a call throws.
template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const InputError& e) {
    return e.what();
  }
  return "(accepted)";
}

std::string refusal_of(const std::string& text) {
  return refusal([&] { parse_number("--young", text); });
}

// 1.234.567,5
struct CommaDecimal : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// The locale of the whole program for one test.
class GlobalLocale {
 public:
  explicit GlobalLocale(const std::locale& locale) : before_(std::locale::global(locale)) {}
  GlobalLocale(const GlobalLocale&) = delete;
  GlobalLocale& operator=(const GlobalLocale&) = delete;
  ~GlobalLocale() { std::locale::global(before_); }

 private:
  std::locale before_;
};

// What std::cin reads for one test.
class StandardInput {
 public:
  explicit StandardInput(const std::string& text) : text_(text) {
    before_ = std::cin.rdbuf(text_.rdbuf());
  }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;
  ~StandardInput() {
    std::cin.rdbuf(before_);
    std::cin.clear();
  }

 private:
  std::istringstream text_;
  std::streambuf* before_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_spelling_of_a_number_is_taken) {
  BOOST_TEST(parse_number("--young", "30e6") == 30e6);
  BOOST_TEST(parse_number("--young", "+2.385") == 2.385);
  BOOST_TEST(parse_number("--young", "-2.385E-3") == -2.385e-3);
  BOOST_TEST(parse_number("--young", ".5") == 0.5);
  BOOST_TEST(parse_number("--young", "7.") == 7);
  BOOST_TEST(parse_number("--young", "-0") == 0);
}

BOOST_AUTO_TEST_CASE(a_number_is_rounded_once) {
  // Half way between two doubles, and a little more: the 30th digit decides.
  BOOST_TEST(parse_number("--x", "9007199254740993") == 9007199254740992);
  BOOST_TEST(parse_number("--x", "9007199254740993.00000000000001") == 9007199254740994);
  BOOST_TEST(parse_number("--x", "4.9406564584124654e-324") ==
             std::numeric_limits<double>::denorm_min());
}

BOOST_AUTO_TEST_CASE(what_is_not_wholly_a_number_is_refused_with_flag_and_text) {
  BOOST_TEST(refusal_of("abc") == "--young: \"abc\" is not a number");
  for (const char* text : {"", " ", "+", "-", "--1", "+-1", "1e", "1,5", "1 5", "0x10", "30e6psi",
                           " 1", "1 ", "1.2.3"}) {
    BOOST_TEST(refusal_of(text) == "--young: \"" + std::string(text) + "\" is not a number");
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_finite_is_refused) {
  for (const char* text : {"nan", "inf", "-inf", "infinity", "NaN"}) {
    BOOST_TEST(refusal_of(text) == "--young = " + std::string(text) + ": must be a finite number");
  }
  BOOST_TEST(refusal_of("1e999") == "--young: \"1e999\" is beyond the range of a double");
}

BOOST_AUTO_TEST_CASE(a_comma_decimal_locale_changes_nothing) {
  const GlobalLocale german(std::locale(std::locale::classic(), new CommaDecimal));

  BOOST_TEST(parse_number("--young", "1234567.5") == 1234567.5);
  BOOST_TEST(refusal_of("1234567,5") == "--young: \"1234567,5\" is not a number");
  BOOST_TEST(shortest(1234567.5) == "1234567.5");
  BOOST_TEST((parse_numbers("--x", "0.5,1.5") == std::vector<double>{0.5, 1.5}));
}

BOOST_AUTO_TEST_CASE(a_list_is_split_at_commas_and_may_have_blanks_around_them) {
  BOOST_TEST((parse_numbers("--x", "0,0.005,0.01") == std::vector<double>{0, 0.005, 0.01}));
  BOOST_TEST((parse_numbers("--x", " -1 , 2e3 ") == std::vector<double>{-1.0, 2e3}));
  BOOST_TEST((parse_numbers("--x", "7") == std::vector<double>{7.0}));
}

BOOST_AUTO_TEST_CASE(a_malformed_list_is_refused_with_the_element_that_is_wrong) {
  const auto refused = [](const std::string& text) {
    return refusal([&] { parse_numbers("--x", text); });
  };

  BOOST_TEST(refused("0,,1") == "--x: \"\" is not a number");
  BOOST_TEST(refused("1,abc,2") == "--x: \"abc\" is not a number");
  BOOST_TEST(refused("0,nan") == "--x = nan: must be a finite number");
  for (const char* text : {"1,", ",1", ",", "", "1;2", "1 2"}) {
    BOOST_TEST_CONTEXT(text) {
      BOOST_TEST(refused(text).starts_with("--x"));
      BOOST_TEST(refused(text).find('\n') == std::string::npos);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_file_holds_a_number_a_line_and_may_have_comments) {
  const TemporaryFolder folder;
  const auto file = folder.write("points.txt", "# in\n0\n\n  0.005  \r\n\t-1e-3\n0.01");

  BOOST_TEST((read_numbers(file.string()) == std::vector<double>{0, 0.005, -1e-3, 0.01}));
}

BOOST_AUTO_TEST_CASE(a_wrong_line_is_named_by_file_and_line) {
  const TemporaryFolder folder;
  const std::string file = folder.write("points.txt", "# in\n0\n0,5\n").string();

  BOOST_TEST(refusal([&] { read_numbers(file); }) == file + ":3: \"0,5\" is not a number");
}

BOOST_AUTO_TEST_CASE(a_file_that_is_missing_or_empty_is_refused_by_name) {
  const TemporaryFolder folder;
  const std::string missing = (folder.path() / "none.txt").string();
  const std::string empty = folder.write("empty.txt", "# nothing\n\n").string();

  BOOST_TEST(refusal([&] { read_numbers(missing); }) == missing + ": cannot be read");
  BOOST_TEST(refusal([&] { read_numbers(empty); }) == empty + ": holds no number");
  BOOST_TEST(
      refusal([&] { read_numbers(folder.path().string()); }).starts_with(folder.path().string()));
}

BOOST_AUTO_TEST_CASE(a_dash_reads_standard_input) {
  {
    const StandardInput input("0.5\n# and\n1.5\n");
    BOOST_TEST((read_numbers("-") == std::vector<double>{0.5, 1.5}));
  }
  const StandardInput wrong("0.5\nx\n");
  BOOST_TEST(refusal([] { read_numbers("-"); }) == "<stdin>:2: \"x\" is not a number");
}

BOOST_AUTO_TEST_CASE(any_double_reads_back_from_its_shortest_digits) {
  BOOST_TEST(shortest(0.1) == "0.1");
  BOOST_TEST(shortest(1e23) == "1e+23");
  RandomInputs random(7);
  for (int i = 0; i < 20'000; ++i) {
    const double number = random.sign() * random.log_uniform(1e-150, 1e150);
    const double read_back = parse_number("number", shortest(number));
    BOOST_REQUIRE(std::bit_cast<std::uint64_t>(read_back) == std::bit_cast<std::uint64_t>(number));
  }
}

BOOST_AUTO_TEST_SUITE_END()
