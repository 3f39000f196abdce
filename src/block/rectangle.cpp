// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/rectangle.hpp"

#include "system/require.hpp"

namespace block {

Rectangle::Rectangle(double width, double height)
    : width_(sys::require_positive("width", width)),
      height_(sys::require_positive("height", height)) {}

}  // namespace block
