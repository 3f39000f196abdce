// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts that these tests solve.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "point_contact/hertz.hpp"
#include "point_contact/problem.hpp"

namespace point_cases {

using point_contact::Element;
using point_contact::Grid;
using point_contact::Problem;
using point_contact::Profile;

inline constexpr Element elements[] = {Element::uniform, Element::pyramid};
inline constexpr double modulus = 913.7;
inline constexpr double curvature = 0.571;
inline constexpr double load = 3.461;
inline const point_contact::Hertz hertz(modulus, curvature, load);

// κ_x, κ_y of the elliptic contact, which is longest along x.
inline constexpr double curvature_x = 0.2;
inline constexpr double curvature_y = 1.1;
inline const point_contact::HertzElliptic ellipse(modulus, curvature_x, curvature_y, load);

// A measured surface: an asymmetric wavy paraboloid that touches in several regions.
inline Profile wavy_profile() {
  constexpr Eigen::Index n = 101;
  constexpr double spacing = 0.01;
  const Eigen::ArrayXXd heights =
      Eigen::ArrayXXd::NullaryExpr(n, n, [](Eigen::Index i, Eigen::Index j) {
        const double x = 0.01 * static_cast<double>(i - 50);
        const double y = 0.01 * static_cast<double>(j - 50);
        return 0.3 * (x * x + 1.3 * y * y) +
               0.006 * std::cos(40 * x + 0.4) * std::cos(35 * y - 0.3);
      });
  return Profile::height_map(heights, spacing);
}

struct Case {
  std::string name;
  Profile profile;
  double width, height;  // of the domain
};
inline const std::vector<Case> cases{
    {"spheres", Profile::paraboloid(curvature), 2.5 * hertz.radius(), 2.5 * hertz.radius()},
    {"ellipse", Profile::elliptic_paraboloid(curvature_x, curvature_y), 2.4 * ellipse.semi_axis_x(),
     2.4 * ellipse.semi_axis_y()},
    {"wavy", wavy_profile(), 0.98, 0.98}};

inline Problem problem_of(const Case& c, Eigen::Index n, Element element = Element::pyramid) {
  return {c.profile, modulus, point_contact::rectangular_grid(c.width, c.height, n), element};
}

inline Problem spheres_on(Eigen::Index n, Element element = Element::pyramid) {
  return problem_of(cases[0], n, element);
}

}  // namespace point_cases
