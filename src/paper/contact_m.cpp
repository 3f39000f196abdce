// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/contact_m.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "contact/contact_search.hpp"
#include "elasticity/loads.hpp"
#include "numerics/fit.hpp"
#include "paper/conventions.hpp"

namespace paper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The node where the pressure becomes zero, counted from 1, must leave two in contact.
Index require_edge_within(Index n_nodes, Index zero_node) {
  if (zero_node >= 3 && zero_node <= n_nodes) return zero_node;
  throw contact::ContactError(
      fmt::format("the pressure of Contact.m becomes zero at node {}: must be from 3 to {}",
                  zero_node, n_nodes));
}

Index first_in_tension(const VectorXd& p) {
  const auto first = std::find_if(p.begin(), p.end(), [](double p_i) { return p_i < 0; });
  return require_edge_within(p.size(), first - p.begin() + 1);
}

ContactM to_result(double c, const VectorXd& sides, const VectorXd& p, Index aa, double gap,
                   const Hertz& hertz) {
  ContactM result{.x = {},
                  .pressure = {p.begin(), p.end()},
                  .has_mirror_images = sides[1] > 1,
                  .zero_node = aa,
                  .line_load = c * sides.dot(p),
                  .gap_at_edge = gap,
                  .hertz_half_width = hertz.half_width(),
                  .hertz_peak_pressure = hertz.peak_pressure()};
  for (Index i = 0; i < p.size(); ++i) result.x.push_back(static_cast<double>(i) * c);
  return result;
}

}  // namespace

ContactMInput as_printed(const PrintedData& printed) {
  const PrintedContactM& listed = printed.contact_m;
  return {static_cast<Index>(listed.n_nodes.value()) - 1, listed.spacing.value(),
          static_cast<Index>(listed.zero_node.value()), printed.tri_dist.step.value()};
}

ContactM run_contact_m(const ContactCase& contact, const ContactMInput& input,
                       const ContactMRepairs& mended) {
  const Index nn = input.n_nodes;
  const double c = input.spacing;
  VectorXd sides = VectorXd::Constant(nn, mended.mirror_images ? 2 : 1);  // repair 2
  sides[0] = 1;

  // f: the displacement k nodes from a triangle of unit height; C(i,j): at node i due to node j
  const elasticity::TriangularLoad unit(1, c);
  const auto f = [&](Index k) {
    double x = static_cast<double>(k) * c;
    if (std::abs(k) <= 1 && !mended.limits) x += input.step;  // repair 1
    const double u1 = normal_displacement(contact.body1.material, unit, x, contact.datum);
    if (!mended.both_bodies) return u1;  // repair 3
    return u1 + normal_displacement(contact.body2.material, unit, x, contact.datum);
  };
  const MatrixXd influence = MatrixXd::NullaryExpr(
      nn, nn, [&](Index i, Index j) { return f(i - j) + (sides[j] > 1 ? f(i + j) : 0); });

  // B(i,j) = C(1,j) − C(i,j), h(i) = x²/(2R); from node aa on, p = 0; finally row 1 is A Σp = P
  const auto pressure_up_to = [&](Index aa) -> VectorXd {
    MatrixXd b = influence.row(0).replicate(nn, 1) - influence;
    VectorXd h(nn);
    for (Index i = 0; i < nn; ++i) {
      h[i] = i + 1 < aa ? contact.cylinders.profile().gap(static_cast<double>(i) * c) : 0;
      if (i + 1 >= aa) b.row(i) = b(i, i) * VectorXd::Unit(nn, i);
    }
    b.row(0).setConstant(c * static_cast<double>(aa - 2));
    if (mended.weight_of_equilibrium) b.row(0) = c * sides;  // repair 4
    h[0] = contact.line_load;
    return numerics::solve(b, h);
  };
  Index aa = mended.free_edge ? nn + 1 : input.zero_node;
  VectorXd p = pressure_up_to(aa);
  while (mended.free_edge && p.minCoeff() < 0) {  // repair 5
    p = pressure_up_to(aa = first_in_tension(p));
  }
  const double times = mended.hertz_load ? 1 : 2;  // repair 6
  const Hertz hertz(contact.cylinders, times * contact.line_load);
  require_edge_within(nn, aa);
  const double gap = (influence.row(aa - 1) - influence.row(0)).dot(p) +
                     contact.cylinders.profile().gap(static_cast<double>(aa - 1) * c);
  return to_result(c, sides, p, aa, gap, hertz);
}

}  // namespace paper
