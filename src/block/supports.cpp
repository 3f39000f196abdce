// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/supports.hpp"

#include "system/require.hpp"

namespace block {

Supports with_sides(Support sides) {
  return {.left = sides, .right = sides};
}

void require_no_rigid_motion(const Supports& supports) {
  const auto holds = [](Support one, Support other, Support least) {
    return one >= least || other >= least;
  };
  const bool holds_x = holds(supports.left, supports.right, Support::roller) ||
                       holds(supports.bottom, supports.top, Support::clamped);
  const bool holds_z = holds(supports.bottom, supports.top, Support::roller) ||
                       holds(supports.left, supports.right, Support::clamped);
  const int n_prevented = (holds_x ? 1 : 0) + (holds_z ? 1 : 0) + (holds_x || holds_z ? 1 : 0);
  if (n_prevented < 3) {
    throw sys::InvalidQuantity("number of rigid motions the supports prevent", n_prevented,
                               "3: clamp the bottom or a side");
  }
}

}  // namespace block
