// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/process.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdlib>

#include "message_of.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(process_test)

using namespace sys;

BOOST_AUTO_TEST_CASE(a_child_gets_its_arguments_folder_and_environment_unchanged) {
  const TemporaryFolder scratch;

  const auto result =
      run({.program = "sh",
           .arguments = {"-c", "pwd; echo \"$1 $LITERATE\" >&2; exit 7", "sh", "a  $b"},
           .working_directory = scratch.path(),
           .environment = {{"LITERATE", "yes"}}});

  BOOST_TEST(result.exit_status == 7);
  BOOST_TEST(result.output == scratch.path().string() + "\na  $b yes\n");
}

BOOST_AUTO_TEST_CASE(more_output_than_a_pipe_holds_is_read) {
  BOOST_TEST(run({.program = "head", .arguments = {"-c", "300000", "/dev/zero"}}).output.size() ==
             300000U);
}

BOOST_AUTO_TEST_CASE(a_signal_gives_a_status_above_128) {
  BOOST_TEST(run({.program = "sh", .arguments = {"-c", "kill -9 $$"}}).exit_status == 137);
}

BOOST_AUTO_TEST_CASE(what_cannot_start_is_a_tool_error_naming_it) {
  BOOST_TEST(message_of<ToolError>([] { run({.program = "no-such-tool"}); }) ==
             "no-such-tool is not installed; 'make setup' installs it");
  BOOST_TEST(message_of<ToolError>([] {
               run({.program = "sh", .working_directory = "no such folder"});
             }) == "cannot start sh: No such file or directory");
}

BOOST_AUTO_TEST_SUITE_END()
