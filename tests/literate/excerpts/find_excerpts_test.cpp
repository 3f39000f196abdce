// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/find_excerpts.hpp"

#include <boost/test/unit_test.hpp>

#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(find_excerpts_test)

using namespace literate;

namespace {

std::string error_in(const std::string& text) {
  return message_of<sys::SourceError>([&] { excerpts_of(text, "a.cpp"); });
}

// The markers are put together here so that they are none of this file's own.
const std::string begin = "// begin excerpt: ";
const std::string end = "// end excerpt: ";

}  // namespace

BOOST_AUTO_TEST_CASE(an_excerpt_knows_its_true_lines) {
  const auto found =
      excerpts_of("x\n  " + begin + "one\n\n  a\n\n  b\n\n" + end + "one\ny\n", "a.cpp");

  BOOST_REQUIRE(found.size() == 1U);
  BOOST_TEST(found[0].name == "one");
  BOOST_TEST(found[0].text == "  a\n\n  b\n");
  BOOST_TEST(found[0].first_line == 4);
  BOOST_TEST(last_line(found[0]) == 6);
}

BOOST_AUTO_TEST_CASE(hash_and_percent_lead_markers_too) {
  const auto found = excerpts_of(
      "# begin excerpt: h\na\n# end excerpt: h\r\n% begin excerpt: p\r\nb\r\n% end excerpt: p",
      "f");

  BOOST_REQUIRE(found.size() == 2U);
  BOOST_TEST(found[1].text == "b\n");
}

BOOST_AUTO_TEST_CASE(a_broken_marker_is_an_error_with_its_line) {
  BOOST_TEST(error_in("\n" + begin + "x\na\n") == "a.cpp:2: excerpt 'x' has no end marker");
  BOOST_TEST(error_in(end + "x\n") == "a.cpp:1: excerpt 'x' ends but has no begin marker");
  BOOST_TEST(error_in(begin + "x\n \n" + end + "x\n") == "a.cpp:1: excerpt 'x' is empty");
  BOOST_TEST(error_in(begin + "x\na\n" + begin + "y\n") ==
             "a.cpp:3: excerpt 'y' begins inside 'x' of line 1");
  BOOST_TEST(error_in(begin + "x\na\n" + end + "y\n") ==
             "a.cpp:3: excerpt 'y' ends inside 'x' of line 1");
  BOOST_TEST(error_in(begin + "\n").starts_with("a.cpp:1: a marker reads 'begin excerpt: name'"));
  BOOST_TEST(error_in("// begin excerpt x\n").starts_with("a.cpp:1: a marker reads"));
}

BOOST_AUTO_TEST_CASE(a_doubled_marker_is_an_error_with_both_lines) {
  const std::string once = begin + "x\na\n" + end + "x\n";

  BOOST_TEST(error_in(once + once) == "a.cpp:4: excerpt 'x' is marked at a.cpp:1 already");
}

BOOST_AUTO_TEST_CASE(a_name_in_two_files_is_an_error_with_both_files) {
  const TemporaryFolder scratch;
  const std::string once = begin + "x\na\n" + end + "x\n";
  sys::write_file_atomically(scratch / "src/a.cpp", once);
  sys::write_file_atomically(scratch / "src/b.hpp", "\n" + once);
  sys::write_file_atomically(scratch / "src/c.txt", once);

  BOOST_TEST(message_of<sys::SourceError>([&] { find_excerpts(scratch.path(), {"src"}); }) ==
             "src/b.hpp:2: excerpt 'x' is marked at src/a.cpp:1 already");
  BOOST_TEST(message_of<sys::SourceError>([&] { find_excerpts(scratch.path(), {"none"}); }) ==
             (scratch / "none").string() + ": there is no such folder to take excerpts from");
}

BOOST_AUTO_TEST_CASE(a_character_without_mapping_is_an_error_and_mathematics_is_not) {
  BOOST_TEST(error_in(begin + "x\n// ν, π, −, ², ∂, ∫, ≤, ξ, ·, –, →, √, …\n" + end + "x\n") ==
             "(no error)");
  BOOST_TEST(error_in(begin + "x\na\n// 語\n" + end + "x\n") ==
             "a.cpp:3: LaTeX has no mapping for '語' in excerpt 'x'");
  BOOST_TEST(error_in(begin + "x\n\xff\n" + end + "x\n") ==
             "a.cpp:2: byte 0xff in excerpt 'x' is not UTF-8 text");
}

BOOST_AUTO_TEST_SUITE_END()
