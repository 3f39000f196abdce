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

/// How many places between two nodes the edge of the contact takes on grids_of().
inline constexpr int n_edge_places = 10;

/// Grids of n_nodes over this domain, the first, and over ones that are narrower by up to one
/// element of the half-width, on which the edge falls at evenly spaced places between two nodes:
/// a/c is n_nodes/cylinder_domain + k/n_places. Where the edge falls changes the errors by an order
/// of magnitude, so that a single grid tells little. Means over ten places are good; the largest
/// errors are those just before a node comes into contact, which only many places meet.
std::vector<line_contact::Grid> grids_of(const Hertz& hertz, long n_nodes,
                                         int n_places = n_edge_places);

HertzErrors errors_against(const Hertz& hertz, const line_contact::Solution& solution);

/// The errors on a number of grids from 15 to 750 elements over the half-width, so many that the
/// edge of the contact falls everywhere between nodes.
struct ConvergenceStudy {
  std::vector<double> elements, inside, largest, peak, count, extrapolated, moment;
  // How wrong these errors may be: of the pressures, and of the half-widths by extrapolation and by
  // the second moment. A count of nodes is exact.
  std::vector<double> of_pressure, of_edge, of_moment;
};
ConvergenceStudy convergence_study(const ContactCase& c, const Hertz& hertz,
                                   line_contact::Element element);

}  // namespace paper
