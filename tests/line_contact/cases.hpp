// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts that these tests solve.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "line_contact/cylinders.hpp"
#include "line_contact/problem.hpp"

namespace line_cases {

using line_contact::Element;
using line_contact::Problem;
using line_contact::Profile;

inline constexpr Element elements[] = {Element::point, Element::uniform, Element::triangular};
inline constexpr double modulus = 913.7;
inline constexpr double load = 3.461;
inline constexpr double curvature = 0.571;

// E* of two bodies with the same E = 2(1 − 0.09)E*, one of them flat.
inline const line_contact::CylinderPair cylinders(elasticity::Material(2 * 0.91 * modulus, 0.3),
                                                  line_contact::Radius::of_cylinder("radius1",
                                                                                    1 / curvature),
                                                  elasticity::Material(2 * 0.91 * modulus, 0.3),
                                                  line_contact::Radius::of_plane());
inline const line_contact::Hertz hertz(cylinders, load);

// A wavy parabola, its lowest point off the centre, tabulated at 120 points from −0.4 to 0.5:
// contact in several regions.
inline Profile wavy_profile(double above = 0) {
  std::vector<double> x, gap;
  for (int i = 0; i < 120; ++i) {
    const double at = -0.4 + 0.9 * i / 119;
    x.push_back(at);
    gap.push_back(above + 0.3 * (at - 0.03) * (at - 0.03) + 0.004 * std::cos(71 * at + 0.4));
  }
  return Profile::tabulated(x, gap);
}

// Faces that rise steeply beside a flat end: gaps of 1e4 half-widths at the ends of the grid.
inline Profile steep_profile() {
  return Profile::tabulated({-1, -0.11, -0.1, 0.1, 0.11, 1}, {1e3, 1e-2, 0, 0, 1e-2, 1e3});
}

struct Case {
  std::string name;
  Profile profile;
  double width;  // of the domain
  double centre = 0;
};

// Domains a fifth to a half wider than the contact.
inline const std::vector<Case> cases{
    {"cylinders", Profile::parabola(curvature), 2.385 * hertz.half_width()},
    {"wavy", wavy_profile(), 0.81, 0.07},
    {"steep", steep_profile(), 0.31}};

inline Problem problem_of(const Case& c, Eigen::Index n_nodes,
                          Element element = Element::triangular) {
  return {c.profile, modulus, line_contact::grid_of_width(c.width, n_nodes, c.centre), element};
}

inline Problem cylinders_on(Eigen::Index n_nodes, Element element = Element::triangular) {
  return problem_of(cases[0], n_nodes, element);
}

}  // namespace line_cases
