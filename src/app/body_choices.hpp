// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/choices.hpp"
#include "point_contact/bodies/profile.hpp"
#include "system/require.hpp"

namespace app {

/// A point contact that has a closed form, to compare with.
struct PointClosedForm {
  std::string name;  ///< "hertz", or the profile's
  double half_width_x;
  double half_width_y;
  double peak_pressure;  ///< infinite at a cone's tip and at a flat end's edge
  double approach;
  double load;
};

/// What presses the bodies together: the one that is asked for, and their modulus E*.
struct Pressing {
  double contact_modulus;
  std::optional<double> load;
  std::optional<double> approach;
};

/// The load that is given, or the one that makes the given approach, which grows with a power of
/// the load, and the contact in closed form that it makes: `under` has that of one load. Throws
/// InvalidQuantity for an approach that is not positive.
template <class Under>
auto pressed(const Pressing& pressing, double power, const Under& under) {
  double load = pressing.load.value_or(0);
  if (!pressing.load) {
    const double approach = pressing.approach.value();
    if (!(approach > 0)) {
      throw sys::InvalidQuantity("approach", approach, "greater than 0, or there is no contact");
    }
    const double scale = pressing.contact_modulus;  // a load of the right order of magnitude
    load = scale * std::pow(approach / under(scale).approach(), 1 / power);
  }
  return std::pair(load, under(load));
}

/// A gap, and the closed form of its contact.
struct ChosenBody {
  point_contact::Profile profile;
  std::optional<PointClosedForm> closed_form = {};
};

/// A shape of the gap that --profile names.
struct BodyChoice : Choice {
  bool is_of_revolution = true;  ///< the gap depends on the distance alone
  /// Empty for curved bodies, whose radii a case may give.
  std::function<ChosenBody(const ChoiceOption& given, const Pressing& pressing)> choose;
};

/// All of them, in the order of the help.
const std::vector<BodyChoice>& body_choices();

}  // namespace app
