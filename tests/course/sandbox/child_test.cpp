// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"
#include "message_of.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>

#include "holds.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(child_test)

using course::Child;
using course::Excess;

namespace {

struct Shell {
  TemporaryFolder folder;

  Child child(const std::string& script) const {
    return {.command = {"/bin/sh", "-c", script},
            .environment = {"LC_ALL=C", "PATH=/usr/bin:/bin"},
            .folder = folder.path(),
            .input = "/dev/null",
            .output = folder.path() / "output",
            .errors = folder.path() / "errors"};
  }
  std::string output() const { return sys::read_file(folder.path() / "output"); }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_streams_of_a_child_are_the_files_it_was_given) {
  const Shell shell;
  Child child = shell.child("cat; cat <&3; pwd; echo wrong >&2; exit 7");
  child.input = shell.folder.write("input", "asked\n");
  child.third = shell.folder.write("third", "filter\n");

  const course::ChildEnd end = run_child(child);

  BOOST_TEST(end.status == 7);
  BOOST_TEST((end.excess == Excess::none));
  BOOST_TEST(shell.output() == "asked\nfilter\n" + shell.folder.path().string() + "\n");
  BOOST_TEST(sys::read_file(child.errors) == "wrong\n");
}

BOOST_AUTO_TEST_CASE(a_child_inherits_neither_environment_nor_descriptors) {
  const Shell shell;
  ::setenv("HALFSPACE_SECRET", "seed", 1);

  run_child(shell.child("env; ls /proc/self/fd"));

  BOOST_TEST(!holds(shell.output(), "SECRET"));
  // ls itself opens descriptor 4 to read the folder.
  BOOST_TEST(shell.output().ends_with("\n0\n1\n2\n3\n4\n"), shell.output());
}

BOOST_AUTO_TEST_CASE(a_signal_that_ends_a_child_is_its_status) {
  const Shell shell;

  BOOST_TEST(run_child(shell.child("kill -SEGV $$")).status == 128 + SIGSEGV);
}

BOOST_AUTO_TEST_CASE(a_program_that_cannot_start_is_named) {
  const Shell shell;
  Child child = shell.child("");
  child.command = {"/no/such/program"};

  BOOST_TEST(message_of<sys::ToolError>([&] { run_child(child); }) ==
             "cannot start /no/such/program: No such file or directory");
}

BOOST_AUTO_TEST_CASE(what_a_child_leaves_behind_ends_with_it) {
  const Shell shell;

  run_child(shell.child("setsid sleep 100 & sleep 100 & exit 0"));

  BOOST_TEST(sys::descendants(::getpid()).empty());
}

BOOST_AUTO_TEST_CASE(a_child_that_exceeds_a_limit_is_ended_and_the_limit_named) {
  const Shell shell;
  const auto begin = std::chrono::steady_clock::now();
  const auto excess_of = [&](const std::string& script, auto set_limit) {
    Child child = shell.child(script);
    set_limit(child);
    return run_child(child).excess;
  };

  BOOST_TEST((excess_of("(sleep 100 & sleep 100 & sleep 100)& wait; sleep 100",
                        [](Child& child) { child.tasks = 3; }) == Excess::tasks));
  BOOST_TEST((excess_of("while :; do :; done", [](Child& child) { child.cpu_seconds = 0.2; }) ==
              Excess::time));
  BOOST_TEST((excess_of("head -c 200000000 /dev/zero | tail -c 150000000 >/dev/null; sleep 100",
                        [](Child& child) { child.memory_mb = 50; }) == Excess::memory));
  for (const char* script :
       {"sleep 100",
        "exec /usr/bin/perl -e 'while (1) { select undef, undef, undef, 0.045; "
        "1 for 1 .. 20000 }'"}) {
    BOOST_TEST(
        (excess_of(script, [](Child& child) { child.waiting_seconds = 0.3; }) == Excess::time),
        script);
  }
  BOOST_TEST((std::chrono::steady_clock::now() - begin < std::chrono::seconds(50)));
}

BOOST_AUTO_TEST_CASE(a_child_that_wants_a_processor_does_not_wait) {
  const Shell shell;
  Child child = shell.child("i=0; while [ $i -lt 300000 ]; do i=$((i+1)); done");
  child.waiting_seconds = 0.1;

  const course::ChildEnd end = run_child(child);

  BOOST_TEST((end.excess == Excess::none));
  BOOST_TEST(end.status == 0);
  BOOST_TEST(end.cpu_seconds > 0.1);
}

// Whoever stops the grading, by Ctrl-Z for instance, does no injustice to the job that is running.
BOOST_AUTO_TEST_CASE(time_in_which_the_watching_process_was_stopped_does_not_count) {
  const Shell shell;
  Child child = shell.child("sleep 2.2");
  child.waiting_seconds = 1.5;
  const pid_t watching = ::fork();
  if (watching == 0) ::_exit(run_child(child).excess == Excess::none ? 0 : 1);

  ::usleep(300'000);
  ::kill(watching, SIGSTOP);
  ::usleep(1'700'000);
  ::kill(watching, SIGCONT);
  int status = 1;
  ::waitpid(watching, &status, 0);

  BOOST_TEST(status == 0);
}

// A parent that ignored the end of its children would hide their time from the kernel's sum.
BOOST_AUTO_TEST_CASE(the_time_of_forgotten_children_counts) {
  const Shell shell;
  Child child = shell.child(
      "exec /usr/bin/perl -e '$SIG{CHLD} = \"IGNORE\"; for (1 .. 100) { if (!fork) "
      "{ 1 while (times)[0] < 0.02; exit } 1 while wait > 0 }'");
  child.cpu_seconds = 1;
  child.filter = shell.folder.path() / "filter";
  course::write_syscall_filter(child.filter);

  const course::ChildEnd end = run_child(child);

  BOOST_TEST((end.excess == Excess::time));
  BOOST_TEST(end.cpu_seconds > 1);
}

BOOST_AUTO_TEST_CASE(time_by_the_clock_has_a_limit_too) {
  const Shell shell;
  Child child = shell.child("while :; do sleep 0.01; done");
  child.clock_seconds = 0.3;

  BOOST_TEST((run_child(child).excess == Excess::time));
}

BOOST_AUTO_TEST_CASE(a_child_that_kills_its_group_kills_itself_alone) {
  const Shell shell;

  BOOST_TEST(run_child(shell.child("kill -KILL 0; sleep 5")).status == 128 + SIGKILL);
}

BOOST_AUTO_TEST_SUITE_END()
