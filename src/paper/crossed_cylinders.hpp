// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "paper/prelude.hpp"

namespace paper {

/// Registers what the section on spheres says of the case's cylinders, crossed at right angles
/// under a load and solved on n_nodes along a side; nothing but the flag that says so if one is a
/// plane or a hollow, or if the ellipse is so long that square cells would be needles.
void cross_cylinders(Document& document, const ContactCase& c, double load, long n_nodes);

}  // namespace paper
