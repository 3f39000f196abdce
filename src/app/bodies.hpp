// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands of bodies pressed together share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "elasticity/material.hpp"
#include "line_contact/cylinders.hpp"
#include "parameters/case.hpp"

namespace app {
using namespace command_line;

/// The two bodies of a case, or nothing of either.
struct GivenBodies {
  explicit GivenBodies(const std::optional<parameters::Case>& from_file);
  std::optional<parameters::CylinderCase> body1, body2;
};

/// The flags of a body's material, --young1 and --poisson1; without a number of the only one's.
struct MaterialOption {
  MaterialOption(CLI::App& command, const std::string& number);
  elasticity::Material or_else(const std::optional<elasticity::Material>& given) const;
  elasticity::Material or_else(const std::optional<parameters::CylinderCase>& given) const;
  NumberOption young, poisson;
};

/// The radius that a flag gives, if any: a length other than 0, negative for a hollow, or "plane".
std::optional<line_contact::Radius> radius_of(const NumberOption& radius);

/// What is left out where half-spaces stand for bodies is of the order of the square of a ratio:
/// from a tenth on it is some per cent, and the user is warned.
inline constexpr double small_ratio = 0.1;

/// A sentence if the contact's half-width is not small beside the bodies' least radius of
/// curvature, 0 where none is known; none if it is.
std::vector<std::string> half_space_warnings(double half_width, double least_radius);

}  // namespace app
