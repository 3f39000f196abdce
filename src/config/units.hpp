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

/// The dimension of a quantity; a pure number has `none`.
enum class Dimension { none, length, force, stress, line_load, density };

/// A coherent system of units: stress = force/length² and line load = force/length, so that
/// formulas need no factors. UDUNITS-2 knows the spellings.
struct UnitSystem {
  std::string name;
  std::string length;
  std::string force;
  std::string stress;
  std::string line_load;
  std::string density;  ///< mass is force·time²/length, with time in s

  /// The system's unit of the dimension; "1" for none.
  const std::string& unit(Dimension dimension) const;
};

/// The systems that a case may choose from: in-lbf (in, lbf, psi), mm-N (mm, N, MPa), m-N (m, N,
/// Pa). The first is the default.
const std::vector<UnitSystem>& unit_systems();

/// The system of that name; throws UnitError that lists the names for any other.
const UnitSystem& unit_system(std::string_view name);

/// Whether UDUNITS-2 knows a unit.
bool is_unit(const std::string& name);

/// Returns the quantity `number` of the unit `from` in the unit `to`, as UDUNITS-2 defines both,
/// rounded to 15 digits, so that 39.4 in are 1.00076 m. Throws UnitError if a unit is unknown, if
/// the dimensions differ, and if the one is no positive multiple of the other, as with an offset
/// (degC) or a reciprocal.
double converted(double number, const std::string& from, const std::string& to);

}  // namespace config
