// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "system/error.hpp"

namespace config {

/// A unit that is unknown or has the wrong dimension. what() is one line.
class UnitError : public sys::InputError {
 public:
  using InputError::InputError;
};

/// The dimension of a quantity; `none` for a pure number.
enum class Dimension { none, length, force, stress, line_load, density };

/// A coherent system of units: stress = force/length² and line load = force/length, so that
/// formulas need no factors. The names of units are those of UDUNITS-2.
struct UnitSystem {
  std::string name;
  std::string length;
  std::string force;
  std::string stress;
  std::string line_load;
  std::string density;  ///< mass is force·time²/length, with time in s

  /// Returns the unit of a dimension; "1" for none.
  const std::string& unit(Dimension dimension) const;
};

/// The unit systems of cases: in-lbf (in, lbf, psi), mm-N (mm, N, MPa), m-N (m, N,
/// Pa). The first is the default.
const std::vector<UnitSystem>& unit_systems();

/// Returns the system with this name. Throws UnitError with a list of names if there is none.
const UnitSystem& unit_system(std::string_view name);

/// Whether UDUNITS-2 knows a unit.
bool is_unit(const std::string& name);

/// Converts a number from one unit of UDUNITS-2 to another, and rounds it to 15 digits: 39.4 in are
/// 1.00076 m. Throws UnitError if a unit is unknown, if the dimensions differ, or if one unit is
/// not a positive multiple of the other, such as degC (an offset) or a reciprocal.
double converted(double number, const std::string& from, const std::string& to);

}  // namespace config
