// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact_options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"
#include "system/require.hpp"

namespace app {
namespace {

using line_contact::Element;

constexpr std::array elements{Element::triangular, Element::uniform, Element::point};

}  // namespace

ContactOptions::Body::Body(CLI::App& command, const std::string& number)
    : material(command, number),
      radius(command, "--radius" + number,
             "Radius of body " + number + "; plane for a plane, negative for a hollow") {}

ContactOptions::ContactOptions(CLI::App& command)
    : body1_(command, "1"),
      body2_(command, "2"),
      load_(command, "--load", "Load P per unit length"),
      datum_(command, "--datum", "Where the points lie whose approach is meant"),
      profile_(command, "--profile", "cylinder",
               "Shape of the gap; file: a CSV file with the columns x,gap",
               choices_of(profile_choices())),
      nodes_(command, "--nodes", "Number of nodes"),
      domain_(command, "--domain",
              "Total width that the nodes fill [under a load: a little more than the contact]"),
      tolerance_(command, "--tolerance",
                 "Error of the pressure allowed to fft, relative to the peak [1e-10]") {
  add_choice(command, "--element", element_, names_of(elements),
             "What stands at a node for the pressure around it");
  add_choice(command, "--method", method_, {"matrix-inversion", "variational", "fft"},
             "How to solve [matrix-inversion up to 1000 nodes, then fft]");
  add_text(command, "--case", case_file_, "FILE", "Case file; flags override what it says");
}

void ContactOptions::set_profile(ContactInput& input, const GivenBodies& given) const {
  profile_.refuse_flags_of_others();
  line_contact::Profile& profile = input.problem.profile;
  const ProfileChoice& choice = profile_choices()[profile_.row()];
  if (!choice.choose) {
    const line_contact::Radius radius1 = radius_or(body1_.radius, given.body1);
    const line_contact::Radius radius2 = radius_or(body2_.radius, given.body2);
    const line_contact::CylinderPair cylinders(input.material1, radius1, input.material2, radius2);
    profile = cylinders.profile();
    input.least_radius = 1 / std::max(std::abs(radius1.curvature()), std::abs(radius2.curvature()));
    if (!input.line_load) return;
    input.hertz.emplace(cylinders, *input.line_load);
    input.closed_form = closed_form("hertz", *input.hertz, input.hertz->peak_pressure());
    return;
  }
  profile_.refuse(body1_.radius);
  profile_.refuse(body2_.radius);
  ChosenProfile chosen = choice.choose(profile_, input.problem.contact_modulus, input.line_load);
  profile = std::move(chosen.profile);
  input.closed_form = std::move(chosen.closed_form);
}

void ContactOptions::set_grid(ContactInput& input, Eigen::Index n_nodes) const {
  line_contact::Grid& grid = input.problem.grid;
  const line_contact::Profile& profile = input.problem.profile;
  std::optional<double> width = domain_.number();
  double centre = 0;
  if (std::isfinite(profile.begin())) {
    centre = (profile.begin() + profile.end()) / 2;
    if (!width) width = profile.end() - profile.begin();
  } else if (!width && input.closed_form) {
    grid = line_contact::grid_around(input.closed_form->half_width, n_nodes);
    return;
  }
  if (!width) throw sys::InputError("--domain is missing");
  grid = line_contact::grid_of_width(*width, n_nodes, centre);
}

ContactInput ContactOptions::read(const std::optional<parameters::Case>& from_file) const {
  const GivenBodies given(from_file);
  std::optional<double> given_load;
  std::optional<long> n_nodes = nodes_.integer();
  std::optional<double> datum = datum_.number();
  if (from_file) {
    given_load = from_file->contact.line_load;
    if (!n_nodes) n_nodes = from_file->contact.n_nodes;
    if (!datum) datum = from_file->contact.datum;
  }
  if (!n_nodes) throw sys::InputError("--nodes is missing: give it, or a --case that has it");

  const elasticity::Material material1 = body1_.material.or_else(given.body1);
  const elasticity::Material material2 = body2_.material.or_else(given.body2);
  const double modulus = elasticity::contact_modulus(material1, material2);
  ContactInput input{.material1 = material1,
                     .material2 = material2,
                     .problem = {line_contact::Profile::parabola(1),
                                 modulus,
                                 {},
                                 element_named(element_, elements)},
                     .profile = profile_.text(),
                     .method = method_,
                     .tolerance = tolerance_.number_or(line_contact::default_tolerance),
                     .line_load = {},
                     .datum = datum,
                     .closed_form = {},
                     .hertz = {}};
  input.line_load = sys::require_positive("load", load_.number_or(given_load));
  constexpr long quickly_inverted = 1000;
  if (method_.empty()) input.method = *n_nodes <= quickly_inverted ? "matrix-inversion" : "fft";
  refuse_if(input.method != "fft" && tolerance_.number(),
            "--tolerance has no meaning for --method " + input.method);
  set_profile(input, given);
  set_grid(input, *n_nodes);
  return input;
}

}  // namespace app
