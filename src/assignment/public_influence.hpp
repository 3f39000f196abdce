// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/check.hpp"

namespace assignment {

/// The public checks of the influence coefficients.
course::Checks public_influence_checks();

}  // namespace assignment
