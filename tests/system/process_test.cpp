// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/process.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "message_of.hpp"
#include "system/decimal.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"
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
  unsetenv("LITERATE_SETUP");
  BOOST_TEST(message_of<ToolError>([] { run({.program = "no-such-tool"}); }) ==
             "no-such-tool is not installed");
  BOOST_TEST(message_of<ToolError>([] {
               run({.program = "sh", .working_directory = "no such folder"});
             }) == "cannot start sh: No such file or directory");
}

BOOST_AUTO_TEST_CASE(a_missing_tool_is_told_with_the_command_that_installs_it) {
  setenv("LITERATE_SETUP", "make setup page", 1);
  const std::string message = message_of<ToolError>([] { find_tool("no-such-tool"); });
  unsetenv("LITERATE_SETUP");

  BOOST_TEST(message ==
             "no-such-tool is not installed; 'make setup page' installs what packages.txt lists");
}

BOOST_AUTO_TEST_CASE(how_a_child_ended_is_told_in_words) {
  BOOST_TEST(end_of({3, ""}) == "status 3");
  BOOST_TEST(end_of(run({.program = "sh", .arguments = {"-c", "kill -9 $$"}})) ==
             "signal 9 (Killed)");
  BOOST_TEST(end_of({255, ""}) == "status 255");
}

BOOST_AUTO_TEST_CASE(a_child_beyond_its_limit_is_ended_with_all_that_it_started) {
  ::unsetenv("LITERATE_TIMEOUT");  // of whoever runs the tests
  const TemporaryFolder scratch;
  const Command command{.program = "sh",
                        .arguments = {"-c", "(sleep 1.6; touch late) & sleep 60; :"},
                        .working_directory = scratch.path(),
                        .limit = {"figure 'f'", 1}};

  BOOST_TEST(message_of<ToolError>([&] { run(command); }) ==
             "figure 'f': sh has not ended after 1 s and was stopped; LITERATE_TIMEOUT=seconds "
             "allows more, 0 any time");

  run({.program = "sleep", .arguments = {"1"}});
  BOOST_TEST(!std::filesystem::exists(scratch / "late"));
}

BOOST_AUTO_TEST_CASE(a_child_that_ends_with_its_caller_sees_no_interrupt) {
  const Command blocked{
      .program = "grep", .arguments = {"^SigBlk", "/proc/self/status"}, .ends_with_caller = true};
  Command plain = blocked;
  plain.ends_with_caller = false;

  BOOST_TEST(run(blocked).output == "SigBlk:\t0000000000000002\n");  // SIGINT is the second
  BOOST_TEST(run(plain).output == "SigBlk:\t0000000000000000\n");
}

BOOST_AUTO_TEST_CASE(a_child_that_ends_with_its_caller_does_not_outlive_it) {
  const TemporaryFolder scratch;
  const auto begun = scratch.path() / "begun";
  const pid_t caller = ::fork();
  if (caller == 0) {
    ::setpgid(0, 0);
    run({.program = "sh",
         .arguments = {"-c", "echo $$ > part; mv part begun; exec sleep 60"},
         .working_directory = scratch.path(),
         .ends_with_caller = true});
    ::_exit(0);
  }
  const auto comes = [](auto condition) {
    for (int i = 0; i < 1000 && !condition(); ++i) ::usleep(10'000);
    return condition();
  };
  BOOST_REQUIRE(comes([&] { return std::filesystem::exists(begun); }));
  const pid_t child = parsed<pid_t>(lines_of(read_file(begun)).front()).value();

  ::kill(caller, SIGTERM);
  int status = 0;
  ::waitpid(caller, &status, 0);

  BOOST_TEST(WTERMSIG(status) == SIGTERM);
  const auto command_line = "/proc/" + std::to_string(child) + "/cmdline";
  BOOST_TEST(comes([&] { return read_proc_file(command_line).empty(); }));
}

BOOST_AUTO_TEST_CASE(a_variable_takes_the_place_of_the_limit_or_lifts_it) {
  const Command command{
      .program = "sh", .arguments = {"-c", "sleep 1.3; exit 4"}, .limit = {"a figure", 1}};
  const auto with = [&](const char* seconds) {
    ::setenv("LITERATE_TIMEOUT", seconds, 1);
    const std::string message =
        message_of<Error>([&] { BOOST_TEST(run(command).exit_status == 4); });
    ::unsetenv("LITERATE_TIMEOUT");
    return message;
  };

  BOOST_TEST(with("30") == "(no error)");
  BOOST_TEST(with("") == "(no error)");
  BOOST_TEST(with("0") == "(no error)");
  for (const char* wrong : {"soon", "-1", "1.5", "99999999999999999999"}) {
    BOOST_TEST(with(wrong) ==
               std::string("TIMEOUT: '") + wrong + "' is not a number of seconds, 0 to 10000000");
  }
}

BOOST_AUTO_TEST_CASE(a_file_is_read_whole_with_its_zeros) {
  const std::string words = read_proc_file("/proc/self/cmdline");

  BOOST_TEST(words.find('\0') != words.npos);
  BOOST_TEST(words.back() == '\0');
  BOOST_TEST(read_proc_file("/proc/self/stat").starts_with(std::to_string(::getpid()) + " ("));
}

BOOST_AUTO_TEST_CASE(a_process_that_has_ended_has_no_text) {
  BOOST_TEST(read_proc_file("/proc/4194305/stat").empty());  // one above the largest number
}

// Address 0 of a process is never there, so that the first read of this file fails, as it does in
// the others when the process ends after they were opened.
BOOST_AUTO_TEST_CASE(a_read_that_fails_ends_the_text) {
  BOOST_TEST(read_proc_file("/proc/self/mem").empty());
}

BOOST_AUTO_TEST_CASE(the_children_of_every_thread_are_found) {
  const auto before = descendants(::getpid()).size();
  std::size_t during = 0;

  std::thread([&] {
    const pid_t child = ::fork();
    if (child == 0) {
      ::pause();
      ::_exit(0);
    }
    during = descendants(::getpid()).size();
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }).join();

  BOOST_TEST(during == before + 1);
}

BOOST_AUTO_TEST_SUITE_END()
