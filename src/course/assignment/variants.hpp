// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"

namespace course {

/// Each quantity at its nominal value: the handout that is for nobody.
Variant nominal_variant(const Assignment& assignment);

/// A student's own variant: each quantity on its grid, at a place that SHA-256 of seed, student,
/// name of the quantity and number of the attempt gives; drawn anew until `is_valid`. It is the
/// same on every platform, and who lacks the seed cannot tell it from the student's id.
///
/// Throws sys::SourceError for a student's id that is not one, an empty seed, and after 1000
/// attempts.
Variant variant_of(const Assignment& assignment, const std::string& student,
                   const std::string& seed, const std::function<bool(const Variant&)>& is_valid);

}  // namespace course
