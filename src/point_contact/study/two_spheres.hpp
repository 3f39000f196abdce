// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "elasticity/material.hpp"
#include "point_contact/closed_forms/spheres.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// Two spheres pressed together, for which Hertz and Huber have the answers.
struct TwoSpheres {
  double contact_modulus;     ///< E*, a stress
  double relative_curvature;  ///< κ = 1/R₁ + 1/R₂
  double load;                ///< P, a force

  Hertz hertz() const { return {contact_modulus, relative_curvature, load}; }
};

/// The spheres by elements on a grid of n nodes along each side of a square of 2a/0.9: a lattice of
/// equilateral triangles for pyramids, else one of squares. With `more`, from 0 to 1, as many nodes
/// lie on a narrower square, with so many more spacings over the radius. The pressures are right to
/// 1e-11 of their peak. Throws what solve_for_load() throws.
Solution solve_spheres(const TwoSpheres& spheres, Element element, Eigen::Index n, double more = 0);

/// How far a solution is from Hertz; relative, or over p₀.
struct PressureErrors {
  double elements;  ///< a/c, c = √(a cell's area)
  double inside;    ///< root mean square of p over the nodes r ≤ 0.8 a
  double largest;   ///< of p at the nodes
  double peak;      ///< of the greatest pressure, with its sign, as the next three
  double radius_by_area;
  double radius;  ///< by the second moments
  double approach;
};
PressureErrors pressure_errors(const TwoSpheres& spheres, const Solution& solution);

/// How far a solution is from Hertz and Huber between its nodes: at eight places within
/// r ≤ 0.8 a that are spread evenly, each an eighth and three eighths of the spacing away from a
/// node, where no element's gradient is infinite.
struct SurfaceErrors {
  double slope;   ///< root mean square of |∇(u_z1 + u_z2) + κx|, over κa, its value at the edge
  double stress;  ///< the same of |σ − σ of Huber|, all components, at the depth c/2, over p₀
};
SurfaceErrors surface_errors(const TwoSpheres& spheres, const elasticity::Material& material,
                             const Solution& solution);

/// How wrong the nodal pressures may be as the solution of the discrete equations, over their peak:
/// four times what the method's residual stands for, and rounding that the residual does not see.
double pressure_bound(const Solution& solution);

/// How many places between two nodes the edge of the contact takes at each spacing of a study.
inline constexpr int n_study_places = 8;

/// The errors of two spheres at a number of spacings; each is the root mean square over the grids
/// on which the radius has 0, 1/8, … 7/8 of a spacing more, of an error as PressureErrors and
/// SurfaceErrors have it.
struct ElementStudy {
  std::vector<double> elements;  ///< a/c, the geometric mean over the grids
  std::vector<double> inside, largest, peak, radius_by_area, radius, approach;
  std::vector<double> slope, stress;
  std::vector<double> bound;  ///< the greatest pressure_bound()
};

/// The study of one element on grids of 36 to 102 nodes a side, 16 to 47 elements over the radius.
/// Cost: a second.
ElementStudy study_element(const TwoSpheres& spheres, const elasticity::Material& material,
                           Element element);

}  // namespace point_contact
