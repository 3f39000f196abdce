// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/proc.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <string>
#include <thread>

BOOST_AUTO_TEST_SUITE(proc_test)

using namespace sys;

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
