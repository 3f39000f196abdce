// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace point_contact {

/// Threads that share the rows of a grid. Which thread does a row changes no result: rows are
/// independent, and sums are formed row by row and added up in the rows' order.
class RowTeam {
 public:
  /// n_threads ≥ 1, or InvalidQuantity is thrown; no more than 64 are used.
  explicit RowTeam(int n_threads);

  int n_threads() const { return n_threads_; }

  /// Calls work(begin, end, thread) for consecutive stretches of the rows 0 … n−1, one a thread;
  /// rethrows what the first of them threw. `cost` is about how many operations a row takes: what
  /// is done sooner than a thread is started is done by one.
  void for_stretches(Eigen::Index n, double cost,
                     const std::function<void(Eigen::Index, Eigen::Index, int)>& work) const;

  /// The same for single rows.
  template <class Work>
  void for_rows(Eigen::Index n, double cost, const Work& work) const {
    for_stretches(n, cost, [&work](Eigen::Index begin, Eigen::Index end, int /*thread*/) {
      for (Eigen::Index row = begin; row < end; ++row) work(row);
    });
  }

  /// Σ work(row), added up in the rows' order.
  template <class Work>
  double sum(Eigen::Index n, double cost, const Work& work) const {
    Eigen::VectorXd parts(n);
    for_rows(n, cost, [&](Eigen::Index row) { parts[row] = work(row); });
    return parts.sum();
  }

  /// The greatest work(row).
  template <class Work>
  double max(Eigen::Index n, double cost, const Work& work) const {
    Eigen::VectorXd parts(n);
    for_rows(n, cost, [&](Eigen::Index row) { parts[row] = work(row); });
    return parts.maxCoeff();
  }

 private:
  int n_threads_;
};

}  // namespace point_contact
