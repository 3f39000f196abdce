// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/variant.hpp"

namespace assignment {

/// Whether the theory holds for a variant: the contact is small beside the radii, the load is not
/// so small that rounding shows, the grid reaches beyond the contact.
bool is_valid(const course::Variant& variant);

}  // namespace assignment
