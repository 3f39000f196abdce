// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"

namespace course {

/// The variant with each quantity at its nominal value, for the handout that is for nobody in
/// particular.
Variant nominal_variant(const Assignment& assignment);

/// Draws a student's own variant. The value of each quantity is the one on its grid that
/// SHA-256 of seed, student, name of the quantity and number of the attempt selects; all are drawn
/// again until `is_valid` accepts them. The variant is the same on every platform, and nobody can
/// tell it from the student's id without the seed.
///
/// Throws sys::SourceError for an id that is not allowed, for an empty seed, and after 1000
/// attempts.
Variant variant_of(const Assignment& assignment, const std::string& student,
                   const std::string& seed, const std::function<bool(const Variant&)>& is_valid);

}  // namespace course
