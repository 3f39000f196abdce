// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bodies.hpp"
#include "app/choices.hpp"
#include "command_line/options.hpp"
#include "parameters/case.hpp"
#include "point_contact/bodies/profile.hpp"
#include "point_contact/closed_forms/spheres.hpp"
#include "point_contact/solver/methods.hpp"
#include "point_contact/solver/problem.hpp"
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

/// What presses the bodies together.
struct Pressing {
  double contact_modulus;
  double load;
};

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

/// A point contact to be solved, as the command line and the case file describe it.
struct PointContactInput {
  elasticity::Material material1;
  elasticity::Material material2;
  point_contact::Problem problem;
  std::string profile;  ///< as given
  std::string method;   ///< fft or variational
  double tolerance;
  double load;
  std::optional<PointClosedForm> closed_form;
  bool is_curved = false;           ///< curved bodies, whose semi-axes the pressure gives
  bool is_of_revolution = false;    ///< the gap depends on the distance alone
  double least_radius = 0;  ///< of the bodies' principal radii of curvature; 0 if none is known
};

/// The flags of `halfspace point-contact` that describe the contact.
class PointContactOptions {
 public:
  explicit PointContactOptions(CLI::App& command);

  const std::string& case_file() const { return case_file_; }

  /// Flags override what the case file says. Throws sys::InputError or InvalidQuantity for what is
  /// missing, wrong or has no meaning for the profile.
  PointContactInput read(const std::optional<parameters::Case>& from_file) const;

 private:
  struct CurvedBody {
    CurvedBody(CLI::App& command, const std::string& number);
    std::pair<double, double> curvatures(
        const std::optional<parameters::CylinderCase>& given) const;
    MaterialOption material;
    NumberOption radius, radius_x, radius_y;
  };

  void set_profile(PointContactInput& input, const GivenBodies& given) const;
  void set_curved_bodies(PointContactInput& input, const GivenBodies& given) const;
  void set_grid(PointContactInput& input) const;

  CurvedBody body1_, body2_;
  NumberOption load_;
  ChoiceOption profile_;
  NumberOption nodes_, domain_, tolerance_;
  std::string element_ = "pyramid";
  std::string method_ = "fft";
  std::string case_file_;
};

/// A solved point contact and what it took.
struct SolvedPointContact {
  point_contact::Solution solution;
  double seconds;
};

/// Solves it. Throws sys::InputError for a contact of too few nodes besides what the methods throw,
/// and InvalidQuantity for a depth that is not positive.
SolvedPointContact solve(const PointContactInput& input);

/// The semi-axes of the contact, a ≥ b: of curved bodies from the pressure's second moments, of
/// others from those of the area in contact.
point_contact::Vector2 half_widths_of(const PointContactInput& input,
                                      const point_contact::Solution& solution);

/// Where the half-space no longer stands for the bodies: a sentence each, none if it does.
std::vector<std::string> validity_warnings(const PointContactInput& input,
                                           const SolvedPointContact& solved);

}  // namespace app
