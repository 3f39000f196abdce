// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/point_contact_options.hpp"
#include "config/units.hpp"
#include "point_contact/solver/partial_slip.hpp"
#include "point_contact/solver/solution.hpp"

namespace app {

/// A solved point contact and what it took.
struct SolvedPointContact {
  point_contact::Solution solution;
  std::optional<point_contact::Friction> friction;
  std::optional<double> tangential_displacement;  ///< of bodies of revolution, under partial slip
  double seconds;
};

/// Solves it. Throws sys::InputError for a contact of too few nodes besides what the methods throw.
SolvedPointContact solve(const PointContactInput& input);

/// The semi-axes of the contact, a ≥ b: of curved bodies from the pressure's second moments, of
/// others from those of the area in contact.
point_contact::Vector2 half_widths_of(const PointContactInput& input,
                                      const point_contact::Solution& solution);

/// Where the half-space no longer stands for the bodies: a sentence each, none if it does.
std::vector<std::string> validity_warnings(const PointContactInput& input,
                                           const SolvedPointContact& solved);

/// Throws sys::InputError if anything that is to be printed is not a finite number.
void require_finite(const PointContactInput& input, const SolvedPointContact& solved);

/// A solved contact as JSON, as a table of its nodes with the columns x,y,pressure,gap (and shear,
/// if there is friction), and as text for people.
std::string point_contact_json(const PointContactInput& input, const SolvedPointContact& solved);
std::string point_contact_csv(const SolvedPointContact& solved);
std::string point_contact_text(const PointContactInput& input, const SolvedPointContact& solved,
                               const config::UnitSystem& units);

}  // namespace app
