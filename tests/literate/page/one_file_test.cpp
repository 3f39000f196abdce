// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/one_file.hpp"

#include <boost/test/unit_test.hpp>

#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(one_file_test)

using namespace literate;

namespace {

const std::string page =
    "<head><!--lit:style-->\n<!--lit:script-->\n</head><img "
    "src=\"figures/a.svg\"><!--lit:data-->\n";

}  // namespace

BOOST_AUTO_TEST_CASE(bytes_are_written_in_base64) {
  BOOST_TEST(data_address("x/y", "Man") == "data:x/y;base64,TWFu");
  BOOST_TEST(data_address("x/y", "Ma") == "data:x/y;base64,TWE=");
  BOOST_TEST(data_address("x/y", "M") == "data:x/y;base64,TQ==");
}

BOOST_AUTO_TEST_CASE(style_script_data_figures_and_fonts_are_put_in) {
  const TemporaryFolder folder;
  folder.write("look/b.css", "b{}\n");
  folder.write("look/a.css", "a{src:url(\"f.woff2\")}\n");
  folder.write("look/a.js", "run();\n");
  folder.write("build/figures/a.svg", "<svg/>");
  folder.write("build/f.woff2", "M");

  const std::string html =
      one_file(page, {.look = folder / "look", .data = "{}", .build = folder / "build"});

  BOOST_TEST(html ==
             "<head><style>\na{src:url(\"data:font/woff2;base64,TQ==\")}\nb{}\n</"
             "style>\n<script>\nrun();\n"
             "</script>\n</head><img src=\"data:image/svg+xml,<svg/>\"><script "
             "type=\"application/json\" id=\"lit-data\">{}</script>\n");
}

BOOST_AUTO_TEST_CASE(a_drawing_has_no_character_that_an_address_may_not_have) {
  BOOST_TEST(svg_address("<a x=\"1\"\nid=\"#b\">50%</a>") ==
             "data:image/svg+xml,<a x='1' id='%23b'>50%25</a>");
}

BOOST_AUTO_TEST_CASE(a_picture_that_is_missing_is_told) {
  const TemporaryFolder folder;
  folder.write("look/a.css", "");

  BOOST_CHECK_THROW(one_file(page, {.look = folder / "look", .build = folder / "build"}),
                    sys::OutputError);
}

BOOST_AUTO_TEST_SUITE_END()
