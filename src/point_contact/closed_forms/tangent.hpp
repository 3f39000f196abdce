// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace point_contact {

/// w − arctan w for w ≥ 0 without cancellation: 5e-16 relative. With w = tan t, tan t − t.
double excess_over_arctangent(double w);

}  // namespace point_contact
