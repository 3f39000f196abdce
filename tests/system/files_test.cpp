// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "holds.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(files_test)

using namespace sys;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(the_same_text_leaves_the_time_stamp) {
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
  BOOST_TEST(files_below(scratch.path()).size() == 1U);
}

BOOST_AUTO_TEST_CASE(sha256_is_that_of_the_standard) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "abc", "abc");

  // FIPS 180-2, appendix B.1
  BOOST_TEST(sha256_of_file(scratch / "abc") ==
             "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

BOOST_AUTO_TEST_CASE(errors_name_the_file) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "file", "");
  const std::string missing = (scratch / "none").string();

  BOOST_TEST(holds(message_of<OutputError>([&] { read_file(missing); }), missing));
  BOOST_CHECK_THROW(read_file(scratch.path()), OutputError);
  BOOST_CHECK_THROW(sha256_of_file(missing), OutputError);
  BOOST_CHECK_THROW(files_below(missing), OutputError);
  BOOST_CHECK_THROW(write_file_atomically(scratch / "file/below", ""), OutputError);
  BOOST_TEST(message_of<OutputError>([&] { read_file(missing); }) ==
             "cannot read '" + missing + "': No such file or directory");
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_told_with_the_file_and_leaves_what_was_there) {
  const TemporaryFolder scratch;
  const fs::path file = scratch / "file";
  write_file_atomically(file, "old");
  fs::create_symlink("/dev/full", scratch / "file.new");

  BOOST_TEST(message_of<OutputError>([&] { write_file_atomically(file, "new"); }) ==
             "cannot write '" + file.string() + "': No space left on device");

  BOOST_TEST(read_file(file) == "old");
  BOOST_TEST(!fs::is_symlink(scratch / "file.new"));
}

const std::vector<std::string> names = {"plain", "a b", "back\\slash", "line\nend", "re\rturn"};

BOOST_AUTO_TEST_CASE(sha256sum_reads_a_record_whatever_the_names_are) {
  const TemporaryFolder scratch;
  Record record;
  for (const std::string& name : names) {
    const std::string file = (scratch / name).string();
    write_file_atomically(file, name);
    record.push_back(record_entry("/", file));
  }
  write_file_atomically(scratch / "record", record_text(record) + "# done\n");
  const auto check = [&] {
    return run({.program = "sha256sum", .arguments = {"--check", (scratch / "record").string()}})
        .exit_status;
  };

  BOOST_TEST(check() == 0);
  write_file_atomically(scratch / "line\nend", "another");
  BOOST_TEST(check() == 1);
}

BOOST_AUTO_TEST_CASE(a_record_is_read_as_it_was_written) {
  const TemporaryFolder scratch;
  for (const std::string& name : names) write_file_atomically(scratch / name, name);
  const Record written = record_entries(scratch.path(), names);

  const auto read = parse_record(record_text(written) + "# done\n");

  BOOST_TEST_REQUIRE(read.has_value());
  BOOST_TEST_REQUIRE(read->size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    BOOST_TEST((*read)[i].name == names[i]);
    BOOST_TEST((*read)[i].digest == sha256_of_text(names[i]));
    BOOST_TEST(is_as_recorded(scratch.path(), (*read)[i]));
  }
  BOOST_TEST(!parse_record("0123 one blank\n").has_value());
}

BOOST_AUTO_TEST_CASE(a_file_that_is_gone_or_changed_is_not_as_recorded) {
  const TemporaryFolder scratch;
  write_file_atomically(scratch / "a", "1");
  const RecordEntry before = record_entry(scratch.path(), "a");

  write_file_atomically(scratch / "a", "2");
  BOOST_TEST(!is_as_recorded(scratch.path(), before));
  std::filesystem::remove(scratch / "a");
  BOOST_TEST(!is_as_recorded(scratch.path(), before));
  BOOST_TEST(record_entry(scratch.path(), "a").digest == "-");
}

BOOST_AUTO_TEST_SUITE_END()
