// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/spheres.hpp"

#include <cmath>
#include <numbers>

#include "paper/bounds.hpp"
#include "paper/prelude.hpp"
#include "point_contact/solver/methods.hpp"

namespace paper {
namespace {

using Eigen::Index;
using point_contact::TwoSpheres;

using PointElement = point_contact::Element;
using PointSolution = point_contact::Solution;
using SphereHertz = point_contact::Hertz;

// A rough sphere, whose heights lie on a square of this side over the radius of Hertz's contact.
constexpr double rough_side = 3.2;

PointSolution solve_rough(const TwoSpheres& spheres, const point_contact::Roughness& roughness,
                          Index n) {
  constexpr Index n_heights = 129;
  const double side = rough_side * spheres.hertz().radius();
  const double spacing = side / static_cast<double>(n_heights - 1);
  Eigen::ArrayXXd gaps = rough_heights(roughness, n_heights);
  for (Index j = 0; j < n_heights; ++j) {
    for (Index i = 0; i < n_heights; ++i) {
      const double x = static_cast<double>(i) * spacing - side / 2;
      const double y = static_cast<double>(j) * spacing - side / 2;
      gaps(i, j) += spheres.relative_curvature * (x * x + y * y) / 2;
    }
  }
  return point_contact::solve_for_load(
      {point_contact::Profile::height_map(gaps, spacing), spheres.contact_modulus,
       point_contact::square_grid(side, n), PointElement::bilinear},
      spheres.load, {.tolerance = 1e-8});
}

}  // namespace

void press_rough_sphere(Document& document, const TwoSpheres& spheres,
                        const point_contact::Roughness& roughness) {
  constexpr Index n = 128;
  const SphereHertz hertz = spheres.hertz();
  const PointSolution coarse = solve_rough(spheres, roughness, n / 2);
  const PointSolution fine = solve_rough(spheres, roughness, n);
  const double share = roughness.rms / hertz.approach();
  document.value("rough.rms", Value(share, percent(0)).within(rounded(share)));
  document.value("rough.hurst", Value(roughness.hurst, exact()));
  document.value("rough.nodes", Value(n, integer()));
  // What the grid half as fine has otherwise is more than what a finer one would change.
  const auto with_error = [&](const char* key, const auto& quantity,
                              const literate::Format& format) {
    const double value = quantity(fine);
    document.value(key, Value({value, std::abs(value - quantity(coarse))}, format));
  };
  const double area = std::numbers::pi * hertz.radius() * hertz.radius();
  with_error(
      "rough.area", [&](const auto& s) { return s.contact_area() / area; }, percent(0));
  with_error(
      "rough.peak", [&](const auto& s) { return s.peak_pressure() / hertz.peak_pressure(); },
      significant(2));
}

}  // namespace paper
