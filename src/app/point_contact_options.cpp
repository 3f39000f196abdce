// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/point_contact_options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "point_contact/closed_forms/hertz_elliptic.hpp"
#include "point_contact/solver/methods.hpp"
#include "point_contact/solver/problem.hpp"
#include "system/require.hpp"

namespace app {
namespace {

using parameters::CylinderCase;
using point_contact::Element;
using point_contact::Profile;

constexpr std::array elements{Element::pyramid, Element::bilinear, Element::uniform,
                              Element::point};

// Threads beyond this are not used.
constexpr long most_threads = 64;

}  // namespace

PointContactOptions::CurvedBody::CurvedBody(CLI::App& command, const std::string& number)
    : material(command, number),
      radius(command, "--radius" + number,
             "Radius of body " + number + ", a sphere; plane for a plane, negative for a hollow"),
      radius_x(command, "--radius" + number + "x",
               "Or its two principal radii: the one along its x axis"),
      radius_y(command, "--radius" + number + "y", "and the one along its y axis") {}

PointContactOptions::PointContactOptions(CLI::App& command)
    : body1_(command, "1"),
      body2_(command, "2"),
      load_(command, "--load", "Load P, a force"),
      approach_(command, "--approach", "Approach of distant points instead of the load"),
      profile_(command, "--profile", "sphere",
               "Shape of the gap. sphere: spheres, ellipsoids, crossed cylinders, by their radii; "
               "file: a CSV grid of gaps, a line for each y; heights: of heights above the surface",
               choices_of(body_choices())),
      nodes_(command, "--nodes", "Number of nodes along a side of the domain [256]"),
      domain_(command, "--domain",
              "Width W of the square that the nodes fill [the contact's and a ninth more]"),
      domain_y_(command, "--domain-y", "Its height, if it is to be no square"),
      tolerance_(command, "--tolerance",
                 "Error of the pressure allowed, relative to the peak [1e-8]"),
      threads_(command, "--threads", "Number of threads; changes no digit of the result [1]") {
  add_choice(command, "--grid", grid_, {"hexagonal", "square"},
             "Nodes as corners of equilateral triangles or of squares");
  add_choice(command, "--element", element_, names_of(elements),
             "What stands at a node for the pressure around it");
  add_choice(command, "--method", method_, {"fft", "variational", "matrix-inversion"},
             "How to solve; the last two are references for small grids");
  add_text(command, "--depths", depths_, "LIST",
           "Depths beneath the middle of the domain to tell the stresses at, as 0.01,0.02");
  add_choice(command, "--body", body_, {"1", "2"}, "In which of the two bodies");
  add_text(command, "--case", case_file_, "FILE",
           "Case file; its materials and radii, which flags override");
}

point_contact::PrincipalCurvatures PointContactOptions::CurvedBody::curvatures(
    const std::optional<CylinderCase>& given) const {
  const bool has_two = !radius_x.text().empty() || !radius_y.text().empty();
  if (has_two && !radius.text().empty()) {
    throw sys::InputError(fmt::format("{} and {}: give one radius or two", radius.flag(),
                                      (radius_x.text().empty() ? radius_y : radius_x).flag()));
  }
  if (has_two) {
    for (const NumberOption* one : {&radius_x, &radius_y}) {
      if (one->text().empty()) throw sys::InputError(one->flag() + " is missing");
    }
    return {radius_of(radius_x)->curvature(), radius_of(radius_y)->curvature()};
  }
  const double both = radius_or(radius, given).curvature();
  return {both, both};
}

void PointContactOptions::set_curved_bodies(PointContactInput& input,
                                            const GivenBodies& given) const {
  const auto body1 = body1_.curvatures(given.body1);
  const auto body2 = body2_.curvatures(given.body2);
  const double angle = profile_.given("--angle").value_or(0) * std::numbers::pi / 180;
  auto relative = point_contact::relative_curvatures(body1, body2, angle);
  // Axes that are turned by rounding alone are those of body 1.
  constexpr double rounding = 1e-14;
  if (std::abs(relative.angle) < rounding) relative.angle = 0;
  input.curvatures = relative;
  input.problem.profile = Profile::elliptic_paraboloid(relative.x, relative.y);
  // Curvatures that differ by rounding alone are those of spheres.
  input.is_of_revolution = relative.y - relative.x <= rounding * relative.y;
  double greatest = 0;
  for (const double curvature : {body1.first, body1.second, body2.first, body2.second}) {
    greatest = std::max(greatest, std::abs(curvature));
  }
  input.least_radius = 1 / greatest;

  const Pressing pressing{input.problem.contact_modulus, input.load, input.approach};
  constexpr double hertzs_power = 2.0 / 3;
  if (input.is_of_revolution) {
    const auto [load, hertz] = pressed(pressing, hertzs_power, [&](double p) {
      return point_contact::Hertz(pressing.contact_modulus, relative.y, p);
    });
    input.hertz = hertz;
    input.closed_form = {
        "hertz", hertz.radius(), hertz.radius(), hertz.peak_pressure(), hertz.approach(), load};
    return;
  }
  const auto [load, hertz] = pressed(pressing, hertzs_power, [&](double p) {
    return point_contact::HertzElliptic(pressing.contact_modulus, relative.x, relative.y, p);
  });
  input.closed_form = {
      "hertz", hertz.semi_axis_x(), hertz.semi_axis_y(), hertz.peak_pressure(), hertz.approach(),
      load};
}

void PointContactOptions::set_profile(PointContactInput& input, const GivenBodies& given) const {
  profile_.refuse_flags_of_others();
  const BodyChoice& choice = body_choices()[profile_.row()];
  if (!choice.choose) return set_curved_bodies(input, given);
  for (const CurvedBody* body : {&body1_, &body2_}) {
    for (const NumberOption* radius : {&body->radius, &body->radius_x, &body->radius_y}) {
      profile_.refuse(*radius);
    }
  }
  ChosenBody chosen =
      choice.choose(profile_, {input.problem.contact_modulus, input.load, input.approach});
  input.is_of_revolution = choice.is_of_revolution;
  input.problem.profile = std::move(chosen.profile);
  input.closed_form = std::move(chosen.closed_form);
}

long PointContactOptions::n_nodes() const {
  constexpr long usual = 256;
  const long n = nodes_.integer().value_or(usual);
  refuse_if(n < point_contact::min_nodes,
            fmt::format("--nodes = {}: must be {} or more", n, point_contact::min_nodes));
  constexpr long too_many = 1'000'000'000;  // whose rows need no exact count
  point_contact::require_memory(n, grid_ == "hexagonal" && n < too_many ? n + n / 6 : n);
  return n;
}

void PointContactOptions::set_grid(PointContactInput& input) const {
  const long n = n_nodes();
  std::optional<double> width = domain_.number();
  std::optional<double> height = domain_y_.number();
  if (width) sys::require_positive("domain", *width);
  if (height) sys::require_positive("domain-y", *height);
  refuse_if(!width && height, "--domain-y needs --domain");
  const auto& half_sides = input.problem.profile.half_sides();
  if (!width && std::isfinite(half_sides.x())) {
    width = 2 * half_sides.x();
    height = 2 * half_sides.y();
  } else if (!width && input.closed_form) {
    constexpr double room = 1 / 0.9;
    width = 2 * room * input.closed_form->half_width_x;
    height = 2 * room * input.closed_form->half_width_y;
  }
  if (!width) {
    throw sys::InputError("--domain is missing: this body has no closed form to take it from");
  }
  const double stretch = height.value_or(*width) / *width;
  input.problem.grid = grid_ == "hexagonal"
                           ? point_contact::hexagonal_grid(*width, n, stretch)
                           : point_contact::rectangular_grid(*width, stretch * *width, n);
}

PointContactInput PointContactOptions::read(
    const std::optional<parameters::Case>& from_file) const {
  const GivenBodies given(from_file);
  const elasticity::Material material1 = body1_.material.or_else(given.body1);
  const elasticity::Material material2 = body2_.material.or_else(given.body2);
  const double modulus = elasticity::contact_modulus(material1, material2);
  PointContactInput input{
      .material1 = material1,
      .material2 = material2,
      .problem = {Profile::paraboloid(1), modulus, {}, element_named(element_, elements)},
      .profile = profile_.text(),
      .grid = grid_,
      .method = method_,
      .accuracy = {},
      .load = load_.number(),
      .approach = approach_.number(),
      .closed_form = {},
      .curvatures = {},
      .hertz = {}};
  refuse_if(input.approach && load_.number(), "--load and --approach: give one of them");
  refuse_if(!input.approach && !input.load, "--load is missing: give it, or --approach");
  if (input.load) sys::require_positive("load", *input.load);
  refuse_if(input.approach && method_ != "fft", "--approach needs --method fft");
  refuse_if(element_ == "bilinear" && grid_ != "square", "--element bilinear needs --grid square");
  refuse_if(method_ == "matrix-inversion" && tolerance_.number(),
            "--tolerance has no meaning for --method matrix-inversion");
  if (!depths_.empty()) input.depths = parse_numbers("--depths", depths_);
  for (const double depth : input.depths) sys::require_positive("depth", depth);
  input.is_second_body = body_ == "2";
  refuse_if(input.is_second_body && depths_.empty(), "--body needs --depths");
  input.accuracy.tolerance = tolerance_.number().value_or(input.accuracy.tolerance);
  point_contact::require_tolerance(input.accuracy.tolerance);
  const long n_threads = threads_.integer().value_or(1);
  refuse_if(n_threads < 1 || n_threads > most_threads,
            fmt::format("--threads = {}: must be from 1 to {}", n_threads, most_threads));
  input.accuracy.n_threads = static_cast<int>(n_threads);
  set_profile(input, given);
  set_grid(input);
  return input;
}

}  // namespace app
