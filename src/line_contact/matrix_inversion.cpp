// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/matrix_inversion.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "line_contact/contact_error.hpp"
#include "line_contact/contact_search.hpp"
#include "line_contact/dense_system.hpp"
#include "line_contact/free_ends.hpp"
#include "numerics/dense_lu.hpp"

namespace line_contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Indices = std::vector<Index>;

Index at(const Indices& indices, Index i) {
  return indices[static_cast<std::size_t>(i)];
}

Indices indices_of(const ContactMask& in_contact) {
  Indices contact;
  for (Index i = 0; i < in_contact.size(); ++i) {
    if (in_contact[i]) contact.push_back(i);
  }
  return contact;
}

struct State {
  VectorXd phi;
  VectorXd gap;
  double approach = 0;
};

// begin excerpt: matrix-inversion
// Solves eq. (1a) at each node i in contact, and equilibrium, as one linear system for φ and δ:
//   Σ_j T_ij φ_j + δ = h_i,  Σ_j w_j φ_j = 2P/(πE*).
State solve_for_contact(const DenseSystem& system, const Indices& contact) {
  const Index n = std::ssize(contact);
  MatrixXd matrix = MatrixXd::Ones(n + 1, n + 1);
  VectorXd right_side = VectorXd::Constant(n + 1, system.total());
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) matrix(i, j) = system.coefficient(at(contact, i), at(contact, j));
    matrix(n, j) = system.weights()[at(contact, j)];
    right_side[j] = system.initial_gap()[at(contact, j)];
  }
  matrix(n, n) = 0;
  const VectorXd unknowns = numerics::DenseLu(matrix).solve(right_side);

  State state{VectorXd::Zero(system.size()), {}, unknowns[n]};
  for (Index j = 0; j < n; ++j) state.phi[at(contact, j)] = unknowns[j];
  return state;
}

// g_i = u_z1 + u_z2 + h − δ = h_i − δ − Σ_j T_ij φ_j at every node.
VectorXd gap_of(const DenseSystem& system, const State& state, const Indices& contact) {
  VectorXd gap = system.initial_gap().array() - state.approach;
  for (Index i = 0; i < system.size(); ++i) {
    for (const Index j : contact) gap[i] -= system.coefficient(i, j) * state.phi[j];
  }
  return gap;
}
// end excerpt: matrix-inversion

}  // namespace

Solution solve_by_matrix_inversion(const Problem& problem, double line_load) {
  const DenseSystem system(problem, line_load);
  const double smallest_gap = system.rounding_of_gap();

  // Begin with every node in contact and let the tension at the ends peel off.
  ContactMask in_contact = ContactMask::Constant(system.size(), true);
  ContactSearch search;
  State state;
  Work work;
  for (bool settled = false; !settled;) {
    if (++work.solves > max_revisions) {
      throw ContactError(fmt::format("the contact did not settle in {} solves", max_revisions));
    }
    const Indices contact = indices_of(in_contact);
    state = solve_for_contact(system, contact);
    state.gap = gap_of(system, state, contact);
    settled = search.revise(in_contact, state.phi, state.gap, smallest_gap);
  }
  require_free_ends(problem, state.phi, line_load);

  const double misfit = in_contact.select(state.gap.cwiseAbs(), 0).maxCoeff();
  const double error = misfit / state.phi.maxCoeff();
  return to_solution(problem, line_load,
                     {std::move(state.phi), std::move(state.gap),
                      state.approach + system.least_gap(), error, work});
}

}  // namespace line_contact
