// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

#include "system/process.hpp"

BOOST_AUTO_TEST_SUITE(usage_test)

BOOST_AUTO_TEST_CASE(processes_that_end_while_they_are_looked_at_are_no_error) {
  using std::chrono::steady_clock;
  const auto end = steady_clock::now() + std::chrono::seconds(1);
  const pid_t parent = ::fork();
  if (parent == 0) {
    while (steady_clock::now() < end) {
      for (int i = 0; i < 20; ++i) {
        if (::fork() == 0) ::_exit(0);
      }
      while (::waitpid(-1, nullptr, 0) > 0) {
      }
    }
    ::_exit(0);
  }

  std::size_t n_seen = 0;
  while (steady_clock::now() < end) {
    const std::vector<pid_t> processes = sys::descendants(::getpid());
    course::usage_of(processes);
    n_seen += processes.size();
  }
  ::waitpid(parent, nullptr, 0);

  BOOST_TEST(n_seen > 0U);
  BOOST_TEST(sys::descendants(::getpid()).empty());
}

BOOST_AUTO_TEST_CASE(a_process_whose_thread_works_does_not_wait) {
  const pid_t process = ::fork();
  if (process == 0) {
    std::thread works([] {
      for (volatile bool goes_on = true; goes_on;) {
      }
    });
    works.join();
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));

  const bool is_waiting = course::usage_of({process}).is_waiting;
  ::kill(process, SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const bool is_waiting_when_stopped = course::usage_of({process}).is_waiting;
  ::kill(process, SIGKILL);
  ::waitpid(process, nullptr, 0);

  BOOST_TEST(!is_waiting);
  BOOST_TEST(is_waiting_when_stopped);
}

BOOST_AUTO_TEST_SUITE_END()
