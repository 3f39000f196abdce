// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/check.hpp"

namespace assignment {

/// The public checks of the slope by eq. (3), of that by eq. (2), and of the displacement.
course::Checks public_surface_checks();

}  // namespace assignment
