// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/contact_m.hpp"

#include <Eigen/LU>
#include <cmath>

#include "contact/hertz.hpp"
#include "elasticity/triangular_load.hpp"

namespace paper {

// begin excerpt: contact-m
ContactM run_contact_m(const parameters::ContactCase& contact,
                       const parameters::PrintedContactM& printed) {
  const auto nn = static_cast<Eigen::Index>(printed.n_nodes.value()) - 1;
  const auto aa = static_cast<Eigen::Index>(printed.zero_node.value());
  const double c = printed.spacing.value();

  // C(i,j), the influence of one body's triangle of unit height; f = 0 at the datum
  const elasticity::TriangularLoad unit(1, c);
  const auto influence = [&](Eigen::Index k) {
    return normal_displacement(contact.body1.material, unit, static_cast<double>(k) * c,
                               contact.datum);
  };

  // B(i,j) = C(1,j) − C(i,j), h(i) = x²/(2R); from node aa on only the diagonal is left
  Eigen::MatrixXd b(nn, nn);
  Eigen::VectorXd h(nn);
  for (Eigen::Index i = 0; i < nn; ++i) {
    const bool is_zero_pressure = i + 1 >= aa;
    for (Eigen::Index j = 0; j < nn; ++j) {
      b(i, j) = is_zero_pressure && i != j ? 0 : influence(j) - influence(i - j);
    }
    h[i] = is_zero_pressure ? 0 : contact.cylinders.initial_gap(static_cast<double>(i) * c);
  }

  // The last equation: A Σp = P with A = c(aa − 2)
  b.row(0).setConstant(c * static_cast<double>(aa - 2));
  h[0] = contact.line_load;
  const Eigen::VectorXd p = b.partialPivLu().solve(h);

  const contact::Hertz twice(contact.cylinders, 2 * contact.line_load);
  ContactM result{{}, {p.begin(), p.end()}, c * p.sum(), twice.half_width(), twice.peak_pressure()};
  for (Eigen::Index i = 0; i < nn; ++i) result.x.push_back(static_cast<double>(i) * c);
  return result;
}
// end excerpt: contact-m

}  // namespace paper
