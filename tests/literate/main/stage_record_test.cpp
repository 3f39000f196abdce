// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stage_record.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "holds.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
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

BOOST_AUTO_TEST_CASE(a_stage_tells_its_costs_beside_its_record) {
  const TemporaryFolder scratch;

  StageRecord(scratch / "state/draw").done({});

  const auto costs = nlohmann::json::parse(sys::read_file(scratch / "state/draw.costs"));
  BOOST_TEST(costs.at("seconds").get<double>() < 100);
  BOOST_TEST(costs.at("cpu_seconds").get<double>() > 0);
  BOOST_TEST(costs.at("peak_memory_mb").get<int>() > 0);
}

BOOST_AUTO_TEST_CASE(this_program_is_the_test) {
  const FileDigests program = this_program();

  BOOST_TEST_REQUIRE(program.size() == 1U);
  BOOST_TEST(fs::path(program.begin()->first).filename() == "literate_tests");
  BOOST_TEST(program.begin()->second == sys::sha256_of_file(program.begin()->first));
}

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
  BOOST_TEST(holds(error(), "a b.tex' was changed after it was made"));
  std::filesystem::remove(folder / "a b.tex");
  BOOST_TEST(holds(error(), "a b.tex' was changed after it was made"));
  sys::write_file_atomically(folder / "a b.tex", "1");
  sys::write_file_atomically(digest, "");
  BOOST_TEST(holds(error(), "digest' does not name"));
  sys::write_file_atomically(folder / "mine.sty", "");
  BOOST_TEST(holds(error(), "mine.sty' was not made by the program"));
}

BOOST_AUTO_TEST_CASE(the_digest_of_a_folder_has_the_form_of_sha256sum) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "b c", "2");
  sys::write_file_atomically(scratch / "a/d", "1");

  BOOST_TEST(digest_of(scratch.path()) ==
             sys::sha256_of_text("1") + "  a/d\n" + sys::sha256_of_text("2") + "  b c\n");
}

BOOST_AUTO_TEST_SUITE_END()
