// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/lattice.hpp"

#include <cmath>

#include "system/require.hpp"

namespace point_contact {

Lattice square_lattice(double spacing) {
  sys::require_positive("spacing", spacing);
  return {{spacing, 0}, {0, spacing}};
}

Lattice hexagonal_lattice(double spacing) {
  sys::require_positive("spacing", spacing);
  return {{spacing, 0}, {spacing / 2, std::sqrt(3.0) / 2 * spacing}};
}

}  // namespace point_contact
