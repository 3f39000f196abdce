// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/digest.hpp"

#include <boost/test/unit_test.hpp>

#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(digest_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(a_generated_file_that_was_changed_or_added_is_named) {
  const TemporaryFolder scratch;
  const auto folder = scratch / "made";
  const auto digest = scratch / "digest";
  const auto error = [&] {
    return message_of<sys::OutputError>([&] { require_as_made(folder, digest, {"a b.tex"}); });
  };
  sys::write_file_atomically(folder / "a b.tex", "1");
  sys::write_file_atomically(digest, sys::sha256_of_file(folder / "a b.tex") + "  a b.tex\n");
  require_as_made(folder, digest, {"a b.tex"});

  sys::write_file_atomically(folder / "a b.tex", "2");
  BOOST_TEST(error().find("a b.tex' was changed after it was made") != std::string::npos);
  std::filesystem::remove(folder / "a b.tex");
  BOOST_TEST(error().find("a b.tex' was changed after it was made") != std::string::npos);
  sys::write_file_atomically(folder / "a b.tex", "1");
  sys::write_file_atomically(digest, "");
  BOOST_TEST(error().find("digest' does not name") != std::string::npos);
  sys::write_file_atomically(folder / "mine.sty", "");
  BOOST_TEST(error().find("mine.sty' was not made by the program") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_digest_of_a_folder_has_the_form_of_sha256sum) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "b c", "2");
  sys::write_file_atomically(scratch / "a/d", "1");

  BOOST_TEST(digest_of(scratch.path()) ==
             sys::sha256_of_text("1") + "  a/d\n" + sys::sha256_of_text("2") + "  b c\n");
}

BOOST_AUTO_TEST_SUITE_END()
