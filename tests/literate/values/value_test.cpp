// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/value.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <random>
#include <stdexcept>
#include <string>

#include "literate/tables/cell.hpp"
#include "message_of.hpp"

BOOST_AUTO_TEST_SUITE(value_test)

using literate::exact;
using literate::fixed;
using literate::Format;
using literate::integer;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::supported;
using literate::uncertain;
using literate::Value;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A locale with a decimal comma and grouped digits that needs no installed language.
struct CommaLocale : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

std::string estimated(double value, double abs_error, int max_digits = 12) {
  return Value({value, abs_error}, supported(max_digits)).printed();
}

}  // namespace

BOOST_AUTO_TEST_CASE(rounding_up_to_a_new_digit_keeps_the_decimals) {
  BOOST_TEST(Value(9.996, fixed(2)).printed() == "10.00");
  BOOST_TEST(Value(9.996, significant(3)).printed() == "10.0");
  BOOST_TEST(Value(9.996e-5, scientific(3)).printed() == "1.00e-4");
  BOOST_TEST(estimated(9.996, 0.004) == "10.00");
  BOOST_TEST(Value(999999.7, significant(6)).printed() == "1.00000e6");
}

BOOST_AUTO_TEST_CASE(a_whole_number_that_no_double_holds_is_refused) {
  const std::string refused = message_of<std::invalid_argument>(
      [] { Value(11400714819323198485ULL, integer()).require_finite(); });
  BOOST_TEST(refused ==
             "11400714819323198485 is beyond 2^53, where a number does not hold each integer: "
             "Value::text(\"11400714819323198485\") prints it");
  BOOST_CHECK_THROW(Value((1LL << 53) + 1, exact()).latex(), std::invalid_argument);
  BOOST_CHECK_THROW(Value(-(1LL << 53) - 1, integer()).printed(), std::invalid_argument);
  BOOST_TEST(Value((1LL << 53) - 1, integer()).printed() == "9007199254740991");
  BOOST_TEST(Value(1 - (1LL << 53), integer()).printed() == "-9007199254740991");
  // 2^53 itself is what 2^53 + 1 becomes in a double, and so is any greater one of some integer.
  BOOST_CHECK_THROW(Value(1LL << 53, integer()).printed(), std::invalid_argument);
  BOOST_CHECK_THROW(Value(static_cast<double>((1LL << 53) + 1), integer()).printed(),
                    std::invalid_argument);
  BOOST_CHECK_THROW(Value(-1.8e19, integer()).printed(), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(rounding_goes_by_the_exact_binary_value) {
  BOOST_TEST(Value(1.005, fixed(2)).printed() == "1.00");  // 1.00499999999999989…
  BOOST_TEST(Value(0.125, fixed(2)).printed() == "0.12");  // an exact tie goes to even
  BOOST_TEST(Value(0.375, fixed(2)).printed() == "0.38");
  BOOST_TEST(Value(2.5, fixed(0)).printed() == "2");
  BOOST_TEST(Value(0.1, fixed(20)).printed() == "0.10000000000000000555");
}

BOOST_AUTO_TEST_CASE(a_number_that_rounds_to_zero_has_no_sign) {
  BOOST_TEST(Value(-0.0, fixed(2)).printed() == "0.00");
  BOOST_TEST(Value({-0.004, 0.01}, fixed(2)).printed() == "0.00");
  BOOST_TEST(Value(-0.0, significant(3)).printed() == "0");
  BOOST_TEST(Value(0, scientific(3)).printed() == "0");
  BOOST_TEST(Value(-0.0, exact()).printed() == "0");
  BOOST_TEST(Value(-0.006, fixed(2)).printed() == "-0.01");
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_zero_is_not_printed_as_zero) {
  BOOST_TEST(Value(-0.004, fixed(2)).printed() == "-0.004");
  BOOST_TEST(Value(0.00412345, fixed(2)).printed() == "0.0041");
  BOOST_TEST(Value({3.14159e-4, 1e-9}, fixed(2), "in").printed() == "3.1e-4 in");
  BOOST_TEST(Value({3.14159e-4, 4e-5}, fixed(2)).printed() == "3e-4");
  BOOST_TEST(Value({3.14159e-4, 2e-3}, fixed(2)).printed() == "0.00");
  BOOST_TEST(Value({2.4e-7, 1e-9}, percent(1)).latex() == "\\qty{2.4e-5}{\\percent}");
  BOOST_TEST(Value(0, fixed(2)).printed() == "0.00");
}

BOOST_AUTO_TEST_CASE(a_number_greater_than_its_error_is_not_printed_as_zero) {
  BOOST_TEST(Value({-0.00473, 0.00173}, fixed(2)).printed() == "-0.0047 ± 0.0018");
  BOOST_TEST(Value({-0.00473, 0.00173}, significant(3)).printed() == "-0.0047 ± 0.0018");
  BOOST_TEST(Value({4.73e-12, 1.73e-12}, scientific(1), "in").printed() == "(4.7 ± 1.8)e-12 in");
  BOOST_TEST(Value({-4.73e-5, 1.73e-5}, percent(2)).printed() == "(-0.0047 ± 0.0018) %");
  BOOST_TEST(estimated(-0.00473, 0.00173) == "-0.0047 ± 0.0018");
  BOOST_TEST(Value({-0.00173, 0.00473}, fixed(2)).printed() == "0.00");
}

// A bound says all with «0»; a standard uncertainty is none, and a reader wants it.
BOOST_AUTO_TEST_CASE(a_standard_uncertainty_stands_behind_a_number_that_it_exceeds) {
  const auto scattered = [](double value, double u) {
    return numerics::Measured(value, u, "scatter");
  };
  BOOST_TEST(Value(scattered(-0.6356, 1.5532), significant(2)).printed() == "-0.6(16)");
  BOOST_TEST(Value(scattered(-0.6356, 1.5532), fixed(2)).printed() == "-0.6(16)");
  BOOST_TEST(Value(scattered(0, 0.25), fixed(2), "m").printed() == "0.00(25) m");
}

BOOST_AUTO_TEST_CASE(an_exact_zero_has_no_power_of_ten) {
  BOOST_TEST(Value(0, scientific(2).in_percent()).printed() == "0 %");
  BOOST_TEST(Value(0, scientific(2).rounded_up().in_percent()).latex() == "\\qty{0}{\\percent}");
  BOOST_TEST(Value({0, 0}, significant(3).in_percent()).printed() == "0 %");
  BOOST_TEST(Value(0, exact().in_percent()).printed() == "0 %");
  BOOST_TEST(Value(0, percent(1)).printed() == "0.0 %");
  BOOST_TEST(Value({0, 0}, supported()).printed() == "0");
}

BOOST_AUTO_TEST_CASE(what_a_format_cannot_say_of_a_number_is_refused) {
  using std::invalid_argument;
  BOOST_CHECK_THROW(Value(2.5, integer()), invalid_argument);
  BOOST_CHECK_THROW(Value({2, 0.5}, integer()), invalid_argument);
  BOOST_CHECK_THROW(Value({2.5, 0.5}, exact()), invalid_argument);
  BOOST_CHECK_THROW(Value(2.5, supported()), invalid_argument);
  BOOST_CHECK_THROW(Value(2.5, uncertain()), invalid_argument);
  BOOST_CHECK_THROW(Value({2.5, 0.5}, supported().rounded_up()), invalid_argument);
  BOOST_CHECK_THROW(Value(0.5, percent(1), "in"), invalid_argument);
  BOOST_CHECK_THROW(significant(101), invalid_argument);
  BOOST_CHECK_THROW(scientific(0), invalid_argument);
  BOOST_CHECK_THROW(supported(0), invalid_argument);
}

BOOST_AUTO_TEST_CASE(any_format_can_be_in_percent) {
  BOOST_TEST(Value(0.123456, significant(3).in_percent()).printed() == "12.3 %");
  BOOST_TEST(Value({0.123456, 2e-3}, significant(3).in_percent()).printed() == "12 %");
  BOOST_TEST(Value({0.123456, 2e-3}, uncertain().in_percent()).printed() == "(12.35 ± 0.21) %");
  BOOST_TEST(Value({0.4, 0.6}, percent(0)).printed() == "(40 ± 60) %");
  BOOST_TEST(Value({0.12, 0.34}, significant(2).in_percent()).printed() == "(12 ± 34) %");
  BOOST_TEST(Value({0.004, 0.006}, percent(0)).printed() == "0 %");
  BOOST_TEST(Value(1, exact().in_percent()).printed() == "100 %");
  BOOST_TEST(Value(0.0125, exact().in_percent()).printed() == "1.25 %");
}

BOOST_AUTO_TEST_CASE(significant_digits_are_plain_between_a_thousandth_and_a_million) {
  BOOST_TEST(Value(0.00123456, significant(3)).printed() == "0.00123");
  BOOST_TEST(Value(0.000123456, significant(3)).printed() == "1.23e-4");
  BOOST_TEST(Value(-45478.2, significant(3)).printed() == "-45500");
  BOOST_TEST(Value(1234567.0, significant(3)).printed() == "1.23e6");
  BOOST_TEST(Value(0.5, significant(4)).printed() == "0.5000");
}

BOOST_AUTO_TEST_CASE(an_estimate_prints_the_digits_its_error_supports) {
  BOOST_TEST(estimated(1.6236054e-6, 3e-10) == "1.624e-6");
  BOOST_TEST(estimated(2.3851, 0.5e-2) == "2.39");
  BOOST_TEST(estimated(2.3851, 0.6e-2) == "2.4");
  BOOST_TEST(estimated(-123456, 400) == "-1.23e5");
  BOOST_TEST(estimated(0.0001, 0.004) == "0.00");
  BOOST_TEST(estimated(1e-18, 1e-16) == "0e-15");
  BOOST_TEST(estimated(7, 40) == "7 ± 40");
  BOOST_TEST(estimated(70, 40) == "1e2");
  BOOST_TEST(estimated(1.0 / 3, 1e-16) == "0.333333333333");
  BOOST_TEST(estimated(1.0 / 3, 1e-16, 4) == "0.3333");
  BOOST_TEST(estimated(2.5, 0) == "2.5");
  BOOST_TEST(estimated(0.1 + 0.2, 0) == "0.300000000000");
  BOOST_TEST(Value({2.5, 0.125}, supported()).uncertainty()->bound == 0.125);
}

BOOST_AUTO_TEST_CASE(exact_numbers_print_the_fewest_digits) {
  BOOST_TEST(Value(30e6, exact(), "psi").latex() == "\\qty{3e7}{psi}");
  BOOST_TEST(Value(0.3, exact()).latex() == "\\num{0.3}");
  BOOST_TEST(Value(-1234.5, exact(), "lbf/in").latex() == "\\qty{-1234.5}{lbf/in}");
  BOOST_TEST(Value(2.5e-4, exact()).printed() == "2.5e-4");
}

BOOST_AUTO_TEST_CASE(percent_moves_the_point_and_rounds_once) {
  BOOST_TEST(Value(0.125, percent(1)).latex() == "\\qty{12.5}{\\percent}");
  BOOST_TEST(Value(0.00125, percent(1)).printed() ==
             "0.1 %");  // 0.00125000000000000002…: not a tie
  BOOST_TEST(Value(-1.5, percent(0)).printed() == "-150 %");
  BOOST_TEST(*Value(0.07, percent(0)).number() == 0.07);
}

BOOST_AUTO_TEST_CASE(integers_and_text) {
  BOOST_TEST(Value(-12000, integer(), "in").latex() == "\\qty{-12000}{in}");
  BOOST_TEST(Value::text("50 % of a_1 ≤ ν").latex() ==
             "50 \\% of a\\_1 \\ensuremath{\\leq} \\ensuremath{\\nu}");
  BOOST_TEST(!Value::text("x").number());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_printed_is_refused) {
  using std::invalid_argument;
  for (const double bad : {not_a_number, infinity, -infinity}) {
    // What registers the value says under which key, so it refuses only to be printed.
    for (const Value& value :
         {Value(bad, fixed(2)), Value(bad, significant(2)).within(0.1), Value(bad, scientific(2)),
          Value(bad, exact()), Value(bad, percent(1)), Value({bad, 1}, supported())}) {
      BOOST_CHECK_THROW(value.printed(), invalid_argument);
      BOOST_CHECK_THROW(value.latex(), invalid_argument);
    }
    BOOST_CHECK_THROW(Value({1, bad}, supported()), invalid_argument);
  }
  BOOST_CHECK_THROW(Value({1, -1}, supported()), invalid_argument);
  BOOST_CHECK_THROW(Value(1, significant(0)), invalid_argument);
  BOOST_CHECK_THROW(Value(1, fixed(-1)), invalid_argument);
  BOOST_CHECK_THROW(Value(1, fixed(1), "#"), invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_unit_is_printed_with_its_signs) {
  BOOST_TEST(Value(3, integer(), "um").latex() == "\\qty{3}{\\micro m}");
  BOOST_TEST(Value(3, integer(), "um").printed() == "3 µm");
  BOOST_TEST(Value(3, integer(), "um").unit() == "um");
  BOOST_TEST(Value(90, integer(), "°").latex() == "\\qty{90}{\\degree }");
  BOOST_TEST(Value(20, integer(), "degC").printed() == "20 °C");
}

BOOST_AUTO_TEST_CASE(a_decimal_comma_in_the_locale_changes_nothing) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaLocale));
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
    BOOST_TEST_MESSAGE("de_DE.UTF-8 is not installed: only the C++ locale is tried");
  }

  const std::string decimals = Value(12345.678, fixed(2)).printed();
  const std::string whole = Value(1234567, integer()).printed();
  const std::string exponent = Value(1.5e-12, scientific(2)).printed();
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);

  BOOST_TEST(decimals == "12345.68");
  BOOST_TEST(whole == "1234567");
  BOOST_TEST(exponent == "1.5e-12");
}

BOOST_AUTO_TEST_CASE(a_bound_is_never_printed_below_its_number) {
  BOOST_TEST(Value(0.0131, percent(0).rounded_up()).printed() == "2 %");
  BOOST_TEST(Value(0.01, percent(0).rounded_up()).printed() == "1 %");
  BOOST_TEST(Value(0.000737, percent(2).rounded_up()).printed() == "0.08 %");
  BOOST_TEST(Value(2.1e-15, scientific(1).rounded_up()).printed() == "3e-15");
  BOOST_TEST(Value(9.3e-7, scientific(1).rounded_up(), "in").printed() == "1e-6 in");
  BOOST_TEST(Value(3e-15, scientific(1).rounded_up()).printed() == "3e-15");
  BOOST_TEST(Value(0, scientific(1).rounded_up()).printed() == "0");
  BOOST_CHECK_THROW(Value(-0.1, percent(1).rounded_up()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_bound_stands_behind_plus_minus_and_is_rounded_up_with_its_number) {
  const auto printed = [](double value, double abs_error) {
    return Value({value, abs_error}, uncertain()).printed();
  };
  BOOST_TEST(printed(0.786151378, 1.11e-7) == "0.78615138 ± 0.00000012");
  BOOST_TEST(printed(-2.3851, 0.5e-2) == "-2.3851 ± 0.0050");
  BOOST_TEST(printed(123456, 400) == "(1.2346 ± 0.0041)e5");
  BOOST_TEST(printed(1.6236054e-6, 3e-10) == "(1.62361 ± 0.00031)e-6");
  BOOST_TEST(printed(0.0001, 0.4) == "0.00 ± 0.41");
  BOOST_TEST(printed(2.5, 0) == "2.5");
  BOOST_TEST(printed(11, 0.1 + 0.05) == "11.00 ± 0.15");  // as a double 0.15000000000000002
  BOOST_TEST(printed(11, 0.1500001) == "11.00 ± 0.16");
  BOOST_TEST(printed(11, 0.1500000000008) == "11.00 ± 0.16");
  BOOST_CHECK_THROW(printed(1, -1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(what_is_printed_always_contains_the_computed_value) {
  // Parsed back, the print is within its own error of the value, for any value and error.
  std::mt19937_64 random(20011);
  std::uniform_real_distribution<double> exponent(-12, 12);
  for (int i = 0; i < 2000; ++i) {
    const double value = (i % 2 == 0 ? 1 : -1) * std::pow(10, exponent(random)) * 2.385;
    const double error = std::abs(value) * std::pow(10, -std::abs(exponent(random)) / 1.2 + 0.5);
    const auto parse = [](const std::string& text) {
      double number = 0;
      std::from_chars(text.data(), text.data() + text.size(), number);
      return number;
    };
    // «(4.7 ± 1.8)e-3» is 4.7e-3 and 1.8e-3; a number alone has no error printed.
    const auto parts = [&](std::string text) {
      const auto e = std::min(text.rfind('e'), text.size());
      const std::string power = text.substr(e);
      text = text.substr(0, e);
      if (text.starts_with('(')) text = text.substr(1, text.size() - 2);
      const std::string sign = " ± ";
      const auto at = text.find(sign);
      const double bound = at == text.npos ? 0 : parse(text.substr(at + sign.size()) + power);
      return numerics::Estimate{parse(text.substr(0, at) + power), bound};
    };
    const double shown = parts(Value({value, error}, supported()).printed()).value;
    BOOST_TEST(std::abs(shown - value) <= std::max(10 * error, 1e-11 * std::abs(value)));

    const numerics::Estimate read = parts(Value({value, error}, uncertain()).printed());
    const double rounding = 1e-15 * std::abs(value);
    BOOST_TEST(read.abs_error + rounding >= (error + std::abs(read.value - value)) * (1 - 1e-12));
    BOOST_TEST(read.abs_error <= 1.17 * error);
  }
}

using literate::Uncertainty;
using numerics::Measured;

BOOST_AUTO_TEST_CASE(
    a_standard_uncertainty_stands_in_parentheses_to_two_digits_rounded_to_nearest) {
  const auto printed = [](double number, double standard, const Format& format = uncertain()) {
    return Value(Measured(number, standard, "reading"), format, "psi").printed();
  };
  // JCGM 100:2008, 7.2.2: a mass of 100.02147 g with u = 0.35 mg is 100.02147(35) g.
  BOOST_TEST(Value(Measured(100.02147, 0.35e-3, "balance"), uncertain(), "g").printed() ==
             "100.02147(35) g");
  BOOST_TEST(printed(993.63, 21.9) == "994(22) psi");
  BOOST_TEST(printed(993.63, 21.4) == "994(21) psi");
  BOOST_TEST(printed(9936.3, 219) == "9.94(22)e3 psi");
  BOOST_TEST(printed(4.73e-5, 0.99e-6) == "4.730(99)e-5 psi");
  BOOST_TEST(printed(993.63, 0) == "993.63 psi");
  BOOST_TEST(Value(Measured(0.1234, 0.0011, "x"), uncertain().in_percent()).printed() ==
             "12.34(11) %");
  BOOST_TEST(Value(Measured(993.63, 21.9, "x"), uncertain(), "psi").latex() ==
             "\\qty{994(22)}{psi}");
}

BOOST_AUTO_TEST_CASE(a_bound_beside_a_standard_uncertainty_is_printed_where_it_can_be_seen) {
  const auto printed = [](double bound) {
    const Value value(Measured(993.63, 21.9, "fit") + Measured::bounded({0, bound}), uncertain(),
                      "psi");
    return value.printed() + " | " + value.latex();
  };
  BOOST_TEST(printed(0.49) == "994(22) psi | \\qty{994(22)}{psi}");
  BOOST_TEST(printed(2.1) ==
             "(994(22) ± 3) psi | \\ensuremath{(\\num{994(22)}\\pm\\num{3})\\,\\unit{psi}}");
  // 5.43249 + 0.003 is 5.43549, which 5.432 ± 0.003 would not hold.
  BOOST_TEST(
      Value(Measured(5.43249, 0.012, "scale") + Measured::bounded({0, 0.003}), uncertain(), "V")
          .printed() == "(5.432(12) ± 0.004) V");
}

BOOST_AUTO_TEST_CASE(a_standard_uncertainty_beside_a_much_greater_bound_adds_no_digits) {
  const auto printed = [](double standard, const Format& format = uncertain()) {
    return Value(Measured(0.802468588, standard, "scale") + Measured::bounded({0, 8.6694e-6}),
                 format)
        .printed();
  };
  BOOST_TEST(printed(1e-6) == "0.8024686(10) ± 0.0000087");
  BOOST_TEST(printed(2e-7) == "0.80246859(20) ± 0.00000868");
  BOOST_TEST(printed(2e-8) == "0.80246859(2) ± 0.00000868");
  BOOST_TEST(printed(2e-9) == "0.8024686 ± 0.0000087");
  BOOST_TEST(printed(5.4e-20) == "0.8024686 ± 0.0000087");
  BOOST_TEST(printed(5.4e-20, uncertain().by_kind()) ==
             "0.80246859 ± 0.00000001 (scale) ± 0.00000868 (at most)");
}

BOOST_AUTO_TEST_CASE(where_the_law_of_propagation_does_not_hold_the_second_order_is_a_bound) {
  // With a second derivative of −1 it is 0.3²/2.
  BOOST_TEST(Value(cos(Measured(0, 0.3, "angle")), uncertain()).printed() == "1.000 ± 0.045");
  const Measured side(10, 1, "rule");
  BOOST_TEST(Value((side - 10.0) * (side - 10.0), uncertain(), "m2").printed() == "(0.0 ± 1.0) m²");
  BOOST_TEST(Value(cos(Measured(0.01, 0.3, "angle")), uncertain()).printed() ==
             "1.0000(30) ± 0.0451");
}

BOOST_AUTO_TEST_CASE(a_source_that_cancels_is_not_told_for_its_rounding) {
  for (int i = 1; i < 40; ++i) {
    const numerics::Measured scale(1, 1e-4 * i, "scale/ruler");
    const numerics::Measured a(0.317 * i, 0.002, "reading/a"), b(0.713, 0.003, "reading/b");
    const Value quotient(scale * a / (scale * b), uncertain());
    BOOST_TEST(quotient.uncertainty()->kinds.size() == 1U, i);
  }
}

BOOST_AUTO_TEST_CASE(kinds_of_uncertainty_are_told_apart_where_this_is_asked_for) {
  const Measured load =
      Measured(993.63, 20.04, "statistics/first") + Measured(0, 8.8, "calibration");
  BOOST_TEST(Value(load, uncertain().by_kind(), "psi").printed() ==
             "(993.6 ± 8.8 (calibration) ± 20.0 (statistics)) psi");
  BOOST_TEST(Value(load + Measured::bounded({0, 0.32}), uncertain().by_kind()).printed() ==
             "993.6 ± 8.8 (calibration) ± 20.0 (statistics) ± 0.4 (at most)");
  BOOST_TEST(Value(1e3 * load, uncertain().by_kind()).latex() ==
             "\\ensuremath{(\\num{9.936}\\pm\\num{0.088}\\text{ (calibration)}"
             "\\pm\\num{0.200}\\text{ (statistics)})\\times\\num{e5}}");
  // What cancels leaves rounding alone, which is no kind.
  const Measured factor = Measured(1.1, 0.02, "calibration");
  const Measured high = factor * Measured(6.2, 0.03, "scatter/1");
  const Measured low = factor * Measured(3.05, 0.01, "scatter/2");
  const std::string told = Value(high / low, uncertain().by_kind()).printed();
  BOOST_TEST(told == "2.033 ± 0.012 (scatter)");
  BOOST_CHECK_THROW(fixed(1).by_kind(), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_bound_to_either_side_stands_behind_plus_and_minus) {
  const auto printed = [](double number, double below, double above) {
    return Value(number, Uncertainty::to_sides(below, above), uncertain(), "psi").printed();
  };
  BOOST_TEST(printed(993.5, 18.2, 21.4) == "(994 +21 −19) psi");  // 975.3 to 1014.9
  BOOST_TEST(printed(9.935e5, 1.82e4, 2.14e4) == "(9.94 +0.21 −0.19)e5 psi");
  BOOST_TEST(printed(12, 0.5, 123) == "(12 +123 −1) psi");
  BOOST_TEST(printed(12, 0, 3) == "(12.0 +3.0 −0.0) psi");
  BOOST_TEST(printed(12, 3, 3) == "(12.0 ± 3.0) psi");
  BOOST_TEST(Value(993.5, Uncertainty::to_sides(18.2, 21.4), uncertain(), "").latex() ==
             "\\ensuremath{\\num{994}^{+\\num{21}}_{-\\num{19}}}");
  BOOST_TEST(Value(993.5, Uncertainty::to_sides(18.2, 21.4), fixed(1), "").printed() == "1.0e3");
  BOOST_CHECK_THROW(Uncertainty::to_sides(-1, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(digits_count_a_standard_uncertainty_with_its_bound) {
  const Measured load = Measured(993.63, 0.6, "fit") + Measured::bounded({0, 0.5});
  BOOST_TEST(Value(load, fixed(2)).printed() == "9.9e2");  // 1.1 needs tens
  BOOST_TEST(Value(Measured(993.63, 0.6, "fit"), fixed(2)).printed() == "994");
  BOOST_TEST(Value(load, supported()).printed() == "9.9e2");
}

BOOST_AUTO_TEST_CASE(a_standard_uncertainty_is_no_bound_to_be_rounded_up) {
  BOOST_CHECK_EXCEPTION(
      Value(Measured(2.5, 0.1, "x"), significant(2).rounded_up()), std::invalid_argument,
      [](const auto& error) {
        return std::string_view(error.what()).starts_with("2.5 has a standard uncertainty of 0.1");
      });
  BOOST_CHECK_THROW(Value(Measured(2.5, 0.1, "x"), exact()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_number_within_an_error_prints_as_an_estimate_does) {
  const auto same = [](double number, const Format& format, double abs_error) {
    const Value bounded = Value(number, format).within(abs_error);
    const Value estimate({number, abs_error}, format);
    BOOST_TEST(bounded.printed() == estimate.printed());
    BOOST_TEST(bounded.latex() == estimate.latex());
    BOOST_TEST(*bounded.number() == number);
    BOOST_TEST(bounded.uncertainty()->bound == abs_error);
  };
  same(2.3851, significant(3), 0.01);
  same(2.3851, significant(3), 0.0101);
  same(123456, significant(4), 101);
  same(2.3851, fixed(0), 1.1);
  same(0.0131, percent(1), 1.1e-3);
  same(0.0131, percent(0).rounded_up(), 1e-2);
  same(2.1e-15, scientific(1).rounded_up(), 1e-15);
  BOOST_TEST(Value(2.3851, fixed(2), "in").within(0.02).printed() == "2.4 in");
}

BOOST_AUTO_TEST_CASE(a_number_as_it_is_prints_as_it_came_and_claims_no_error) {
  const Value residual = Value(2.34e-15, scientific(2), "in").as_is();
  BOOST_TEST(residual.printed() == "2.3e-15 in");
  BOOST_TEST(residual.is_as_is());
  BOOST_TEST(!residual.uncertainty().has_value());
  BOOST_TEST(residual.measured()->bounded().abs_error == 0);
  BOOST_TEST(Value(0.25, exact()).measured()->bounded().abs_error == 0);
  BOOST_TEST(Value(3, integer()).measured()->bounded().abs_error == 0);
  BOOST_TEST(Value({1, 0.1}, fixed(1)).measured()->bounded().abs_error == 0.1);
  BOOST_TEST(!Value(0.25, fixed(2)).measured().has_value());
  BOOST_TEST(!Value::text("none").measured().has_value());
  BOOST_CHECK_NO_THROW(Value::text("none").require_error());
  BOOST_CHECK_THROW(Value(0.25, fixed(2)).require_error(), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(an_error_is_told_once_and_is_none_of_nothing) {
  const auto refused = [](const auto& telling, const std::string& message) {
    BOOST_TEST(message_of<std::invalid_argument>(telling) == message);
  };
  refused([] { Value(2.3851, fixed(2), "in").within(0); },
          "'2.39 in' within 0: print an exact number by exact() or integer(), and say .as_is() of "
          "one that is printed as it came");
  refused([] { Value::text("0.25").within(1); }, "'0.25' is text and can have no error");
  refused([] { Value::text("0.25").as_is(); }, "'0.25' is text and can have no error");
  refused([] { Value({1, 0.1}, fixed(1)).within(1); }, "the error of 1 is told already");
  refused([] { Value({1, 0.1}, fixed(1)).as_is(); }, "the error of 1 is told already");
  refused([] { Value(1, fixed(1)).as_is().within(1); }, "the error of 1 is told already");
  refused([] { Value(0.25, exact()).as_is(); }, "the error of 0.25 is told already");
  refused([] { Value(0.25, exact()).within(0.01); }, "the error of 0.25 is told already");
  for (const double bad : {-1e-9, not_a_number, infinity}) {
    BOOST_CHECK_THROW(Value(1, fixed(2)).within(bad), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(with_an_error_fewer_digits_are_printed_than_allowed_if_it_wants_so) {
  BOOST_TEST(Value({2.3851, 1e-9}, significant(3), "in").printed() == "2.39 in");
  BOOST_TEST(Value({2.3851, 0.02}, significant(3)).printed() == "2.4");
  BOOST_TEST(Value({123456, 400}, significant(6)).printed() == "1.23e5");
  BOOST_TEST(Value({0, 0.02}, significant(2)).printed() == "0.0");
  BOOST_TEST(Value({0, 0}, significant(2)).printed() == "0");
  BOOST_TEST(Value({2.3851, 1e-9}, fixed(3)).printed() == "2.385");
  BOOST_TEST(Value({2.3851, 0.1}, fixed(3)).printed() == "2.4");
  BOOST_TEST(Value({238.51, 40}, fixed(3)).printed() == "2e2");
  BOOST_TEST(Value({2.3851e-7, 0}, scientific(3)).printed() == "2.39e-7");
  BOOST_TEST(Value({3.09e-9, 5.1e-10}, scientific(2), "in").printed() == "3e-9 in");
  BOOST_TEST(Value({0.01314, 1e-4}, percent(2)).printed() == "1.31 %");
  BOOST_TEST(Value({0.01314, 2e-3}, percent(2)).printed() == "1 %");
  BOOST_TEST(Value({1.314, 0.2}, percent(2)).printed() == "1e2 %");
  BOOST_TEST(Value({0.01314, 2e-3}, percent(2)).uncertainty()->bound == 2e-3);
  BOOST_TEST(*Value({0.01314, 2e-3}, percent(2)).number() == 0.01314);
  BOOST_CHECK_THROW(Value({1, -1}, fixed(2)), std::invalid_argument);
  BOOST_CHECK_THROW(Value({1, infinity}, percent(2)), std::invalid_argument);
  BOOST_CHECK_THROW(Value({1, not_a_number}, significant(2)), std::invalid_argument);
  BOOST_CHECK_THROW(Value({1, -1}, scientific(2)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(what_is_not_exceeded_is_not_exceeded_by_number_and_error_together) {
  BOOST_TEST(Value({2.9e-15, 2e-16}, scientific(1).rounded_up(), "in").printed() == "4e-15 in");
  BOOST_TEST(Value({0.000737, 6e-5}, percent(2).rounded_up()).printed() == "0.08 %");
  BOOST_TEST(Value({0.000737, 7e-5}, percent(2).rounded_up()).printed() == "0.09 %");
  BOOST_TEST(Value({0.00885, 5.6e-4}, percent(2).rounded_up()).printed() == "0.95 %");
  BOOST_TEST(Value({3.294e-10, 3e-12}, scientific(3).rounded_up()).printed() == "3.33e-10");
  BOOST_TEST(Value({0, 0}, scientific(3).rounded_up()).printed() == "0");
  BOOST_TEST(*Value({0.000737, 7e-5}, percent(2).rounded_up()).number() == 0.000737);
  BOOST_TEST(Value({2.9e-15, 2e-16}, scientific(1).rounded_up()).uncertainty()->bound == 2e-16);
  BOOST_CHECK_THROW(Value({1, -0.1}, scientific(1).rounded_up()), std::invalid_argument);
  BOOST_CHECK_THROW(Value({-1, 0.1}, scientific(1).rounded_up()), std::invalid_argument);
  BOOST_CHECK_THROW(Value({1, not_a_number}, percent(1).rounded_up()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_bound_is_not_rounded_up_to_a_decade_nor_finer_than_two_digits_of_its_error) {
  BOOST_TEST(Value({3e-15, 3.61e-11}, scientific(2).rounded_up()).printed() == "3.7e-11");
  BOOST_TEST(Value({3e-12, 3e-10}, scientific(3).rounded_up()).printed() == "3.1e-10");
  BOOST_TEST(Value({0.3, 2}, percent(2).rounded_up()).printed() == "2.3e2 %");
  BOOST_TEST(Value({0.000737, 6.05e-5}, percent(6).rounded_up()).printed() == "0.0798 %");
}

BOOST_AUTO_TEST_SUITE_END()
