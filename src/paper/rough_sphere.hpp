// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "paper/prelude.hpp"
#include "point_contact/bodies/rough_surface.hpp"
#include "point_contact/study/two_spheres.hpp"

namespace paper {

/// Registers what the section on spheres says of these spheres when one of them is rough: its
/// pressures, the greatest of them and the area in contact.
void press_rough_sphere(Document& document, const point_contact::TwoSpheres& spheres,
                        const point_contact::Roughness& roughness);

}  // namespace paper
