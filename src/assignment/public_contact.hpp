// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/check.hpp"

namespace assignment {

/// The public checks of the contact of two cylinders.
course::Checks public_contact_checks();

}  // namespace assignment
