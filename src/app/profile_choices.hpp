// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "contact/profile.hpp"

namespace app {
using namespace command_line;

/// A contact that has a closed form, to compare with.
struct ClosedForm {
  std::string name;
  double half_width;
  double peak_pressure;  ///< infinite for a wedge
  std::function<double(double)> pressure;
};

/// The closed form of a solved contact such as contact::Wedge.
template <class Contact>
ClosedForm closed_form(std::string name, const Contact& contact, double peak_pressure) {
  return {std::move(name), contact.half_width(), peak_pressure,
          [contact](double x) { return contact.pressure(x); }};
}

/// A flag that one profile has and no other.
struct ProfileFlag {
  std::string flag;  ///< such as "--slope"
  std::string help;
};

/// The numbers of a profile's flags on the command line.
class ProfileNumbers {
 public:
  /// Adds the flags of every profile to a command.
  explicit ProfileNumbers(CLI::App& command);

  /// Throws sys::InputError if it is missing or is no number.
  double number(const std::string& flag) const;

  /// Throws sys::InputError if it is missing, is no whole number or is not from least to most.
  int integer(const std::string& flag, int least, int most) const;

  /// Throws sys::InputError for a flag that was given and is not among those of `profile`, since it
  /// would be ignored.
  void refuse_flags_of_others(const std::string& profile) const;

 private:
  const NumberOption& option(const std::string& flag) const;

  std::vector<std::unique_ptr<NumberOption>> options_;
};

/// A gap, and the closed form of its contact under a load.
struct ChosenProfile {
  contact::Profile profile;
  std::optional<ClosedForm> closed_form;
};

/// A shape of the gap that --profile names and that numbers on the command line describe.
/// (Cylinders, whose radii a case may give, and measured profiles are read by ContactOptions
/// itself.)
struct ProfileChoice {
  std::string name;
  std::vector<ProfileFlag> flags;
  /// Makes the profile, with a closed form unless `line_load` is empty.
  std::function<ChosenProfile(const ProfileNumbers& numbers, double contact_modulus,
                              std::optional<double> line_load)>
      choose;
};

/// All of them, in the order of the help.
const std::vector<ProfileChoice>& profile_choices();

}  // namespace app
