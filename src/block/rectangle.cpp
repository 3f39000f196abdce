// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/rectangle.hpp"

#include "numerics/require.hpp"

namespace block {

Rectangle::Rectangle(double width, double height)
    : width_(numerics::require_positive("width", width)),
      height_(numerics::require_positive("height", height)) {}

}  // namespace block
