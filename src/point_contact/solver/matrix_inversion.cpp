// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/matrix_inversion.hpp"

#include <fmt/core.h>

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "line_contact/contact_error.hpp"
#include "line_contact/contact_search.hpp"
#include "numerics/dense_lu.hpp"
#include "point_contact/solver/fft_solver.hpp"
#include "point_contact/solver/size_of.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using line_contact::ContactError;
using line_contact::ContactMask;
using Indices = std::vector<Index>;

MatrixXd influence_matrix(const Problem& problem) {
  const Grid& grid = problem.grid;
  const ElementPotential element(problem.element, grid.lattice);
  MatrixXd matrix(grid.size(), grid.size());
  for (Index column = 0; column < grid.size(); ++column) {
    const Index j = column / grid.n1;
    for (Index row = 0; row < grid.size(); ++row) {
      const Index rows = row / grid.n1 - j;
      const Index i = row % grid.n1 - grid.neighbour(column % grid.n1, j, 0, rows);
      matrix(row, column) =
          element(element.node(static_cast<double>(i), static_cast<double>(rows)));
    }
  }
  return matrix;
}

Indices indices_of(const ContactMask& in_contact) {
  Indices contact;
  for (Index i = 0; i < in_contact.size(); ++i) {
    if (in_contact[i]) contact.push_back(i);
  }
  return contact;
}

// T φ − δ = −h at each node in contact, and equilibrium, as one linear system. Loops, since Eigen's
// expressions with lists of indices take seconds to compile.
ElementLoads solve_for_contact(const MatrixXd& influence, const VectorXd& gaps, double total,
                               const Indices& contact) {
  const Index n = std::ssize(contact);
  MatrixXd matrix = MatrixXd::Ones(n + 1, n + 1);
  VectorXd right_side(n + 1);
  for (Index k = 0; k < n; ++k) {
    const Index column = contact[size_of(k)];
    for (Index i = 0; i < n; ++i) matrix(i, k) = influence(contact[size_of(i)], column);
    matrix(k, n) = -1;
    right_side[k] = -gaps[column];
  }
  matrix(n, n) = 0;
  right_side[n] = total;
  const VectorXd unknowns = numerics::DenseLu(matrix).solve(right_side);

  ElementLoads loads;
  loads.phi = VectorXd::Zero(gaps.size());
  loads.approach = unknowns[n];
  for (Index k = 0; k < n; ++k) loads.phi[contact[size_of(k)]] = unknowns[k];
  loads.gap = (influence * loads.phi + gaps).array() - loads.approach;
  return loads;
}

}  // namespace

Solution solve_by_matrix_inversion(const Problem& problem, double load) {
  const double total = total_phi(problem, load);
  if (problem.grid.size() > max_dense_nodes) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(problem.grid.size()),
                               fmt::format("{} at most for matrix inversion", max_dense_nodes));
  }
  const VectorXd gaps = initial_gaps(problem, RowTeam(1));
  const MatrixXd influence = influence_matrix(problem);
  // What rounding leaves of a gap in contact, a sum of displacements.
  const double smallest_gap = 1e-15 * total * influence(0, 0);

  ContactMask in_contact = gaps.array() < largest_length;
  line_contact::ContactSearch search;
  ElementLoads loads;
  int revisions = 0;
  for (bool settled = false; !settled;) {
    if (++revisions > line_contact::max_revisions) {
      throw ContactError(
          fmt::format("the contact did not settle in {} solves", line_contact::max_revisions));
    }
    loads = solve_for_contact(influence, gaps, total, indices_of(in_contact));
    settled = search.revise(in_contact, loads.phi, loads.gap, smallest_gap);
  }
  require_free_ends(problem, loads.phi, Control::load, load);

  const double misfit = in_contact.select(loads.gap.cwiseAbs(), 0).maxCoeff();
  loads.error = misfit / loads.phi.maxCoeff();
  loads.work.revisions = revisions;
  return to_solution(problem, load, std::move(loads));
}

}  // namespace point_contact
