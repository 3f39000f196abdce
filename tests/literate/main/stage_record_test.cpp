// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stage_record.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(stage_record_test)

using namespace literate;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(a_stage_is_running_then_done_or_failed) {
  const TemporaryFolder scratch;
  const fs::path record = scratch / "state/draw";
  const fs::path unfinished = scratch / "state/draw.unfinished";
  {
    StageRecord stage(record);
    BOOST_TEST(sys::read_file(unfinished) == "running\n");
    stage.done({{"/a", "0123"}});
  }
  BOOST_TEST(sys::read_file(record) == "0123  /a\n# done\n");
  BOOST_TEST(!fs::exists(unfinished));
  {
    const StageRecord stage(record);
    BOOST_TEST(!fs::exists(record));
  }
  BOOST_TEST(!fs::exists(record));
  BOOST_TEST(sys::read_file(unfinished) == "failed\n");
}

BOOST_AUTO_TEST_CASE(sha256sum_reads_a_record_whatever_the_names_are) {
  const TemporaryFolder scratch;
  FileDigests files;
  for (const std::string name : {"plain", "a b", "back\\slash", "line\nend"}) {
    const fs::path file = scratch / name;
    sys::write_file_atomically(file, name);
    files[file.string()] = sys::sha256_of_file(file);
  }
  sys::write_file_atomically(scratch / "record", record_text(files));
  const auto check = [&] {
    return sys::run({.program = "sha256sum",
                     .arguments = {"--check", "--strict", (scratch / "record").string()}})
        .exit_status;
  };

  BOOST_TEST(check() == 0);
  sys::write_file_atomically(scratch / "line\nend", "another");
  BOOST_TEST(check() == 1);
}

BOOST_AUTO_TEST_CASE(this_program_is_the_test) {
  const FileDigests program = this_program();

  BOOST_TEST_REQUIRE(program.size() == 1U);
  BOOST_TEST(fs::path(program.begin()->first).filename() == "literate_tests");
  BOOST_TEST(program.begin()->second == sys::sha256_of_file(program.begin()->first));
}

BOOST_AUTO_TEST_SUITE_END()
