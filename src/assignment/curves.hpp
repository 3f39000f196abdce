// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "course/assignment/check.hpp"
#include "course/assignment/variant.hpp"
#include "course/marking/feedback_picture.hpp"

namespace assignment {

/// What the feedback page draws: the student's own slope, displacement and contact pressure, how
/// far their eqs. (2) and (3) are apart, and what gap their contact leaves. An exercise without an
/// answer has no curve. Throws ToolError.
std::vector<course::Curve> curves(const course::Program& program, const course::Variant& variant);

}  // namespace assignment
