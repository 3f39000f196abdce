// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt_hashes.hpp"

#include <boost/test/unit_test.hpp>

#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

BOOST_AUTO_TEST_SUITE(excerpt_hashes_test)

using namespace literate;

namespace {

const Excerpt hertz{"hertz", "src/contact/hertz.cpp", 7, "return p0;\n"};
const std::string hash = sys::sha256_of_text(hertz.text);
const std::vector<CompiledExcerpt> compiled = {{"hertz", "src/contact/hertz.cpp", hash}};

std::string error_for(const std::vector<Excerpt>& excerpts) {
  return message_of<sys::SourceError>([&] { require_compiled(excerpts, compiled); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_hash_is_the_sha256_of_the_text) {
  // printf abc | sha256sum
  BOOST_TEST(sys::sha256_of_text("abc") ==
             "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

BOOST_AUTO_TEST_CASE(an_excerpt_as_compiled_is_accepted_wherever_its_lines_are_now) {
  Excerpt lower = hertz;
  lower.first_line = 70;

  BOOST_TEST(error_for({hertz}) == "(no error)");
  BOOST_TEST(error_for({lower}) == "(no error)");
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

BOOST_AUTO_TEST_CASE(the_source_that_a_build_compiles_holds_name_file_and_hash) {
  const std::string source = excerpt_hashes_source({hertz}, "app");

  for (const std::string& part : {hertz.name, hertz.file, hash, std::string("namespace app {")}) {
    BOOST_TEST(source.find(part) != std::string::npos, part);
  }
}

BOOST_AUTO_TEST_SUITE_END()
