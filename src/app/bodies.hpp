// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands of bodies pressed together share.
#pragma once

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "config/units.hpp"
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

/// The same, or else the radius of the case's body; throws sys::InputError where there is neither.
line_contact::Radius radius_or(const NumberOption& radius,
                               const std::optional<parameters::CylinderCase>& given);

/// What is left out where half-spaces stand for bodies is of the order of the square of a ratio:
/// from a tenth on it is some per cent, and the user is warned.
inline constexpr double small_ratio = 0.1;

/// A sentence if the contact's half-width is not small beside the bodies' least radius of
/// curvature, 0 where none is known; none if it is.
std::vector<std::string> half_space_warnings(double half_width, double least_radius);

/// The names of elements, as a flag takes them.
template <class Elements>
std::vector<std::string> names_of(const Elements& elements) {
  std::vector<std::string> names;
  for (const auto element : elements) names.emplace_back(name_of(element));
  return names;
}

/// The element of this name.
template <class Elements>
auto element_named(const std::string& name, const Elements& elements) {
  return *std::ranges::find(elements, name, [](auto element) { return name_of(element); });
}

/// A line a region in contact, the first ten of them, if there is more than one.
template <class Region, class OfRegion>
std::string regions_text(const std::vector<Region>& regions, const OfRegion& of_region) {
  if (regions.size() < 2) return "";
  constexpr std::size_t most_shown = 10;
  std::string text = fmt::format("{} regions in contact\n", regions.size());
  for (std::size_t i = 0; i < std::min(regions.size(), most_shown); ++i) {
    text += "  " + of_region(regions[i]) + "\n";
  }
  if (regions.size() > most_shown) {
    text += fmt::format("  and {} more\n", regions.size() - most_shown);
  }
  return text;
}

/// The numbers at the nodes, for a column.
std::vector<double> to_vector(const Eigen::VectorXd& numbers);

/// A line with the residuals of a solution.
template <class Residuals>
std::string residuals_text(const Residuals& residuals, const config::UnitSystem& units,
                           const std::string& unit_of_load) {
  return fmt::format(
      "residuals: (1a) {:.1e} {}, (1b) {:.1e} {}, pressure {:.1e} {}, load {:.1e} {}\n",
      residuals.gap, units.length, residuals.separation, units.length, residuals.pressure,
      units.stress, residuals.load, unit_of_load);
}

}  // namespace app
