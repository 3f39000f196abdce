// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/point_contact_options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
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

constexpr std::array elements{Element::pyramid, Element::uniform};

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
      profile_(command, "--profile", "sphere",
               "Shape of the gap. sphere: spheres, ellipsoids, crossed cylinders, by their radii; "
               "file: a CSV grid of gaps, a line for each y; heights: of heights above the surface",
               choices_of(body_choices())),
      nodes_(command, "--nodes", "Number of nodes along a side of the domain [256]"),
      domain_(command, "--domain",
              "Width W of the square that the nodes fill [the contact's and a ninth more]"),
      tolerance_(command, "--tolerance",
                 "Error of the pressure allowed, relative to the peak [1e-8]") {
  add_choice(command, "--element", element_, names_of(elements),
             "What stands at a node for the pressure around it");
  add_choice(command, "--method", method_, {"fft", "variational"},
             "How to solve; the last is a reference");
  add_text(command, "--case", case_file_, "FILE",
           "Case file; its materials and radii, which flags override");
}

std::pair<double, double> PointContactOptions::CurvedBody::curvatures(
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
  const auto [x1, y1] = body1_.curvatures(given.body1);
  const auto [x2, y2] = body2_.curvatures(given.body2);
  const double along_x = x1 + x2, along_y = y1 + y2;
  input.is_curved = true;
  input.problem.profile = Profile::elliptic_paraboloid(along_x, along_y);
  input.is_of_revolution = along_x == along_y;
  double greatest = 0;
  for (const double curvature : {x1, y1, x2, y2}) greatest = std::max(greatest, std::abs(curvature));
  input.least_radius = 1 / greatest;
  const point_contact::HertzElliptic hertz(input.problem.contact_modulus, along_x, along_y,
                                           input.load);
  input.closed_form = {
      "hertz", hertz.semi_axis_x(), hertz.semi_axis_y(), hertz.peak_pressure(), hertz.approach(),
      input.load};
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
      choice.choose(profile_, {input.problem.contact_modulus, input.load});
  input.is_of_revolution = choice.is_of_revolution;
  input.problem.profile = std::move(chosen.profile);
  input.closed_form = std::move(chosen.closed_form);
}

void PointContactOptions::set_grid(PointContactInput& input) const {
  constexpr long usual = 256;
  const long n = nodes_.integer().value_or(usual);
  std::optional<double> width = domain_.number();
  double height = width.value_or(0);
  const auto& half_sides = input.problem.profile.half_sides();
  if (!width && std::isfinite(half_sides.x())) {
    width = 2 * half_sides.x();
    height = 2 * half_sides.y();
  } else if (!width && input.closed_form) {
    constexpr double room = 1 / 0.9;
    width = 2 * room * input.closed_form->half_width_x;
    height = 2 * room * input.closed_form->half_width_y;
  }
  if (!width) throw sys::InputError("--domain is missing");
  input.problem.grid = point_contact::rectangular_grid(*width, height, n);
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
      .method = method_,
      .tolerance = tolerance_.number().value_or(point_contact::default_tolerance),
      .load = sys::require_positive("load", load_.number_or({})),
      .closed_form = {}};
  set_profile(input, given);
  set_grid(input);
  return input;
}

}  // namespace app
