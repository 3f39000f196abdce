// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/choices.hpp"
#include "line_contact/profile.hpp"

namespace app {

/// A contact that has a closed form, to compare with.
struct ClosedForm {
  std::string name;
  double half_width;
  double peak_pressure;  ///< infinite for a wedge
  std::function<double(double)> pressure;
};

/// The closed form of a solved contact such as line_contact::Wedge.
template <class Contact>
ClosedForm closed_form(std::string name, const Contact& contact, double peak_pressure) {
  return {std::move(name), contact.half_width(), peak_pressure,
          [contact](double x) { return contact.pressure(x); }};
}

/// A gap, and the closed form of its contact under a load.
struct ChosenProfile {
  line_contact::Profile profile;
  std::optional<ClosedForm> closed_form = {};
};

/// A shape of the gap that --profile names.
struct ProfileChoice : Choice {
  /// Makes the profile, with a closed form unless `line_load` is empty. Empty itself for cylinders,
  /// whose radii a case may give.
  std::function<ChosenProfile(const ChoiceOption& given, double contact_modulus,
                              std::optional<double> line_load)>
      choose;
};

/// All of them, in the order of the help.
const std::vector<ProfileChoice>& profile_choices();

}  // namespace app
