// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/paper.hpp"

#include <boost/test/unit_test.hpp>

#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(paper_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(what_the_build_asked_for_is_read_back) {
  const TemporaryFolder folder;
  sys::write_file_atomically(folder / "repository.json",
                             R"({"commit": "0123456789ab", "modified": true, "date": "2001",
                                 "engine": {"commit": "ba9876543210", "modified": true}})");

  const Repository repository = read_repository(folder.path());

  BOOST_TEST(repository.commit == "0123456789ab");
  BOOST_TEST(repository.modified);
  BOOST_TEST(repository.date == "2001");
  BOOST_TEST(repository.engine_commit == "ba9876543210");
  BOOST_TEST(repository.engine_modified);
}

BOOST_AUTO_TEST_CASE(a_file_that_is_missing_or_says_something_else_is_named) {
  const TemporaryFolder folder;
  BOOST_CHECK_THROW(read_repository(folder.path()), sys::OutputError);

  sys::write_file_atomically(folder / "repository.json", R"({"commit": 12})");

  BOOST_TEST(message_of<sys::OutputError>([&] {
               read_repository(folder.path());
             }).ends_with("repository.json' does not tell the state of a repository"));
}

BOOST_AUTO_TEST_SUITE_END()
