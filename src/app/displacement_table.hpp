// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "config/units.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "numerics/estimate.hpp"

namespace app {

/// Which displacement of the surface: u_z or u_x.
enum class Component { normal, tangential };

/// The two ways to the same numbers at one point: eq. (2) by quadrature, and in closed form.
struct DisplacementRow {
  double x;
  numerics::Estimate gradient_quadrature;
  double gradient_closed_form;
  numerics::Estimate displacement_quadrature;
  double displacement_closed_form;
};

// All three throw sys::InputError, naming the column and x, for a number that is not finite.

/// A header and a row a point, numbers with the shortest digits that round-trip.
std::string displacement_csv(const std::vector<DisplacementRow>& rows);

/// The same as an array of objects whose names are the columns of the csv.
std::string displacement_json(const std::vector<DisplacementRow>& rows);

/// Aligned columns for reading, 13 significant digits, with units.
std::string displacement_text(const std::vector<DisplacementRow>& rows,
                              const config::UnitSystem& units);

}  // namespace app
