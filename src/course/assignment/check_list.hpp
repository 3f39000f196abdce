// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"

namespace course {

/// The code of every check that the assignment lists. Throws config::Error with the place
/// of a listed check that no code of its visibility decides, and for code that is not listed.
Checks all_checks(const Assignment& assignment, const Checks& visible, const Checks& hidden);

}  // namespace course
