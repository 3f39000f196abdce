// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/friction.hpp"

#include "line_contact/dense_methods.hpp"
#include "paper/prelude.hpp"

namespace paper {

Pair pair_of(const ContactCase& c, const elasticity::Material& first,
             const elasticity::Material& second) {
  const line_contact::CylinderPair cylinders(first, c.body1.radius, second, c.body2.radius);
  const double load = c.line_load * cylinders.contact_modulus() / c.cylinders.contact_modulus();
  const Hertz hertz(cylinders, load);
  const line_contact::Problem problem{cylinders.profile(), cylinders.contact_modulus(),
                                      line_contact::grid_around(hertz.half_width(), c.n_nodes)};
  return {cylinders,
          load,
          hertz,
          problem,
          line_contact::solve_by_matrix_inversion(problem, load),
          elasticity::dundurs_beta(first, second)};
}

}  // namespace paper
