// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "course/assignment/check.hpp"
#include "course/assignment/variant.hpp"
#include "course/marking/feedback.hpp"

namespace assignment {

/// Computes the curves of the feedback page: the student's own slope, displacement and contact
/// pressure, the difference of their eqs. (2) and (3), and the gap that their contact leaves. An
/// exercise without an answer has no curve. Throws ToolError if the program cannot be run.
std::vector<course::Curve> curves(const course::Program& program, const course::Variant& variant);

}  // namespace assignment
