// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/rectangle.hpp"

#include "system/require.hpp"

namespace block {

Rectangle::Rectangle(double width, double height)
    : width_(sys::require_positive("width", width)),
      height_(sys::require_positive("height", height)) {}

MassProperties mass_properties(const Rectangle& block, double density) {
  sys::require_positive("density", density);
  const double mass = density * block.width() * block.height();
  const double centre_y = -block.height() / 2;
  const double ixx = mass * block.height() * block.height() / 12;
  const double iyy = mass * block.width() * block.width() / 12;
  const double steiner = mass * centre_y * centre_y;
  return {mass, centre_y, {ixx + steiner, iyy, ixx + steiner + iyy}, {ixx, iyy, ixx + iyy}};
}

Supports with_sides(Support sides) {
  return {.left = sides, .right = sides};
}

}  // namespace block
