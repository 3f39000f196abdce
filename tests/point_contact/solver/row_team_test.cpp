// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/row_team.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>

#include "random_inputs.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(row_team_test)

using Eigen::Index;
using Eigen::VectorXd;
using point_contact::RowTeam;

namespace {

constexpr double dear = 1e9;  // a cost worth any number of threads
constexpr double cheap = 1;

}  // namespace

BOOST_AUTO_TEST_CASE(each_row_is_done_once) {
  for (const int n_threads : {1, 2, 7}) {
    for (const Index n : {1, 2, 5, 100}) {
      VectorXd times = VectorXd::Zero(n);
      RowTeam(n_threads).for_rows(n, dear, [&](Index row) { times[row] += 1; });
      BOOST_TEST((times.array() == 1).all());
    }
  }
}

BOOST_AUTO_TEST_CASE(sums_have_the_same_bytes_whatever_the_number_of_threads) {
  RandomInputs random(5);
  const VectorXd values = VectorXd::NullaryExpr(
      1000, [&](Index) { return random.sign() * random.log_uniform(1e-9, 1e9); });
  const auto row = [&](Index i) { return values[i]; };
  const double one = RowTeam(1).sum(1000, dear, row);
  for (const int n_threads : {2, 3, 8}) {
    BOOST_TEST(RowTeam(n_threads).sum(1000, dear, row) == one);
    BOOST_TEST(RowTeam(n_threads).max(1000, dear, row) == values.maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(stretches_are_numbered_by_threads_and_short_work_stays_in_one) {
  VectorXd thread_of = VectorXd::Zero(90);
  const auto note = [&](Index begin, Index end, int thread) {
    for (Index i = begin; i < end; ++i) thread_of[i] = thread;
  };
  RowTeam(3).for_stretches(90, dear, note);
  BOOST_TEST(thread_of[0] == 0);
  BOOST_TEST(thread_of[45] == 1);
  BOOST_TEST(thread_of[89] == 2);

  RowTeam(3).for_stretches(90, cheap, note);
  BOOST_TEST((thread_of.array() == 0).all());
}

BOOST_AUTO_TEST_CASE(what_a_row_throws_arrives) {
  const auto fail = [](Index row) {
    if (row >= 40) throw std::runtime_error(row < 75 ? "early" : "late");
  };
  for (const int n_threads : {1, 2, 4}) {
    BOOST_CHECK_EXCEPTION(
        RowTeam(n_threads).for_rows(100, dear, fail), std::runtime_error,
        [](const std::runtime_error& error) { return error.what() == std::string("early"); });
  }
}

BOOST_AUTO_TEST_CASE(a_team_has_a_member) {
  BOOST_CHECK_THROW(RowTeam(0), sys::InvalidQuantity);
  BOOST_TEST(RowTeam(1000).n_threads() == 64);
}

BOOST_AUTO_TEST_SUITE_END()
