// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers that differ from student to student. This header is part of the handout, so it uses
// the standard library only.
#pragma once

#include <string>

namespace assignment {

/// A student's numbers, in SI units.
struct OwnNumbers {
  double young1, poisson1;           ///< of body 1, and of exercises 1 to 3
  double young2, poisson2;           ///< of body 2
  double radius1, radius2;           ///< of the two cylinders
  double line_load;                  ///< presses them together
  double spacing, nodes;             ///< of the grid for their pressure
  double peak_pressure, half_width;  ///< of the pressure in exercises 1 to 3
  double datum;                      ///< the x at which the displacement is zero
};

/// The case of the paper, rounded: steel, 1 in and 3 in, 2500 lbf/in, 91 nodes.
OwnNumbers nominal_numbers();

/// The numbers that follow from an id; the nominal numbers for an empty id. Upper and lower case
/// and blanks make no difference. A hash of the id selects numbers from the ranges in numbers.cpp
/// until they satisfy is_valid().
OwnNumbers own_numbers(const std::string& id);

/// Whether numbers in these ranges are compatible: the strains stay in the linear range of metals,
/// and the grid resolves the contact and extends a little beyond it.
bool is_valid(const OwnNumbers& numbers);

/// Returns a line "name value unit" for each quantity that follows from an id.
std::string lines_of_numbers(const std::string& id);

}  // namespace assignment
