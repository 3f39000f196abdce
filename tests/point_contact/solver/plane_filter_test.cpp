// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/plane_filter.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "random_inputs.hpp"

BOOST_AUTO_TEST_SUITE(plane_filter_test)

using Eigen::Index;
using Eigen::VectorXd;
using point_contact::PlaneFilter;
using point_contact::RowTeam;

namespace {

using Complex = std::complex<double>;

VectorXd random_field(Index size) {
  RandomInputs random(2385);
  return VectorXd::NullaryExpr(size, [&](Index) { return random.uniform(-1, 1); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_filter_that_changes_nothing_returns_the_field) {
  for (const auto& [n1, n2] : {std::pair<Index, Index>{5, 7}, {8, 8}, {13, 4}}) {
    const VectorXd field = random_field(n1 * n2);
    VectorXd result;
    PlaneFilter filter(n1, n2, 16, 16);
    filter.apply(
        field, result,
        [](Index, std::span<Complex> column) {
          for (Complex& z : column) z /= 256;
        },
        RowTeam(1));
    BOOST_TEST((result - field).cwiseAbs().maxCoeff() < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(a_filter_of_phases_moves_the_field) {
  // exp(−2πi(2k1/12 + 3k2/10)): by two nodes along the rows and three along the columns.
  const Index n1 = 9;
  const Index n2 = 7;
  VectorXd field = VectorXd::Zero(n1 * n2);
  field[1 * n1 + 4] = 2.385;
  const auto turn = [](Index k1, std::span<Complex> column) {
    for (std::size_t k2 = 0; k2 < column.size(); ++k2) {
      const double turns = 2 * static_cast<double>(k1) / 12 + 3 * static_cast<double>(k2) / 10;
      column[k2] *= std::polar(1.0 / 120, -2 * std::numbers::pi * turns);
    }
  };
  VectorXd result;
  PlaneFilter(n1, n2, 12, 10).apply(field, result, turn, RowTeam(1));
  VectorXd moved = VectorXd::Zero(n1 * n2);
  moved[4 * n1 + 6] = 2.385;

  BOOST_TEST((result - moved).cwiseAbs().maxCoeff() < 1e-14);
}

BOOST_AUTO_TEST_CASE(two_threads_give_the_same_bytes) {
  const Index n = 200;
  const VectorXd field = random_field(n * n);
  const auto damp = [](Index k1, std::span<Complex> column) {
    for (std::size_t k2 = 0; k2 < column.size(); ++k2) {
      column[k2] /= 1 + static_cast<double>(k1) + static_cast<double>(k2);
    }
  };
  PlaneFilter filter(n, n, 2 * n, 2 * n);
  VectorXd one, two;
  filter.apply(field, one, damp, RowTeam(1));
  filter.apply(field, two, damp, RowTeam(2));

  BOOST_TEST((one.array() == two.array()).all());
}

BOOST_AUTO_TEST_SUITE_END()
