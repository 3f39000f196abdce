// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "course/assignment/check.hpp"
#include "course/assignment/variant.hpp"
#include "course/marking/feedback.hpp"

namespace assignment {

/// The checks that students can run themselves. They hold no answers: each tries a property that
/// the right numbers have.
course::Checks public_checks();

/// The checks that compare with this project's own functions. Their messages give none of the
/// expected numbers.
course::Checks hidden_checks();

/// Whether the theory holds for a variant: the contact is small beside the radii, the load is not
/// so small that rounding shows, the grid reaches beyond the contact.
bool is_valid(const course::Variant& variant);

/// Computes the curves of the feedback page: the student's own slope, displacement and contact
/// pressure, the difference of their eqs. (2) and (3), and the gap that their contact leaves. An
/// exercise without an answer has no curve. Throws ToolError if the program cannot be run.
std::vector<course::Curve> curves(const course::Program& program, const course::Variant& variant);

}  // namespace assignment
