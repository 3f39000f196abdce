// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact_options.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "app/profile_file.hpp"
#include "contact/dense_system.hpp"
#include "contact/fft_solver.hpp"
#include "contact/hertz.hpp"
#include "contact/power_law.hpp"
#include "contact/rounded_punch.hpp"
#include "contact/wedge.hpp"
#include "system/require.hpp"

namespace app {
namespace {

using parameters::CylinderCase;

constexpr const char* file_prefix = "file:";

bool is_file(const std::string& profile) {
  return profile.starts_with(file_prefix);
}

template <class Contact>
ClosedForm closed_form(std::string name, const Contact& contact, double peak_pressure) {
  return {std::move(name), contact.half_width(), peak_pressure,
          [contact](double x) { return contact.pressure(x); }};
}

// A number that must be given on the command line, because no case file has it.
double required(const NumberOption& option) {
  const auto number = option.number();
  if (!number) throw sys::InputError(option.flag() + " is missing");
  return *number;
}

contact::Element element_named(const std::string& name) {
  for (const auto element : {contact::Element::point, contact::Element::uniform}) {
    if (name == contact::name_of(element)) return element;
  }
  return contact::Element::triangular;
}

}  // namespace

ContactOptions::Body::Body(CLI::App& command, const std::string& number)
    : young(command, "--young" + number, "Young's modulus of body " + number),
      poisson(command, "--poisson" + number, "Poisson's ratio of body " + number),
      radius(command, "--radius" + number,
             "Radius of body " + number + "; plane for a plane, negative for a hollow") {}

ContactOptions::ContactOptions(CLI::App& command)
    : body1_(command, "1"),
      body2_(command, "2"),
      load_(command, "--load", "Load P per unit length"),
      approach_(command, "--approach", "Approach of the bodies instead of the load; needs --datum"),
      datum_(command, "--datum", "Where the points lie whose approach is meant"),
      slope_(command, "--slope", "Wedge: tangent of the angle between face and surface"),
      flat_(command, "--flat", "Rounded punch: half-width of its flat"),
      edge_radius_(command, "--edge-radius", "Rounded punch: radius of its edges"),
      power_(command, "--power", "Power law A x^2n: n"),
      coefficient_(command, "--coefficient", "Power law A x^2n: A"),
      nodes_(command, "--nodes", "Number of nodes"),
      domain_(command, "--domain",
              "Total width that the nodes fill [a little more than the contact]"),
      tolerance_(command, "--tolerance",
                 "Error of the pressure allowed to fft, relative to the peak [1e-10]"),
      friction_(command, "--friction", "Coefficient of friction: the bodies slide along x"),
      tangential_(command, "--tangential-load", "Tangential load Q < friction * P: partial slip") {
  add_text(command, "--profile", profile_, "cylinder|wedge|rounded-punch|power|file:PATH",
           "Shape of the gap; file: a CSV file with the columns x,gap");
  add_choice(command, "--element", element_, {"triangular", "uniform", "point"},
             "What stands at a node for the pressure around it");
  add_choice(command, "--method", method_, {"matrix-inversion", "variational", "fft"},
             "How to solve [matrix-inversion up to 1000 nodes, then fft]");
  add_choice(command, "--grid", grid_, {"symmetric", "one-sided"},
             "Nodes on both sides, or on x >= 0 with mirror images");
  add_text(command, "--case", case_file_, "FILE", "Case file; flags override what it says");
}

elasticity::Material ContactOptions::Body::material(
    const std::optional<CylinderCase>& given) const {
  std::optional<double> given_young, given_poisson;
  if (given) {
    given_young = given->material.young();
    given_poisson = given->material.poisson();
  }
  return {young.number_or(given_young), poisson.number_or(given_poisson)};
}

contact::Radius ContactOptions::Body::radius_or(const std::optional<CylinderCase>& given) const {
  if (radius.text() == "plane") return contact::Radius::of_plane();
  if (radius.text().empty() && given) return given->radius;
  const double length = radius.number_or(std::nullopt);
  return contact::Radius::of_cylinder(radius.flag().c_str() + 2, length);
}

// Refuse a flag that would be ignored: the user made a mistake.
void ContactOptions::refuse_flags_of_other_profiles() const {
  const std::vector<std::pair<const NumberOption*, const char*>> flags = {
      {&body1_.radius, "cylinder"}, {&body2_.radius, "cylinder"},     {&slope_, "wedge"},
      {&flat_, "rounded-punch"},    {&edge_radius_, "rounded-punch"}, {&power_, "power"},
      {&coefficient_, "power"}};
  for (const auto& [option, profile] : flags) {
    if (!option->text().empty() && profile_ != profile) {
      throw sys::InputError(
          fmt::format("{} has no meaning for --profile {}", option->flag(), profile_));
    }
  }
}

void ContactOptions::set_profile(ContactInput& input,
                                 const std::optional<parameters::Case>& from_file) const {
  refuse_flags_of_other_profiles();
  const double modulus = input.problem.contact_modulus;
  contact::Profile& profile = input.problem.profile;
  if (profile_ == "cylinder") {
    std::optional<CylinderCase> given1, given2;
    if (from_file) {
      given1 = from_file->contact.body1;
      given2 = from_file->contact.body2;
    }
    const contact::CylinderPair cylinders(input.material1, body1_.radius_or(given1),
                                          input.material2, body2_.radius_or(given2));
    profile = cylinders.profile();
    if (!input.line_load) return;
    input.hertz.emplace(cylinders, *input.line_load);
    input.closed_form = closed_form("hertz", *input.hertz, input.hertz->peak_pressure());
  } else if (profile_ == "wedge") {
    const double slope = required(slope_);
    profile = contact::Profile::wedge(slope);
    if (!input.line_load) return;
    input.closed_form = closed_form("wedge", contact::Wedge(modulus, slope, *input.line_load),
                                    std::numeric_limits<double>::infinity());
  } else if (profile_ == "rounded-punch") {
    const double flat = required(flat_);
    const double radius = sys::require_positive("edge-radius", required(edge_radius_));
    profile = contact::Profile::rounded_punch(flat, 1 / radius);
    if (!input.line_load) return;
    const contact::RoundedPunch punch(modulus, flat, 1 / radius, *input.line_load);
    input.closed_form = closed_form("rounded-punch", punch, punch.peak_pressure());
  } else if (profile_ == "power") {
    const auto n = power_.integer();
    if (!n) throw sys::InputError("--power is missing");
    if (*n < 1 || *n > contact::Profile::max_power) {
      throw sys::InputError(
          fmt::format("--power = {}: must be from 1 to {}", *n, contact::Profile::max_power));
    }
    const double coefficient = required(coefficient_);
    profile = contact::Profile::power_law(coefficient, static_cast<int>(*n));
    if (!input.line_load) return;
    const contact::PowerLaw power(modulus, coefficient, static_cast<int>(*n), *input.line_load);
    input.closed_form = closed_form("power", power, power.peak_pressure());
  } else if (is_file(profile_)) {
    profile = read_profile(profile_.substr(std::string(file_prefix).size()));
  } else {
    throw sys::InputError(fmt::format(
        "--profile = {}: must be cylinder, wedge, rounded-punch, power or file:PATH", profile_));
  }
}

void ContactOptions::set_grid(ContactInput& input, Eigen::Index n_nodes) const {
  contact::Grid& grid = input.problem.grid;
  const contact::Profile& profile = input.problem.profile;
  const bool is_one_sided = grid_ == "one-sided";
  std::optional<double> width = domain_.number();
  double centre = 0;
  if (std::isfinite(profile.begin())) {
    centre = (profile.begin() + profile.end()) / 2;
    if (!width) width = profile.end() - profile.begin();
  } else if (!width && input.closed_form) {
    const contact::Grid around = contact::grid_around(input.closed_form->half_width,
                                                      is_one_sided ? 2 * n_nodes - 1 : n_nodes);
    grid = is_one_sided ? contact::Grid{n_nodes, around.spacing, 0, true} : around;
    return;
  }
  if (!width) throw sys::InputError("--domain is missing: with --approach the width must be given");
  grid = is_one_sided ? contact::one_sided_grid(*width, n_nodes)
                      : contact::grid_of_width(*width, n_nodes, centre);
}

ContactInput ContactOptions::read(const std::optional<parameters::Case>& from_file) const {
  std::optional<CylinderCase> given1, given2;
  std::optional<double> given_load;
  std::optional<long> n_nodes = nodes_.integer();
  std::optional<double> datum = datum_.number();
  if (from_file) {
    given1 = from_file->contact.body1;
    given2 = from_file->contact.body2;
    given_load = from_file->contact.line_load;
    if (!n_nodes) n_nodes = from_file->contact.n_nodes;
    if (!datum) datum = from_file->contact.datum;
  }
  if (!n_nodes) throw sys::InputError("--nodes is missing: give it, or a --case that has it");

  const elasticity::Material material1 = body1_.material(given1);
  const elasticity::Material material2 = body2_.material(given2);
  const double modulus = elasticity::contact_modulus(material1, material2);
  ContactInput input{
      .material1 = material1,
      .material2 = material2,
      .problem = {contact::Profile::parabola(1), modulus, {}, element_named(element_)},
      .profile = profile_,
      .method = method_,
      .tolerance = tolerance_.number_or(contact::default_tolerance),
      .line_load = {},
      .approach = approach_.number(),
      .datum = datum,
      .friction = friction_.number(),
      .tangential = tangential_.number(),
      .closed_form = {},
      .hertz = {}};
  if (input.approach && load_.number())
    throw sys::InputError("--load and --approach: give one of them");
  if (input.approach && !datum)
    throw sys::InputError("--datum is missing: --approach is relative to it");
  if (!input.approach) {
    input.line_load = sys::require_positive("load", load_.number_or(given_load));
  }
  if (input.tangential && !input.friction)
    throw sys::InputError("--tangential-load needs --friction");
  if (input.friction && grid_ == "one-sided") {
    throw sys::InputError("--friction needs --grid symmetric: its shear has no mirror image");
  }
  constexpr long quickly_inverted = 1000;
  if (method_.empty()) input.method = *n_nodes <= quickly_inverted ? "matrix-inversion" : "fft";
  if (input.method != "fft" && tolerance_.number()) {
    throw sys::InputError("--tolerance has no meaning for --method " + input.method);
  }
  contact::require_tolerance(input.tolerance);
  set_profile(input, from_file);
  set_grid(input, *n_nodes);
  return input;
}

}  // namespace app
