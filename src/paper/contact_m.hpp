// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "paper/conventions.hpp"
#include "paper/printed_data.hpp"

namespace paper {

/// The numbers typed into Contact.m (Appendix 3) besides those of the contact.
struct ContactMInput {
  Eigen::Index n_nodes;    ///< nn = n − 1: nodes 1, 2, … at x = 0, c, …
  double spacing;          ///< c, a length
  Eigen::Index zero_node;  ///< aa, «node where p becomes zero», counted from 1; at least 3
  double step;             ///< offset by which it avoids the points 0 and ±c of eq. (3), a length
};

/// The paper's input of Contact.m, with the step of Tri_dist.m.
ContactMInput as_printed(const PrintedData& printed);

/// The defects of the program to repair; none in the printed state.
struct ContactMRepairs {
  bool limits = false;                 ///< eq. (3)'s limits at 0 and ±c instead of an offset
  bool mirror_images = false;          ///< the pressures at x < 0 act on the nodes x ≥ 0
  bool both_bodies = false;            ///< u_z1 + u_z2, not u_z1 alone
  bool weight_of_equilibrium = false;  ///< each triangle carries c p, not c (aa − 2) p
  bool free_edge = false;              ///< aa found by p ≥ 0, not typed
  bool hertz_load = false;             ///< P in the lines for Hertz, not 2P
};

/// The results of Contact.m.
struct ContactM {
  std::vector<double> x;         ///< nodes, x ≥ 0 only
  std::vector<double> pressure;  ///< at the nodes
  bool has_mirror_images;        ///< whether the pressures act at −x as well
  Eigen::Index zero_node;        ///< aa, typed or found
  double line_load;              ///< carried by the triangles and their mirror images
  double gap_at_edge;            ///< eq. (1b) at node aa, a length: negative if the bodies overlap
  double hertz_half_width;       ///< from the program's own lines
  double hertz_peak_pressure;
};

/// Runs Contact.m on the case's cylinders. Signs lost in print are restored, as is the `Else` that
/// MATLAB would reject; `mended` selects the other repairs.
///
/// With every repair it equals solve_by_matrix_inversion on the grid that includes x < 0. Throws
/// contact::ContactError if aa, typed or found, is not from 3 to nn.
ContactM run_contact_m(const ContactCase& contact, const ContactMInput& input,
                       const ContactMRepairs& mended = {});

}  // namespace paper
