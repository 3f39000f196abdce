// SPDX-License-Identifier: GPL-3.0-or-later
// Each student's own numbers. This header is part of the handout, so it uses the standard library
// only.
#pragma once

#include <string>

namespace assignment {

/// The quantities that differ from student to student, in SI units.
struct OwnNumbers {
  double young1, poisson1;           ///< of body 1, and of exercises 1 to 3
  double young2, poisson2;           ///< of body 2
  double radius1, radius2;           ///< of the two cylinders
  double line_load;                  ///< that presses them together
  double spacing, nodes;             ///< of the grid for their pressure
  double peak_pressure, half_width;  ///< of the pressure in exercises 1 to 3
  double datum;                      ///< where the displacement is zero
};

/// The paper's own case, rounded: steel, 1 in and 3 in, 2500 lbf/in, 91 nodes.
OwnNumbers nominal_numbers();

/// The numbers that belong to an id, whatever its case; the nominal ones for an empty id. They are
/// drawn from the ranges in numbers.cpp by a hash of the id until is_valid() holds.
OwnNumbers own_numbers(const std::string& id);

/// Whether numbers within the ranges go together: the pressure strains no metal beyond its linear
/// range, and the grid resolves the contact and ends just outside it.
bool is_valid(const OwnNumbers& numbers);

/// A line "name value unit" for each quantity.
std::string lines_of(const OwnNumbers& numbers);

}  // namespace assignment
