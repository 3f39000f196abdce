// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>

namespace block {

/// How one side of the block is held.
enum class Support {
  free,    ///< no traction
  roller,  ///< no normal displacement, no shear
  clamped  ///< no displacement
};

/// How the block is held on its four sides; the bottom is clamped and the top free by default.
struct Supports {
  Support left = Support::free;
  Support right = Support::free;
  Support bottom = Support::clamped;
  Support top = Support::free;

  friend auto operator<=>(const Supports&, const Supports&) = default;
};

/// The block held alike on its left and right, with the bottom clamped: the cases of the report.
Supports with_sides(Support sides);

/// Throws InvalidQuantity unless the supports prevent all three rigid motions.
///
/// Any side that is held prevents the rotation, since a line stays in place. A translation can be
/// left: that along x if left and right are free and neither bottom nor top is clamped, and
/// likewise that along z.
void require_no_rigid_motion(const Supports& supports);

}  // namespace block
