// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt.hpp"

#include <boost/test/unit_test.hpp>

#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(excerpt_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(the_listing_has_true_line_numbers_and_no_common_indentation) {
  const TemporaryFolder scratch;

  write_excerpt(scratch.path(), {"x", "src/a_b.cpp", 7, "    if (a) {\n\n      b();\n    }\n"});

  BOOST_TEST(sys::read_file(scratch / "x.txt") == "if (a) {\n\n  b();\n}\n");
  BOOST_TEST(sys::read_file(scratch / "x.tex") ==
             "\\LiterateListing{x}{src/\\allowbreak{}a\\_b.cpp}{7}{10}{[20]C++}\n");
}

BOOST_AUTO_TEST_SUITE_END()
