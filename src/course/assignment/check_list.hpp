// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"

namespace course {

/// The code of every check that the assignment lists, but of those that students' own tests decide
/// (course/marking/own_tests.hpp). Throws config::Error for a listed check,
/// with its place, that has no code of its visibility, and for code of a check that is not listed.
Checks all_checks(const Assignment& assignment, const Checks& visible, const Checks& hidden);

}  // namespace course
