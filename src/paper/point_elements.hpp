// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "paper/prelude.hpp"
#include "point_contact/study/two_spheres.hpp"

namespace paper {

/// Registers what pyramids, hats, uniform elements and forces are worth between two spheres:
/// orders and factors of their errors against Hertz and Huber, and the claims on them.
void study_elements(Document& document, const ContactCase& c,
                    const point_contact::TwoSpheres& spheres);

}  // namespace paper
