// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/point_contact_options.hpp"
#include "config/units.hpp"
#include "point_contact/solver/solution.hpp"

namespace app {

/// The stress at a depth beneath the middle of the domain, tension positive.
struct StressBeneath {
  double z;
  Eigen::Matrix3d stress;
  double max_shear;  ///< half of what the extreme principal stresses differ by
  double von_mises;
  std::optional<double> huber_max_shear;  ///< of spheres in closed form
};

/// At the depths that the input asks for, in the body that it names, by the pressure alone. Throws
/// InvalidQuantity for a depth that is not positive or elements other than pyramids.
std::vector<StressBeneath> stresses_beneath(const PointContactInput& input,
                                            const point_contact::Solution& solution);

/// An array with an object a depth, and a table.
nlohmann::ordered_json stresses_json(const std::vector<StressBeneath>& stresses);
std::string stresses_text(const std::vector<StressBeneath>& stresses,
                          const config::UnitSystem& units);

}  // namespace app
