// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/element_field.hpp"

#include <vector>

#include "contact/contact_search.hpp"
#include "system/require.hpp"

namespace line_contact {

elasticity::PiecewiseLinearTraction traction_on(const Solution& solution,
                                                const Eigen::VectorXd& shear) {
  const Grid& grid = solution.grid;
  if (solution.element != Element::triangular) {
    throw sys::InvalidQuantity("elements' width", grid.spacing,
                               "of triangular elements: beneath others stress jumps");
  }
  if (grid.is_one_sided && shear.size() > 0) {
    throw sys::InvalidQuantity("one-sided grid's end", grid.end(),
                               "only without friction, which is not symmetric");
  }
  Eigen::Index first = 0;
  Eigen::Index last = grid.n_nodes - 1;
  const auto carries = [&](Eigen::Index i) { return solution.pressure[i] > 0; };
  if (solution.n_in_contact() == 0) throw contact::ContactError("nothing is in contact");
  if (!grid.is_one_sided) {
    while (!carries(first + 1)) ++first;
  }
  while (!carries(last - 1)) --last;

  std::vector<double> nodes;
  std::vector<double> pressure;
  std::vector<double> tangential;
  for (Eigen::Index i = last; grid.is_one_sided && i > 0; --i) {
    nodes.push_back(-grid.x(i));
    pressure.push_back(solution.pressure[i]);
  }
  for (Eigen::Index i = first; i <= last; ++i) {
    nodes.push_back(grid.x(i));
    pressure.push_back(solution.pressure[i]);
    if (shear.size() > 0) tangential.push_back(shear[i]);
  }
  return elasticity::PiecewiseLinearTraction(nodes, pressure, tangential);
}

}  // namespace line_contact
