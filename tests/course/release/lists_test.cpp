// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/handout.hpp"
#include "message_of.hpp"

#include <boost/test/unit_test.hpp>

#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(lists_test)

namespace {

course::Assignment two_exercises() {
  using course::Visibility;
  course::Assignment assignment;
  assignment.exercises = {
      {.id = "root",
       .title = "A root",
       .file = "src/square_root.cpp",
       .builds_on = {},
       .checks = {{"root-exact", 2, Visibility::visible, "it is exact", ""},
                  {"root-secret", 3, Visibility::hidden, "it is right", ""},
                  {"root-tests", 4, Visibility::tests, "they catch", ""}},
       .tests = "src/tests/root.cpp"},
      {.id = "mean",
       .title = "A mean",
       .file = "src/mean.cpp",
       .builds_on = {},
       .checks = {{"mean-between", 1.5, Visibility::visible, "it lies between", ""}}}};
  return assignment;
}

std::string filled(const std::string& text, const std::string& file) {
  return course::with_lists(two_exercises(), text, file);
}

void require_fault(const std::string& text, const std::string& expected) {
  BOOST_TEST(message_of<sys::SourceError>([&] { filled(text, "main.cpp"); }) == expected);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_list_has_a_line_for_each_exercise_in_their_order) {
  BOOST_TEST(filled("a\n  // EACH EXERCISE: {@number@, \"@title@\", @name@, @id@, @points@},\r\nb",
                    "main.cpp") ==
             "a\n  {1, \"A root\", square_root, root, 9},\r\n"
             "  {2, \"A mean\", mean, mean, 1.5},\r\nb");
}

BOOST_AUTO_TEST_CASE(a_list_of_checks_names_no_hidden_one) {
  BOOST_TEST(filled("// EACH PUBLIC CHECK: @number@ @check@ @points@ @says@\n", "main.cpp") ==
             "1 root-exact 2 it is exact\n2 mean-between 1.5 it lies between\n");
}

BOOST_AUTO_TEST_CASE(a_list_of_own_tests_has_their_files) {
  BOOST_TEST(filled("# EACH OWN TESTS: @number@ @check@ @tests@ @points@\n", "CMakeLists.txt") ==
             "1 root-tests src/tests/root.cpp 4\n");
}

BOOST_AUTO_TEST_CASE(a_list_is_a_comment_of_its_kind_of_file) {
  BOOST_TEST(filled("<!-- EACH EXERCISE: | `@file@` | -->\n", "README.md") ==
             "| `src/square_root.cpp` |\n| `src/mean.cpp` |\n");
  BOOST_TEST(filled("  # EACH EXERCISE: @file@\n", "CMakeLists.txt") ==
             "  src/square_root.cpp\n  src/mean.cpp\n");
  BOOST_TEST(filled("# EACH EXERCISE: @file@\n", "main.cpp") == "# EACH EXERCISE: @file@\n");
}

BOOST_AUTO_TEST_CASE(a_text_without_lists_stays_as_it_is) {
  const std::string text = "// each exercise: one\nmail@somewhere // EACH EXERCISE: x\n";
  BOOST_TEST(filled(text, "main.cpp") == text);
}

BOOST_AUTO_TEST_CASE(a_wrong_list_is_refused_with_its_line) {
  require_fault("\n// EACH EXERCISE: @nmae@\n",
                "main.cpp:2: @nmae@ is not known in a list of «EACH EXERCISE:»");
  require_fault("// EACH EXERCISE: @check@\n",
                "main.cpp:1: @check@ is not known in a list of «EACH EXERCISE:»");
  require_fault("// EACH EXERCISE: a@b\n",
                "main.cpp:1: @b@ is not known in a list of «EACH EXERCISE:»");
  require_fault("// EACH EXERCISES: x\n",
                "main.cpp:1: a list is of «EACH EXERCISE:», «EACH PUBLIC CHECK:» or «EACH OWN "
                "TESTS:», not of «EACH "
                "EXERCISES:»");
}

BOOST_AUTO_TEST_SUITE_END()
