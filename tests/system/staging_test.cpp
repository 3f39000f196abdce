// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/staging.hpp"

#include <boost/test/unit_test.hpp>

#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(staging_test)

using namespace sys;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(nothing_reaches_the_output_folder_before_it_is_published) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "out/kept", "old");
  fs::path staged;
  {
    const Staging staging(scratch / "out");
    staged = staging.path();
    write_file_atomically(staged / "kept", "new");
    BOOST_TEST(staging.files() == std::vector<std::string>{"kept"},
               boost::test_tools::per_element());
  }
  BOOST_TEST(read_file(scratch / "out/kept") == "old");
  BOOST_TEST(!fs::exists(staged));
}

BOOST_AUTO_TEST_CASE(publishing_moves_what_changed_and_removes_what_was_not_made_again) {
  const TemporaryFolder scratch;
  const fs::path out = scratch / "out";
  for (const char* file : {"same", "changed", "former", "foreign"}) {
    write_file_atomically(out / file, "old");
  }
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(5);
  fs::last_write_time(out / "same", long_ago);
  const auto stamp = fs::last_write_time(out / "same");
  Staging staging(out);
  write_file_atomically(staging.path() / "same", "old");
  write_file_atomically(staging.path() / "changed", "new");
  write_file_atomically(staging.path() / "below/made", "new");

  staging.publish({"same", "changed", "former"});

  BOOST_TEST(
      files_below(out) == (std::vector<std::string>{"below/made", "changed", "foreign", "same"}),
      boost::test_tools::per_element());
  BOOST_TEST(read_file(out / "changed") == "new");
  BOOST_CHECK(fs::last_write_time(out / "same") == stamp);

  staging.replace();

  BOOST_TEST(files_below(out) == std::vector<std::string>{"same"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_list_of_former_files_cannot_remove_anything_elsewhere) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "elsewhere", "");
  Staging staging(scratch / "out");

  staging.publish({"../elsewhere", (scratch / "elsewhere").string(), "below/../../elsewhere"});

  BOOST_TEST(fs::exists(scratch / "elsewhere"));
}

BOOST_AUTO_TEST_CASE(what_a_broken_run_left_is_replaced) {
  const TemporaryFolder scratch;
  fs::copy(Staging(scratch / "out").path(), scratch / "left", fs::copy_options::recursive);
  write_file_atomically(scratch / "left/half-made", "");
  fs::rename(scratch / "left", scratch / "out.part");

  const Staging staging(scratch / "out/");

  BOOST_TEST(staging.path() == scratch / "out.part");
  BOOST_TEST(staging.files().empty());
}

BOOST_AUTO_TEST_CASE(a_folder_of_somebody_else_is_left_alone) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "out.part/thesis", "years of work");

  BOOST_TEST(message_of<OutputError>([&] { Staging staging(scratch / "out"); }) ==
             "'" + (scratch / "out.part").string() +
                 "' is needed as a staging folder but holds something else; move it away");
  BOOST_TEST(read_file(scratch / "out.part/thesis") == "years of work");
}

BOOST_AUTO_TEST_CASE(an_output_folder_that_cannot_be_written_is_named) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "file", "");
  BOOST_TEST(message_of<OutputError>([&] { Staging staging(scratch / "file"); }) ==
             "cannot write to the output folder '" + (scratch / "file").string() + "'");
}

BOOST_AUTO_TEST_CASE(what_a_killed_run_published_is_gone_before_the_next_one_looks) {
  const TemporaryFolder scratch;
  const fs::path out = scratch / "out";
  write_file_atomically(scratch / "elsewhere", "");
  write_file_atomically(out / "a", "of the first run");
  // The second was killed after it had moved b.
  write_file_atomically(out / "b", "of the second run");
  write_file_atomically(scratch / "out.publishing", "b\nc\n../elsewhere\n");

  const Staging staging(out);

  BOOST_TEST(files_below(out) == std::vector<std::string>{"a"}, boost::test_tools::per_element());
  BOOST_TEST(fs::exists(scratch / "elsewhere"));
  BOOST_TEST(!fs::exists(scratch / "out.publishing"));
}

// draw copies what compute wrote, and publishes the copies beside its drawings.
BOOST_AUTO_TEST_CASE(what_was_there_before_survives_a_publishing_that_ended_half_way) {
  const TemporaryFolder scratch;
  const fs::path out = scratch / "out";
  write_file_atomically(out / "computed", "by another stage");
  write_file_atomically(out / "z/full", "");  // no file can take the place of this folder
  {
    Staging staging(out);
    write_file_atomically(staging.path() / "computed", "by another stage");
    write_file_atomically(staging.path() / "drawn", "new");
    write_file_atomically(staging.path() / "z", "new");
    BOOST_CHECK_THROW(staging.publish({}), OutputError);
  }

  const Staging next(out);

  BOOST_TEST(files_below(out) == (std::vector<std::string>{"computed", "z/full"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_folder_that_was_left_while_its_marker_was_written_is_known) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "out.part/.literate-staging.new", "");

  const Staging staging(scratch / "out");

  BOOST_TEST(staging.files().empty());
}

BOOST_AUTO_TEST_SUITE_END()
