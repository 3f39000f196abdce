// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies that are loaded or pressed together: their materials, their radii, and what is said of
// any contact between them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/flags.hpp"
#include "elasticity/material.hpp"
#include "line_contact/cylinders.hpp"

namespace app {

using MaterialOfCase = std::optional<elasticity::Material>;

/// The flags --young and --poisson.
struct MaterialFlags {
  CLI::App& command;
  std::string number = "";     ///< 1 or 2 for one of two bodies
  std::string which = "";      ///< body that is, in the help
  std::string otherwise = "";  ///< what holds without them, in the help
  Flag young{command, "--young" + number, "STRESS", "Bodies",
             "Young's modulus" + which + otherwise};
  Flag poisson{command, "--poisson" + number, "NUMBER", "Bodies", "Poisson's ratio" + which};
};

/// The material that the flags give, or else the case, or else steel. Where both bodies have flags
/// in common, `of_both` has them, and those of the body override them. Throws sys::InputError for
/// values out of range, and where one of the two numbers is missing. Steel adds a note.
elasticity::Material material_of(const MaterialFlags& own, const MaterialFlags& of_both,
                                 const MaterialOfCase& from_case, const std::string& unit,
                                 std::vector<std::string>& notes);

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

/// Adds a line for each region in contact if there are several, the first ten of them.
template <class Region, class OfRegion>
void add_regions(std::vector<std::string>& notes, const std::vector<Region>& regions,
                 const OfRegion& of_region) {
  constexpr std::size_t most_shown = 10;
  if (regions.size() < 2) return;
  notes.push_back(std::to_string(regions.size()) + " regions in contact");
  for (std::size_t i = 0; i < regions.size() && i < most_shown; ++i) {
    notes.push_back("  " + of_region(regions[i]));
  }
  if (regions.size() > most_shown) notes.push_back("  and others, each with less");
}

}  // namespace app
