// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/study/two_spheres.hpp"

#include <cmath>

namespace point_contact {

ElementStudy study_element(const TwoSpheres& spheres, const elasticity::Material& material,
                           Element element) {
  constexpr int n_grids = 14;
  constexpr double coarsest = 24;
  constexpr double finest = 128;
  constexpr Eigen::Index finest_of_surface = 60;
  ElementStudy study;
  for (int k = 0; k < n_grids; ++k) {
    const double share = k / (n_grids - 1.0);
    const Eigen::Index n = std::lround(coarsest * std::pow(finest / coarsest, share));
    const Solution solution = solve_spheres(spheres, element, n);
    const PressureErrors e = pressure_errors(spheres, solution);
    study.elements.push_back(e.elements);
    study.inside.push_back(e.inside);
    study.largest.push_back(e.largest);
    study.peak.push_back(e.peak);
    study.radius_by_area.push_back(e.radius_by_area);
    study.radius.push_back(e.radius);
    study.approach.push_back(e.approach);
    study.bound.push_back(pressure_bound(solution));
    if (n > finest_of_surface) continue;
    const SurfaceErrors s = surface_errors(spheres, material, solution);
    study.surface_elements.push_back(e.elements);
    study.slope.push_back(s.slope);
    study.stress.push_back(s.stress);
    study.surface_bound.push_back(study.bound.back());
  }
  return study;
}

}  // namespace point_contact
