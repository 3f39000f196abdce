// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/submission.hpp"

#include <boost/test/unit_test.hpp>

#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(listing_test)

using namespace course;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(what_is_to_be_graded_is_listed_and_the_rest_told) {
  const TemporaryFolder folder;
  folder.write("alice/src/square.cpp", "");
  folder.write("alice.zip", "");
  folder.write("bob.tar.gz", "");
  folder.write("zoe.zip", "");
  folder.write("line\nend.zip", "");
  folder.write("notes.txt", "");
  folder.write(".DS_Store", "");
  fs::create_symlink("/etc", folder.path() / "mallory");

  const Listing listing =
      list_submissions(folder.path(), Roster{{"alice", {}}, {"bob", {}}, {"mallory", {}}});

  BOOST_REQUIRE(listing.entries.size() == 1U);
  BOOST_TEST(listing.entries[0].student == "bob");
  BOOST_REQUIRE(listing.problems.size() == 5U);
  BOOST_TEST(listing.problems[0].starts_with("'line?end.zip' is not named for a student: "));
  BOOST_TEST(listing.problems[1].starts_with("'mallory' is neither a folder nor an archive"));
  BOOST_TEST(listing.problems[3] == "'zoe.zip': there is no student zoe in the class");
  BOOST_TEST(listing.problems[4] ==
             "student alice has more than one submission: 'alice' and 'alice.zip'");
}

BOOST_AUTO_TEST_CASE(what_is_no_folder_of_submissions_is_an_error) {
  const TemporaryFolder folder;

  BOOST_CHECK_THROW(list_submissions(folder.write("class.csv", ""), {}), sys::OutputError);
  BOOST_CHECK_THROW(list_submissions(folder.path() / "nowhere", {}), sys::OutputError);
}

BOOST_AUTO_TEST_CASE(a_group_hands_in_under_its_own_name) {
  const TemporaryFolder folder;
  folder.write("g7.zip", "");
  folder.write("bob.zip", "");
  folder.write("carol.zip", "");

  const Listing listing = list_submissions(
      folder.path(), Roster{{"alice", {.group = "g7"}}, {"bob", {.group = "g7"}}, {"carol", {}}});

  BOOST_REQUIRE(listing.entries.size() == 2U);
  BOOST_TEST(listing.entries[0].student == "carol");
  BOOST_TEST(listing.entries[1].student == "g7");
  BOOST_REQUIRE(listing.problems.size() == 1U);
  BOOST_TEST(listing.problems[0] ==
             "'bob.zip': student bob hands in with group g7, for which it must be named");
}

BOOST_AUTO_TEST_SUITE_END()
