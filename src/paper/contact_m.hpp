// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "parameters/case.hpp"

namespace paper {

/// What the program Contact.m of Appendix 3 computes, as it is printed (its lost signs and its
/// `Else` put right, which MATLAB would not run).
struct ContactM {
  std::vector<double> x;         ///< nodes, x ≥ 0 only
  std::vector<double> pressure;  ///< at the nodes
  double line_load;              ///< c Σp
  double hertz_half_width;       ///< by its own lines, which put 2P for P
  double hertz_peak_pressure;
};

/// Runs the printed program on the case's cylinders with the printed grid.
///
/// It differs from solve_by_matrix_inversion in this: the nodes x < 0 have no mirror images, the
/// compliance is that of body 1 alone, equilibrium weighs each pressure with c(aa − 2) instead of
/// c, the node aa where p becomes zero is typed in, and Hertz gets twice the load.
ContactM run_contact_m(const parameters::ContactCase& contact,
                       const parameters::PrintedContactM& printed);

}  // namespace paper
