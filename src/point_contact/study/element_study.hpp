// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "point_contact/study/two_spheres.hpp"

namespace point_contact {

/// The errors of two spheres on a number of grids, so many that the edge of the contact falls
/// everywhere between nodes; a value a grid, as PressureErrors and SurfaceErrors have it.
struct ElementStudy {
  std::vector<double> elements, inside, largest, peak, radius_by_area, radius, approach;
  std::vector<double> bound;  ///< pressure_bound()

  // On the coarser grids, up to 60 nodes a side, since a place costs a term for each node in
  // contact.
  std::vector<double> surface_elements, slope, stress;
  std::vector<double> surface_bound;
};

/// The study of one element on grids of 24 to 128 nodes a side, 11 to 62 elements over the radius.
/// Cost: half a second.
ElementStudy study_element(const TwoSpheres& spheres, const elasticity::Material& material,
                           Element element);

}  // namespace point_contact
