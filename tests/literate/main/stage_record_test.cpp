// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stage_record.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

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

BOOST_AUTO_TEST_SUITE_END()
