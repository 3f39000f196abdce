// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "messages.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(files_test)

using namespace sys;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(writing_the_same_text_keeps_the_time_stamp) {
  const TemporaryFolder scratch;
  const fs::path file = scratch / "a folder/file.txt";
  BOOST_TEST(write_if_changed(file, "text"));
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(5);
  fs::last_write_time(file, long_ago);
  const auto stamp = fs::last_write_time(file);

  BOOST_TEST(!write_if_changed(file, "text"));

  BOOST_CHECK(fs::last_write_time(file) == stamp);
  BOOST_TEST(write_if_changed(file, "other"));
  BOOST_TEST(read_file(file) == "other");
  BOOST_TEST(!fs::exists(scratch / "a folder/file.txt.new"));
}

BOOST_AUTO_TEST_CASE(errors_name_the_file) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "file", "");
  const std::string missing = (scratch / "none").string();

  BOOST_TEST(holds(message_of<OutputError>([&] { read_file(missing); }), missing));
  BOOST_CHECK_THROW(read_file(scratch.path()), OutputError);
  BOOST_CHECK_THROW(write_file_atomically(scratch / "file/below", ""), OutputError);
  BOOST_TEST(message_of<OutputError>([&] { read_file(missing); }) ==
             "cannot read '" + missing + "': No such file or directory");
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_an_error_that_names_the_file_and_keeps_the_old_text) {
  const TemporaryFolder scratch;
  const fs::path file = scratch / "file";
  write_file_atomically(file, "old");
  fs::create_symlink("/dev/full", scratch / "file.new");

  BOOST_TEST(message_of<OutputError>([&] { write_file_atomically(file, "new"); }) ==
             "cannot write '" + file.string() + "': No space left on device");

  BOOST_TEST(read_file(file) == "old");
  BOOST_TEST(!fs::is_symlink(scratch / "file.new"));
}

BOOST_AUTO_TEST_CASE(a_tool_is_found_in_the_path_or_named_in_an_error) {
  BOOST_TEST(find_tool("sh").filename() == "sh");
  BOOST_TEST(message_of<ToolError>([] { find_tool("no-such-tool"); }) ==
             "no-such-tool is not installed: run `make setup`");
}

BOOST_AUTO_TEST_SUITE_END()
