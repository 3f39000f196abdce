// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/row_team.hpp"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "system/require.hpp"

namespace point_contact {

using Eigen::Index;

RowTeam::RowTeam(int n_threads) : n_threads_(n_threads) {
  constexpr int most = 64;
  if (n_threads < 1) throw sys::InvalidQuantity("threads", n_threads, "1 or more");
  n_threads_ = std::min(n_threads, most);
}

void RowTeam::for_stretches(Index n, double cost,
                            const std::function<void(Index, Index, int)>& work) const {
  constexpr double worth_a_thread = 2e5;  // operations; a thread takes some 20 µs to start
  const bool is_worth_it = cost * static_cast<double>(n) > worth_a_thread;
  const Index n_stretches = is_worth_it ? std::min<Index>(n_threads_, n) : 1;
  if (n_stretches <= 1) {
    work(0, n, 0);
    return;
  }
  std::vector<std::exception_ptr> errors(static_cast<std::size_t>(n_stretches));
  const auto run = [&](Index k) {
    try {
      work(n * k / n_stretches, n * (k + 1) / n_stretches, static_cast<int>(k));
    } catch (...) {
      errors[static_cast<std::size_t>(k)] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (Index k = 1; k < n_stretches; ++k) threads.emplace_back(run, k);
    run(0);
  }
  for (const auto& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace point_contact
