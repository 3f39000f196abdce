// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/check.hpp"

namespace assignment {

/// The hidden checks of the influence coefficients and of the contact of two cylinders.
course::Checks hidden_contact_checks();

}  // namespace assignment
