// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "block/element_stiffness.hpp"

namespace block {

/// Strains in the plane; γ is the engineering shear ∂u_x/∂z + ∂u_z/∂x. All others vanish.
struct Strain {
  double xx;
  double zz;
  double gamma;
};

/// Stresses in plane strain, tension positive: three in the plane x, z (z into the body), and σ_yy
/// out of it.
struct Stress {
  double xx;
  double zz;
  double xz;
  double yy;
};

/// Hooke's law in plane strain: σ_xx = λ(ε_xx + ε_zz) + 2με_xx, σ_zz alike, σ_xz = μγ and
/// σ_yy = λ(ε_xx + ε_zz) = ν(σ_xx + σ_zz).
Stress stress(const Lame& lame, const Strain& strain);

/// von Mises's √{½[(σ_xx−σ_zz)² + (σ_zz−σ_yy)² + (σ_yy−σ_xx)²] + 3σ_xz²}, a stress ≥ 0.
double von_mises(const Stress& stress);

/// The three principal stresses, the largest first; one of them is σ_yy.
std::array<double, 3> principal_stresses(const Stress& stress);

}  // namespace block
