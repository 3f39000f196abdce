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
  sys::write_file_atomically(folder / "mine.sty", "");
  BOOST_TEST(error().find("mine.sty' was not made by the program") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
