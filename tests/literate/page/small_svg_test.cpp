// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/small_svg.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

BOOST_AUTO_TEST_SUITE(small_svg_test)

using literate::small_svg;

BOOST_AUTO_TEST_CASE(a_path_is_rounded_to_hundredths_and_ends_with_what_it_draws) {
  BOOST_TEST(small_svg("<?xml version=\"1.0\"?>\n<svg>\n<path d=\"M 1.236 -2.004 L 3.500001 400 C "
                       "1 2 3 4 -0.001 1e1 Z M 1.236 -2 \"/>\n</svg>\n") ==
             "<svg><path d=\"M1.24-2L3.5 400C1 2 3 4 0 10Z\"/></svg>");
}

BOOST_AUTO_TEST_CASE(a_path_that_is_drawn_larger_has_more_decimals) {
  BOOST_TEST(small_svg("<path d=\"M 0.12345 1 L 2 3 \" "
                       "transform=\"matrix(100,0,0,-99.99999999,0,0.00001234)\"/>") ==
             "<path d=\"M0.1235 1L2 3\" transform=\"matrix(100,0,0,-100,0,1.234e-05)\"/>");
}

BOOST_AUTO_TEST_CASE(a_small_factor_of_a_matrix_keeps_its_digits) {
  BOOST_TEST(small_svg("<g transform=\"matrix(0.00123456789,0,0,1,0,0)\"></g>") ==
             "<g transform=\"matrix(0.00123457,0,0,1,0,0)\"></g>");
}

BOOST_AUTO_TEST_CASE(colours_are_short_and_what_holds_anyhow_is_not_said) {
  BOOST_TEST(
      small_svg(
          "<path style=\"fill:none;stroke-width:0.2;stroke-linecap:butt;stroke:rgb(100%,0%,20%);"
          "stroke-opacity:1;\" d=\"M 0 0\"/>") ==
      "<path style=\"fill:none;stroke-width:0.2;stroke:#f03\" d=\"\"/>");
  BOOST_TEST(small_svg("<path style=\"stroke:rgb(10.588074%,10.588074%,22.744751%);\"/>") ==
             "<path style=\"stroke:#1b1b3a\"/>");
}

BOOST_AUTO_TEST_CASE(what_a_group_sets_is_set_back_within_it) {
  BOOST_TEST(
      small_svg(
          "<g style=\"fill-opacity:0.5\"><path style=\"fill-opacity:1;stroke-opacity:1\"/></g>") ==
      "<g style=\"fill-opacity:0.5\"><path style=\"fill-opacity:1\"/></g>");
}

BOOST_AUTO_TEST_CASE(paths_of_one_look_that_follow_each_other_are_in_one_group) {
  const std::string red = "<path style=\"stroke:#f00\" d=\"M 0 0 L 1 1 \"/>\n";
  const std::string blue = "<path style=\"stroke:#00f\" d=\"M 0 0 L 2 2 \"/>\n";

  BOOST_TEST(
      small_svg(red + red + blue + red) ==
      "<g style=\"stroke:#f00\"><path d=\"M0 0L1 1\"/><path d=\"M0 0L1 1\"/></g>"
      "<path style=\"stroke:#00f\" d=\"M0 0L2 2\"/><path style=\"stroke:#f00\" d=\"M0 0L1 1\"/>");
}

BOOST_AUTO_TEST_CASE(groups_of_one_look_that_follow_each_other_are_one) {
  BOOST_TEST(
      small_svg("<g style=\"fill:#f00;\">\n  <use xlink:href=\"#a\" x=\"1.234\" y=\"2\"/>\n</g>\n"
                "<g style=\"fill:#f00;\">\n  <use xlink:href=\"#b\" x=\"3\" y=\"4\"/>\n</g>\n"
                "<g style=\"fill:#00f;\"/>") ==
      "<g style=\"fill:#f00\"><use href=\"#a\" x=\"1.23\" y=\"2\"/><use href=\"#b\" x=\"3\" "
      "y=\"4\"/></g>"
      "<g style=\"fill:#00f\"/>");
}

BOOST_AUTO_TEST_CASE(transparent_and_clipped_things_are_not_put_together) {
  const std::string clear = "<path style=\"opacity:0.5\" d=\"M0 0\"/>";
  const std::string clipped = "<g clip-path=\"url(#a)\"><use/></g>";

  BOOST_TEST(small_svg(clear + clear) ==
             "<path style=\"opacity:0.5\" d=\"\"/><path style=\"opacity:0.5\" d=\"\"/>");
  BOOST_TEST(small_svg(clipped + clipped) == clipped + clipped);
}

BOOST_AUTO_TEST_CASE(pictures_and_words_stay_as_they_are) {
  const std::string picture = "<image x=\"0\" href=\"data:image/png;base64,0.12345+/=\"/>";

  BOOST_TEST(small_svg(picture + "<text>1.23456 m</text>") == picture + "<text>1.23456 m</text>");
}

BOOST_AUTO_TEST_SUITE_END()
