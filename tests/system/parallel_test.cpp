// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/parallel.hpp"

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "messages.hpp"

BOOST_AUTO_TEST_SUITE(parallel_test)

using sys::for_each_parallel;

BOOST_AUTO_TEST_CASE(each_job_runs_once_for_any_number_of_threads) {
  for (const std::size_t n_jobs : {0U, 1U, 3U, 50U}) {
    std::vector<std::atomic<int>> n_done(37);
    for_each_parallel(n_done.size(), n_jobs, [&](std::size_t i) { ++n_done[i]; });
    for (const auto& n : n_done) BOOST_TEST(n == 1);
  }
  for_each_parallel(0, 2, [](std::size_t) { BOOST_ERROR("nothing was to be done"); });
}

BOOST_AUTO_TEST_CASE(at_most_n_jobs_run_at_the_same_time) {
  std::atomic<int> n_running = 0;
  std::atomic<int> most = 0;
  for_each_parallel(200, 2, [&](std::size_t) {
    const int now = ++n_running;
    for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
    }
    --n_running;
  });
  BOOST_TEST(most <= 2);
}

BOOST_AUTO_TEST_CASE(the_exception_of_the_lowest_index_is_thrown_after_all_jobs_ran) {
  std::atomic<int> n_done = 0;
  const std::string message = message_of<std::runtime_error>([&] {
    for_each_parallel(20, 4, [&](std::size_t i) {
      ++n_done;
      if (i == 17 || i == 5) throw std::runtime_error(std::to_string(i));
    });
  });
  BOOST_TEST(message == "5");
  BOOST_TEST(n_done == 20);
}

BOOST_AUTO_TEST_SUITE_END()
