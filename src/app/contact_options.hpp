// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bodies.hpp"
#include "app/choices.hpp"
#include "command_line/options.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/problem.hpp"
#include "line_contact/profile.hpp"
#include "line_contact/solution.hpp"
#include "parameters/case.hpp"

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

/// A contact to be solved, as the command line and the case file describe it.
struct ContactInput {
  elasticity::Material material1;
  elasticity::Material material2;
  line_contact::Problem problem;
  std::string profile;               ///< as given
  std::string method;                ///< matrix-inversion, variational or fft
  double tolerance;                  ///< of fft
  std::optional<double> line_load;
  std::optional<double> datum;
  std::optional<ClosedForm> closed_form;
  std::optional<line_contact::Hertz> hertz;  ///< for cylinders under a load
  double least_radius = 0;                   ///< of the two cylinders; 0 for other profiles
};

/// The flags that describe a contact: `halfspace contact` and `halfspace stress` have them.
class ContactOptions {
 public:
  explicit ContactOptions(CLI::App& command);

  const std::string& case_file() const { return case_file_; }

  /// Flags override what the case file says. Throws sys::InputError or InvalidQuantity for what is
  /// missing, wrong or has no meaning for the profile.
  ContactInput read(const std::optional<parameters::Case>& from_file) const;

 private:
  struct Body {
    Body(CLI::App& command, const std::string& number);
    MaterialOption material;
    NumberOption radius;
  };

  void set_profile(ContactInput& input, const GivenBodies& given) const;
  void set_grid(ContactInput& input, Eigen::Index n_nodes) const;

  Body body1_, body2_;
  NumberOption load_, datum_;
  ChoiceOption profile_;
  NumberOption nodes_, domain_, tolerance_;
  std::string element_ = "triangular";
  std::string method_;
  std::string case_file_;
};

/// A solved contact and what it took.
struct SolvedContact {
  line_contact::Solution solution;
  std::optional<double> approach;  ///< where a datum is given
  double seconds;
};

/// Solves it; long solves show on standard error how far they are.
SolvedContact solve(const ContactInput& input);

/// The half-width: of cylinders from the second moment of the pressure, for other profiles half the
/// distance between the edges.
double half_width_of(const ContactInput& input, const line_contact::Solution& solution);

/// Where half-spaces no longer stand for the bodies: a sentence, none if they do.
std::vector<std::string> validity_warnings(const ContactInput& input, const SolvedContact& solved);

}  // namespace app
