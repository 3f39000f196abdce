// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "course/marking/mark.hpp"

namespace course {

/// A page for the student, one file that a phone can show, with points, compile errors,
/// messages and `pictures` (SVG elements).
std::string feedback_html(const Assignment& assignment, const Graded& graded,
                          const std::vector<std::string>& pictures);

}  // namespace course
