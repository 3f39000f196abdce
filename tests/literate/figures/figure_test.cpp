// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/figure.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "messages.hpp"

using literate::Figure;
using literate::figure_csv;
using literate::FigureData;

BOOST_AUTO_TEST_SUITE(figure_test)

// If a script sets the comma as decimal sign, gnuplot reads 1.25 in the data as 1.
BOOST_AUTO_TEST_CASE(data_have_no_decimal_sign) {
  const std::string text =
      figure_csv({{"x", {0, -1.25, 120, 1e300}}, {"y", {1, 0.1, literate::gap, -2e-7}}});
  BOOST_TEST(text == "x,y\n0,1\n-125e-2,1e-1\n120,NaN\n1e300,-2e-7\n");
}

BOOST_AUTO_TEST_CASE(a_surface_has_a_blank_line_after_each_row_of_its_grid) {
  BOOST_TEST(figure_csv(FigureData({{"z", {1, 2, 3, 4}}}, 2)) == "z\n1\n2\n\n3\n4\n");
}

BOOST_AUTO_TEST_CASE(the_prelude_defines_the_variables_of_the_script) {
  const std::string text = literate::figure_prelude("f", {.width_cm = 8,
                                                          .height_cm = 5.5,
                                                          .data = {{"loads", {{"x", {1}}}}},
                                                          .numbers = {{"E", 3e7}, {"n", 2}},
                                                          .texts = {{"label", "it's $\\nu$"}}});
  for (const char* line :
       {"set decimalsign '.'\n", "set datafile separator comma\n", "width_cm = 8.0\n",
        "height_cm = 5.5\n", "set output 'f.tex'\n", "loads = 'loads.csv'\n", "E = 3e+07\n",
        "n = 2.0\n", "label = 'it''s $\\nu$'\n",
        "set terminal cairolatex pdf size width_cm cm, height_cm cm\n"}) {
    BOOST_TEST(holds(text, line));
  }
}

BOOST_AUTO_TEST_CASE(figures_that_no_script_could_draw_are_refused) {
  const auto refused = [](const Figure& figure) {
    return message_of<std::invalid_argument>([&] { require_drawable(figure); });
  };
  const auto with = [&](const FigureData& data) {
    return refused({.width_cm = 1, .height_cm = 1, .data = {{"d", data}}});
  };
  BOOST_TEST(holds(refused({.width_cm = 0, .height_cm = 1}), "both must be positive"));
  BOOST_TEST(holds(with({}), "data 'd' has no points"));
  BOOST_TEST(holds(with({{"x", {}}}), "data 'd' has no points"));
  BOOST_TEST(holds(with({{"x", {1, 2}}, {"y", {1}}}), "2 points in column 'x' and 1 in 'y'"));
  BOOST_TEST(holds(with({{"x", {1, std::sqrt(-1.0)}}}), "nan as point 2 of column 'x'"));
  BOOST_TEST(holds(with({{"1x", {1}}}), "'1x' cannot be a gnuplot variable"));
  BOOST_TEST(holds(refused({.width_cm = 1, .height_cm = 1, .numbers = {{"a", HUGE_VAL}}}),
                   "the number 'a' is inf"));
}

BOOST_AUTO_TEST_SUITE_END()
