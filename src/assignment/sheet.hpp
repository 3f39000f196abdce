// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"
#include "literate/document/document.hpp"
#include "literate/figures/figure.hpp"

namespace assignment {

/// Registers everything that the assignment sheet (report/assignment/sheet.tex) names: its facts
/// (`sheet.…`), the points and a table of checks of each exercise (`points.ID`, `checks-ID`), the
/// limits (`limit.…`), all exercises with their files (`exercises`), the variant's numbers
/// (`quantities`), and its figures.
///
/// It registers no id of a hidden check and no number that a check expects. Throws
/// std::out_of_range for a quantity that the variant lacks.
void register_sheet(literate::Document& document, const course::Assignment& assignment,
                    const course::Variant& variant);

/// The triangle of eq. (4), and overlapping triangles with their sum.
literate::Figure setting();

/// How many digits of the slope are wrong when eq. (3)'s three terms are added as they stand,
/// against the distance from the load.
literate::Figure lost_digits();

}  // namespace assignment
