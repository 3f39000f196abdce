// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/body_choices.hpp"
#include "command_line/options.hpp"
#include "parameters/case.hpp"
#include "point_contact/bodies/curvatures.hpp"
#include "point_contact/closed_forms/cattaneo_mindlin.hpp"
#include "point_contact/solver/nested_grids.hpp"
#include "point_contact/solver/problem.hpp"

namespace app {
using namespace command_line;

/// A point contact to be solved, as the command line and the case file describe it.
struct PointContactInput {
  elasticity::Material material1;
  elasticity::Material material2;
  point_contact::Problem problem;
  std::string profile;  ///< as given
  std::string grid;     ///< hexagonal or square
  std::string method;   ///< fft, variational or matrix-inversion
  point_contact::Accuracy accuracy;
  std::optional<double> load;        ///< either this
  std::optional<double> approach;    ///< or this is given
  std::optional<double> friction;    ///< μ
  std::optional<double> tangential;  ///< Q; without it the bodies slide
  std::optional<PointClosedForm> closed_form;
  std::optional<point_contact::RelativeCurvatures> curvatures;  ///< of curved bodies
  std::optional<point_contact::Hertz> hertz;  ///< of spheres, whatever else is given
  std::vector<double> depths = {};  ///< beneath the middle of the domain, for the stresses
  bool is_second_body = false;      ///< whose stresses
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
    elasticity::Material material(const std::optional<parameters::CylinderCase>& given) const;
    point_contact::PrincipalCurvatures curvatures(
        const std::optional<parameters::CylinderCase>& given) const;
    NumberOption young, poisson, radius, radius_x, radius_y;
  };

  void set_profile(PointContactInput& input,
                   const std::optional<parameters::Case>& from_file) const;
  void set_curved_bodies(PointContactInput& input,
                         const std::optional<parameters::Case>& from_file) const;
  void set_grid(PointContactInput& input) const;
  long n_nodes() const;

  CurvedBody body1_, body2_;
  NumberOption load_, approach_;
  ChoiceOption profile_;
  NumberOption nodes_, domain_, domain_y_, tolerance_, threads_, friction_, tangential_;
  std::string grid_ = "hexagonal";
  std::string element_ = "pyramid";
  std::string method_ = "fft";
  std::string depths_;
  std::string body_ = "1";
  std::string case_file_;
};

}  // namespace app
