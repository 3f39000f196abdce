// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "line_contact/solution.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// How far a solution for two cylinders is from Hertz; relative, or over p₀.
struct HertzErrors {
  double elements;                 ///< a/c
  double inside;                   ///< root mean square of p over |x| ≤ 0.9 a
  double largest;                  ///< of p at the nodes
  double peak;                     ///< of the greatest pressure, with its sign
  double half_width_count;         ///< half-width by the nodes in contact
  double half_width_extrapolated;  ///< by p² extrapolated to zero
  double half_width_moment;        ///< by the second moment
};

/// The domain of these studies, in half-widths of Hertz.
inline constexpr double cylinder_domain = 2.2;

/// The case's cylinders solved on n_nodes over this domain.
line_contact::Solution solve_cylinders(const ContactCase& c, const Hertz& hertz,
                                       line_contact::Element element, long n_nodes);

/// The case's cylinders solved by matrix inversion on the case's nodes about Hertz's contact.
line_contact::Solution invert_cylinders(const ContactCase& c, const Hertz& hertz);

/// How many places between two nodes the edge of the contact takes at each spacing of a study.
inline constexpr int n_edge_places = 20;

/// Grids of n_nodes over this domain, the first, and over ones that are narrower by up to one
/// element of the half-width, on which the edge falls at evenly spaced places between two nodes:
/// a/c is n_nodes/cylinder_domain + k/n_places. Where the edge falls changes the errors by an order
/// of magnitude, so that a single grid tells little. Means over ten places are good; the largest
/// errors are met by many places only.
std::vector<line_contact::Grid> grids_of(const Hertz& hertz, long n_nodes,
                                         int n_places = n_edge_places);

/// The root mean square of some errors, with what their bounds leave open.
Estimate root_mean_square(const std::vector<Estimate>& errors);

HertzErrors errors_against(const Hertz& hertz, const line_contact::Solution& solution);

/// The errors at one spacing, wherever the edge of the contact lies between two nodes.
struct SpacingErrors {
  double elements = 0;              ///< a/c, the geometric mean over the grids
  std::vector<HertzErrors> errors;  ///< on each grid, in the order of the places
  // How wrong these errors may be: of the pressures, and of the half-widths by extrapolation and by
  // the second moment. A count of nodes is exact.
  double of_pressure = 0, of_edge = 0, of_moment = 0;
};

/// The errors at one spacing, on grids_of(hertz, n_nodes).
SpacingErrors errors_at_spacing(const ContactCase& c, const Hertz& hertz,
                                line_contact::Element element, long n_nodes);

/// The factor B of errors that go with B (c/a)^order: the root mean square, over the places of the
/// edge at one spacing, of error·(a/c)^order, with what `bound` leaves open.
Estimate factor_of(const SpacingErrors& at, double HertzErrors::*error, double bound, double order);

/// What a solution of elements says between and beneath its nodes, held against Hertz and McEwen.
///
/// The slope of uniform elements is infinite at their ends, so that a largest error would belong to
/// the points at which it is sought. Means over |x| ≤ 0.9 a are finite for all elements but forces.
struct ElementQuality {
  Estimate slope;  ///< mean |error| of ∂(u_z1 + u_z2)/∂x, over a/R, its value at the edge
  Estimate shear;  ///< mean |error| of τ₁ half a spacing below the surface, over p₀
};

/// By the midpoint rule on x ≥ 0, of which the other side is the image, extrapolated; wrong by the
/// difference from half as many points. The number of nodes is odd.
ElementQuality quality_of(const ContactCase& c, const Hertz& hertz,
                          const line_contact::Solution& solution);

}  // namespace paper
