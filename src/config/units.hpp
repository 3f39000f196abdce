// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "system/error.hpp"

namespace config {

/// A unit that is unknown, or that measures something else. what() is one line.
class UnitError : public sys::InputError {
 public:
  using InputError::InputError;
};

/// What a quantity measures; `none` is a pure number.
enum class Dimension { none, length, stress, line_load, density };

/// A coherent system of units: stress = force/length², line load = force/length, so that formulas
/// need no factors. Spellings are those of UDUNITS-2 and print well in text, LaTeX and gnuplot.
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
/// Pa). The first is the paper's and the default.
const std::vector<UnitSystem>& unit_systems();

/// The system of that name; throws UnitError that lists the names for any other.
const UnitSystem& unit_system(std::string_view name);

/// How many `to` one `from` is, for example 25.4 for in → mm; exactly 1 for two spellings of a
/// unit. Throws UnitError if either is unknown or they measure different things.
double conversion_factor(const std::string& from, const std::string& to);

}  // namespace config
