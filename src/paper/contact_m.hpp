// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "paper/prelude.hpp"
#include "paper/printed_data.hpp"

namespace paper {

/// The numbers typed into Contact.m (Appendix 3) that are not the contact's own.
struct ContactMInput {
  Eigen::Index n_nodes;    ///< nn = n − 1: nodes 1, 2, … at x = 0, c, …
  double spacing;          ///< c, a length
  Eigen::Index zero_node;  ///< aa, «node where p becomes zero», counted from 1; at least 3
  double step;             ///< how far it steps off the points 0 and ±c of eq. (3), a length
};

/// What Contact.m is given in the paper; its step is that of Tri_dist.m.
ContactMInput as_printed(const PrintedData& printed);

/// Which of the program's defects are mended; none as it is printed.
struct ContactMRepairs {
  bool limits = false;         ///< eq. (3)'s limits at 0 and ±c, in place of a step off them
  bool mirror_images = false;  ///< the pressures at x < 0 act on the nodes x ≥ 0
  bool both_bodies = false;    ///< u_z1 + u_z2, not u_z1 alone
  bool weight_of_equilibrium = false;  ///< each triangle carries c p, not c (aa − 2) p
  bool free_edge = false;              ///< aa found by p ≥ 0, not typed
  bool hertz_load = false;             ///< P in the lines for Hertz, not 2P
};

/// What Contact.m computes.
struct ContactM {
  std::vector<double> x;         ///< nodes, x ≥ 0 only
  std::vector<double> pressure;  ///< at the nodes
  bool has_mirror_images;        ///< whether the pressures act at −x as well
  Eigen::Index zero_node;        ///< aa, typed or found
  double line_load;              ///< what the triangles carry, mirror images counted
  double gap_at_edge;            ///< eq. (1b) at node aa, a length: negative if the bodies overlap
  double hertz_half_width;       ///< by the program's own lines
  double hertz_peak_pressure;
};

/// Runs Contact.m on the case's cylinders. Its lost signs are put right, and its `Else`, which
/// MATLAB would not run; its other defects as far as `mended` says.
///
/// With every repair it is solve_by_matrix_inversion on the grid that has their images, too. Throws
/// contact::ContactError when aa, typed or found, is not 3 to nn.
ContactM run_contact_m(const ContactCase& contact, const ContactMInput& input,
                       const ContactMRepairs& mended = {});

}  // namespace paper
