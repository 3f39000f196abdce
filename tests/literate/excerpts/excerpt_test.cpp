// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "holds.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
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

BOOST_AUTO_TEST_CASE(the_name_of_a_file_tells_its_language) {
  BOOST_TEST(listing_language("src/a.cpp") == "[20]C++");
  BOOST_TEST(listing_language("octave/Tri_dist.m") == "Octave");
  BOOST_TEST(listing_language("case.toml") == "TOML");
  BOOST_TEST(listing_language("Makefile") == "[gnu]make");
  BOOST_TEST(listing_language("src/CMakeLists.txt") == "CMake");
}

BOOST_AUTO_TEST_CASE(a_text_of_no_known_language_is_printed_as_it_is) {
  BOOST_TEST(listing_language("notes.txt") == "");
  BOOST_TEST(listing_language("cpp") == "");
}

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

namespace {

const Excerpt hertz{"hertz", "src/contact/hertz.cpp", 7, "return p0;\n"};
std::string error_for(const std::vector<Excerpt>& excerpts) {
  return message_of<sys::SourceError>([&] { require_compiled(excerpts, record_of({hertz})); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_hash_is_the_sha256_of_the_text) {
  // printf abc | sha256sum
  BOOST_TEST(sys::sha256_of_text("abc") ==
             "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

BOOST_AUTO_TEST_CASE(an_excerpt_as_compiled_is_accepted_and_one_on_other_lines_is_not) {
  Excerpt lower = hertz;
  lower.first_line = 70;

  BOOST_TEST(error_for({hertz}) == "(no error)");
  BOOST_TEST(holds(error_for({lower}), "is not what this program was compiled from"));
}

BOOST_AUTO_TEST_CASE(an_excerpt_that_changed_moved_came_or_went_is_refused) {
  const std::string refused =
      "src/contact/hertz.cpp: excerpt 'hertz' is not what this program was compiled from: rebuild";
  Excerpt changed = hertz;
  changed.text = "return 2 * p0;\n";
  Excerpt moved = hertz;
  moved.file = "src/contact/other.cpp";
  const Excerpt added{"new", "src/new.cpp", 1, "a\n"};

  BOOST_TEST(error_for({changed}) == refused);
  BOOST_TEST(error_for({moved}).starts_with("src/contact/other.cpp: excerpt 'hertz'"));
  BOOST_TEST(error_for({hertz, added}).starts_with("src/new.cpp: excerpt 'new'"));
  BOOST_TEST(error_for({}) == refused);
}

using Lines = std::vector<std::string>;

BOOST_AUTO_TEST_CASE(all_files_below_are_found_in_order) {
  const TemporaryFolder folder;
  folder.write("b/c.cpp", "");
  folder.write("a.hpp", "");
  folder.write("CMakeLists.txt", "add_library(a a.cpp)\n");

  BOOST_TEST(
      literate::paper_sources(folder.path()) == (Lines{"CMakeLists.txt", "a.hpp", "b/c.cpp"}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_paper_below_keeps_its_sources_to_itself) {
  const TemporaryFolder folder;
  folder.write("a.cpp", "");
  folder.write("template/CMakeLists.txt", "project(mine)\nliterate_add_paper(NAME mine)\n");
  folder.write("template/src/a.cpp", "");
  folder.write("templates.cpp", "");

  BOOST_TEST(literate::paper_sources(folder.path()) == (Lines{"a.cpp", "templates.cpp"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_there_is_named) {
  const TemporaryFolder folder;
  BOOST_CHECK_EXCEPTION(literate::paper_sources(folder / "none"), sys::OutputError,
                        [](const sys::OutputError& error) {
                          return std::string(error.what()).find("none") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_SUITE_END()
