// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "course/marking/mark.hpp"

namespace course {

/// The file results.json for Gradescope, with one test for each check; hidden checks have no
/// message.
std::string gradescope_json(const Assignment& assignment, const Graded& graded);

}  // namespace course
