// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/reference_methods.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "contact/contact_search.hpp"
#include "numerics/fit.hpp"

namespace contact {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Indices = std::vector<Index>;
using Influence = std::function<double(Index, Index)>;

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

// Solves eq. (1a) at each node i in contact, and equilibrium, as one linear system for φ and δ:
//   Σ_j T_ij φ_j + δ = h_i,  Σ_j φ_j = 2P/(πE*).
ContactLoads solve_for_contact(const Equations& equations, const Influence& influence,
                               const Indices& contact) {
  const Index n = std::ssize(contact);
  MatrixXd matrix = MatrixXd::Ones(n + 1, n + 1);
  VectorXd right_side = VectorXd::Constant(n + 1, equations.total);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) matrix(i, j) = influence(at(contact, i), at(contact, j));
    right_side[j] = equations.initial_gap[at(contact, j)];
  }
  matrix(n, n) = 0;
  const VectorXd unknowns = numerics::solve(matrix, right_side);

  ContactLoads loads{VectorXd::Zero(equations.initial_gap.size()), {}, unknowns[n]};
  for (Index j = 0; j < n; ++j) loads.phi[at(contact, j)] = unknowns[j];
  return loads;
}

// g_i = u_z1 + u_z2 + h − δ = h_i − δ − Σ_j T_ij φ_j at every node.
VectorXd gap_of(const Equations& equations, const Influence& influence, const ContactLoads& loads,
                const Indices& contact) {
  VectorXd gap = equations.initial_gap.array() - loads.approach;
  for (const Index j : contact) {
    for (Index i = 0; i < gap.size(); ++i) gap[i] -= influence(i, j) * loads.phi[j];
  }
  return gap;
}

double misfit_of(const ContactLoads& loads) {
  return (loads.phi.array() > 0).select(loads.gap.array().abs(), 0).maxCoeff();
}

}  // namespace

ContactLoads invert(const Equations& equations, const Influence& influence) {
  ContactMask in_contact = ContactMask::Constant(equations.initial_gap.size(), true);
  ContactSearch search;
  ContactLoads loads;
  int solves = 0;
  for (bool settled = false; !settled;) {
    if (++solves > max_revisions) {
      throw ContactError(fmt::format("the contact did not settle in {} solves", max_revisions));
    }
    const Indices contact = indices_of(in_contact);
    loads = solve_for_contact(equations, influence, contact);
    loads.gap = gap_of(equations, influence, loads, contact);
    settled = search.revise(in_contact, loads.phi, loads.gap, equations.smallest_gap);
  }
  loads.misfit = in_contact.select(loads.gap.cwiseAbs(), 0).maxCoeff();
  loads.solves = solves;
  return loads;
}

// Steps along conjugate directions over the loaded nodes. After each step, nodes in tension are set
// to zero, unloaded nodes that penetrate are loaded, and the total load is restored.
ContactLoads minimise(const Equations& equations,
                      const std::function<void(const VectorXd& phi, VectorXd& u)>& displace,
                      double tolerance, int max_products) {
  const auto& [initial_gap, total, smallest_gap] = equations;
  ContactLoads loads;
  VectorXd& phi = loads.phi;
  VectorXd& gap = loads.gap;
  const auto n = static_cast<double>(initial_gap.size());
  phi = VectorXd::Constant(initial_gap.size(), total / n);
  VectorXd direction = VectorXd::Zero(phi.size());
  VectorXd change(phi.size());
  double previous = 1;
  bool is_conjugate = false;
  for (int products = 1; products < max_products; products += 2) {
    // Compute the gap, the gradient of the energy: g = h − δ − Tφ, ⟨g⟩ = 0 where φ > 0
    displace(phi, gap);
    gap += initial_gap;
    const ArrayXd carrying = (phi.array() > 0).cast<double>();  // 1 where φ > 0, else 0
    const double n_carrying = carrying.sum();
    loads.approach = (carrying * gap.array()).sum() / n_carrying;
    gap.array() -= loads.approach;

    const double misfit = (carrying > 0).select(gap.array().abs(), -gap.array()).maxCoeff();
    if (misfit <= std::max(smallest_gap, tolerance * phi.maxCoeff())) {
      loads.misfit = misfit_of(loads);
      loads.products = products;
      return loads;
    }

    // Step along the next conjugate direction, then remove tension
    const double square = (carrying * gap.array().square()).sum();   // ρ = (g, g)
    const double factor = is_conjugate ? square / previous : 0;      // β = ρ / ρ_old
    direction = (carrying > 0).select(gap + factor * direction, 0);  // d = g + β d
    previous = square;
    displace(direction, change);
    change.array() -= (carrying * change.array()).sum() / n_carrying;  // q = −T d − ⟨−T d⟩
    const double step = direction.dot(gap) / direction.dot(change);    // α = (d, g) / (d, q)
    phi = (phi - step * direction).cwiseMax(0);                        // φ = max(φ − α d, 0)

    // Load the nodes that penetrate, φ = −α g; the directions then start afresh
    is_conjugate = true;
    for (Index i = 0; i < phi.size(); ++i) {
      if (phi[i] > 0 || gap[i] >= 0) continue;
      phi[i] = -step * gap[i];
      is_conjugate = false;
    }
    phi *= total / phi.sum();  // Σ φ = 2P/(πE*)
  }
  throw ContactError(
      fmt::format("the variational method did not reach its minimum in {} products", max_products));
}

}  // namespace contact
