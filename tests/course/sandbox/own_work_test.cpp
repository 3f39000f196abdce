// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(own_work_test)

using course::apart;

BOOST_AUTO_TEST_CASE(work_apart_returns_its_text_whatever_its_length) {
  BOOST_TEST(apart([] { return std::string(); }, 5, 512).value() == "");
  const std::string large(1'000'000, 'x');
  BOOST_TEST((apart([&] { return large; }, 5, 512).value() == large));
}

BOOST_AUTO_TEST_CASE(work_that_never_ends_crashes_throws_or_grows_returns_nothing) {
  const auto endless = [] {
    while (::getpid() > 0) {
    }
    return std::string("done");
  };
  BOOST_TEST(!apart(endless, 1, 512));
  const auto crashing = [] {
    std::raise(SIGKILL);
    return std::string("done");
  };
  BOOST_TEST(!apart(crashing, 5, 512));
  const auto throwing = []() -> std::string { throw std::runtime_error("no"); };
  BOOST_TEST(!apart(throwing, 5, 512));
  BOOST_TEST(!apart([] { return std::string(1'000'000'000, 'x'); }, 5, 512));
}

BOOST_AUTO_TEST_CASE(what_it_changes_stays_with_it) {
  int number = 1;
  apart(
      [&] {
        number = 2;
        return std::string();
      },
      5, 512);
  BOOST_TEST(number == 1);
}

BOOST_AUTO_TEST_SUITE_END()
