// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies that are loaded or pressed together: their materials and their radii.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/flags.hpp"
#include "elasticity/material.hpp"
#include "line_contact/cylinders.hpp"
#include "parameters/case.hpp"
#include "system/require.hpp"

namespace app {

using elasticity::Material;

/// The flags --young and --poisson, of one body or of both.
struct MaterialFlags {
  CLI::App& command;
  std::string number = "";  ///< behind the flags' names
  std::string which = "";   ///< body it is, in the help
  std::string otherwise = " [210 GPa and 0.3, steel, or the case's]";
  Flag young{command, "--young" + number, "STRESS", "Bodies",
             "Young's modulus" + which + otherwise};
  Flag poisson{command, "--poisson" + number, "NUMBER", "Bodies", "Poisson's ratio" + which};

  /// The flags override the case, and those of one body override those of both. None without
  /// either. Throws sys::InputError for a value out of range, and where one of the two is missing.
  std::optional<Material> read(const std::optional<Material>& from_case, const std::string& unit,
                               const MaterialFlags* of_both = nullptr) const;
};

/// The same for a body that is of steel where nothing is said, which adds a note.
Material read_material(const MaterialFlags& flags, const std::optional<Material>& from_case,
                       const std::string& unit, std::vector<std::string>& notes);

/// The materials of two bodies.
struct PairOfMaterials {
  CLI::App& command;
  MaterialFlags both{command, "", " of both bodies"};
  MaterialFlags body1{command, "1", " of body 1 alone", ""};
  MaterialFlags body2{command, "2", " of body 2 alone", ""};

  std::pair<Material, Material> read(const std::optional<parameters::ContactCase>& from_case,
                                     const std::string& unit,
                                     std::vector<std::string>& notes) const;
};

/// The radius that a flag gives: a length other than 0, negative for a hollow, or "plane".
std::optional<line_contact::Radius> radius_of(const Flag& flag, const std::string& unit);

/// A sentence if the contact's half-width is not small beside the least radius of curvature, 0
/// where none is known: what half-spaces leave out is of the order of the square of this ratio.
std::vector<std::string> half_space_warnings(double half_width, double least_radius);

/// Returns solve(). If a quantity is out of range that one of the flags gave, the message names the
/// flag and has its text.
template <class Solve>
auto naming(const std::vector<const Flag*>& flags, const Solve& solve) {
  try {
    return solve();
  } catch (const sys::InvalidQuantity& error) {
    for (const Flag* flag : flags) {
      if (flag->is_given() && flag->name() == "--" + error.quantity()) {
        flag->refuse("must be " + error.allowed());
      }
    }
    throw;
  }
}

}  // namespace app
