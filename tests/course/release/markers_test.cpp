// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/markers.hpp"
#include "message_of.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(markers_test)

using course::apply_markers;

namespace {

void check_error(const std::string& text, const std::string& expected,
                 const std::string& file = "a b.cpp") {
  const std::string what = message_of<sys::SourceError>([&] { apply_markers(text, file); });
  BOOST_TEST(what.starts_with(file + ":" + expected), what);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_solution_becomes_its_stub_with_the_regions_indentation) {
  const auto marked = apply_markers(
      "double f() {\n"
      "  // BEGIN SOLUTION\n"
      "  // STUB: if (true) {\n"
      "  // STUB:   return 0;\n"
      "  // STUB: }\n"
      "  return 42;\n"
      "  // END SOLUTION\n"
      "}\n",
      "f.cpp");

  BOOST_TEST(marked.handout ==
             "double f() {\n"
             "  // YOUR SOLUTION HERE\n"
             "  if (true) {\n"
             "    return 0;\n"
             "  }\n"
             "}\n");
  BOOST_TEST(marked.solution == "double f() {\n  return 42;\n}\n");
}

BOOST_AUTO_TEST_CASE(a_solution_without_stub_leaves_the_comment) {
  const auto marked = apply_markers("# BEGIN SOLUTION\nx = 1\n# END SOLUTION\n", "CMakeLists.txt");

  BOOST_TEST(marked.handout == "# YOUR SOLUTION HERE\n");
  BOOST_TEST(marked.solution == "x = 1\n");
}

BOOST_AUTO_TEST_CASE(each_kind_of_file_has_its_comments) {
  BOOST_TEST(apply_markers("%% BEGIN SOLUTION\nx\n% END SOLUTION\n", "r.tex").handout ==
             "% YOUR SOLUTION HERE\n");
  BOOST_TEST(apply_markers("### BEGIN SOLUTION\nx\n#END SOLUTION\n", "f.gp").handout ==
             "# YOUR SOLUTION HERE\n");
  BOOST_TEST(apply_markers("<!-- BEGIN SOLUTION -->\n<!-- STUB: *Write.* -->\nx\n"
                           "<!--END SOLUTION-->\n",
                           "README.md")
                 .handout == "<!-- YOUR SOLUTION HERE -->\n*Write.*\n");
}

BOOST_AUTO_TEST_CASE(hidden_tests_vanish_and_their_names_are_known) {
  const auto marked = apply_markers(
      "a\n// BEGIN HIDDEN TESTS: second kind\nb\n\n// END HIDDEN TESTS\nc\n"
      "// BEGIN HIDDEN TESTS\nd\n// END HIDDEN TESTS\n",
      "t.cpp");

  BOOST_TEST(marked.handout == "a\nc\n");
  BOOST_TEST(marked.solution == "a\nb\n\nc\nd\n");
  BOOST_REQUIRE(marked.hidden_regions.size() == 1);
  BOOST_TEST(marked.hidden_regions[0] == "second kind");
  BOOST_REQUIRE(marked.secrets.size() == 2);
  BOOST_TEST(marked.secrets[0].text == "b");
  BOOST_TEST(marked.secrets[0].line == 3);
  BOOST_TEST(marked.secrets[0].region == 2);
}

BOOST_AUTO_TEST_CASE(line_ends_tabs_and_a_last_line_without_end_are_kept) {
  const std::string text =
      "a\r\n\t// BEGIN SOLUTION\r\n\t// STUB: return 0;\r\n\treturn 1;\r\n\t// END SOLUTION\r\nb";

  BOOST_TEST(apply_markers(text, "f.cpp").handout ==
             "a\r\n\t// YOUR SOLUTION HERE\r\n\treturn 0;\r\nb");
  BOOST_TEST(apply_markers(text, "f.cpp").solution == "a\r\n\treturn 1;\r\nb");
  BOOST_TEST(apply_markers("# BEGIN SOLUTION\nx\n# END SOLUTION", "f.sh").handout ==
             "# YOUR SOLUTION HERE");
  BOOST_TEST(apply_markers("a\n# BEGIN HIDDEN TESTS\nx\n# END HIDDEN TESTS", "f.sh").handout ==
             "a\n");
}

BOOST_AUTO_TEST_CASE(a_text_without_markers_is_as_it_was) {
  for (const std::string text : {"", "\n", "a", "a\r\nb\n", "the solution begins here\n"}) {
    BOOST_TEST(apply_markers(text, "f.cpp").handout == text);
    BOOST_TEST(apply_markers(text, "f.cpp").solution == text);
  }
}

BOOST_AUTO_TEST_CASE(regions_do_not_nest) {
  check_error("// BEGIN SOLUTION\n// BEGIN SOLUTION\n", "2: BEGIN SOLUTION inside the BEGIN");
  check_error("// BEGIN HIDDEN TESTS\n// BEGIN SOLUTION\n",
              "2: BEGIN SOLUTION inside the BEGIN HIDDEN TESTS of line 1");
}

BOOST_AUTO_TEST_CASE(a_region_needs_both_its_ends) {
  check_error("a\n// BEGIN SOLUTION\nx\n", "2: BEGIN SOLUTION has no END");
  check_error("a\n// END SOLUTION\n", "2: this END has no BEGIN SOLUTION before it");
  check_error("// BEGIN SOLUTION\n// END HIDDEN TESTS\n",
              "2: this END has no BEGIN HIDDEN TESTS before it");
}

BOOST_AUTO_TEST_CASE(a_stub_stands_below_begin_solution_and_nowhere_else) {
  check_error("// STUB: return 0;\n", "1: STUB may only stand below");
  check_error("// BEGIN SOLUTION\nx\n// STUB: y\n// END SOLUTION\n",
              "3: STUB may only stand below");
  check_error("// BEGIN HIDDEN TESTS\n// STUB: y\n", "2: STUB may only stand below");
}

BOOST_AUTO_TEST_CASE(a_misspelt_marker_gives_no_solution_away) {
  for (const std::string slip :
       {"// begin solution", "// BEGIN SOLUTIONS", "//BEGIN  SOLUTION", "# BEGIN SOLUTION",
        "x = 1; // BEGIN SOLUTION", "// BEGIN HIDDEN TEST", "// BEGIN-SOLUTION",
        "// BEGIN SOLUTION: Heron", "/* END SOLUTION */", "// END HIDDEN_TESTS"}) {
    check_error("\n" + slip + "\n", "2: a marker is a line");
  }
}

BOOST_AUTO_TEST_SUITE_END()
