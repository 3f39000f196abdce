// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/record.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(record_test)

using namespace sys;

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
