// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bodies.hpp"

#include <fmt/core.h>

namespace app {

GivenBodies::GivenBodies(const std::optional<parameters::Case>& from_file) {
  if (!from_file) return;
  body1 = from_file->contact.body1;
  body2 = from_file->contact.body2;
}

MaterialOption::MaterialOption(CLI::App& command, const std::string& number)
    : young(command, "--young" + number,
            "Young's modulus " + (number.empty() ? "E" : "of body " + number)),
      poisson(
          command, "--poisson" + number,
          "Poisson's ratio" + (number.empty() ? ", between -1 and 0.5" : " of body " + number)) {}

elasticity::Material MaterialOption::or_else(
    const std::optional<elasticity::Material>& given) const {
  if (!given) return {young.number_or({}), poisson.number_or({})};
  return {young.number_or(given->young()), poisson.number_or(given->poisson())};
}

elasticity::Material MaterialOption::or_else(
    const std::optional<parameters::CylinderCase>& given) const {
  return or_else(given ? std::optional(given->material) : std::nullopt);
}

std::optional<line_contact::Radius> radius_of(const NumberOption& radius) {
  if (radius.text() == "plane") return line_contact::Radius::of_plane();
  const auto length = radius.number();
  if (!length) return std::nullopt;
  return line_contact::Radius::of_cylinder(radius.flag().c_str() + 2, *length);
}

line_contact::Radius radius_or(const NumberOption& radius,
                               const std::optional<parameters::CylinderCase>& given) {
  if (const auto own = radius_of(radius)) return *own;
  if (given) return given->radius;
  throw sys::InputError(radius.flag() + " is missing: give it, or a --case that has it");
}

std::vector<double> to_vector(const Eigen::VectorXd& numbers) {
  return {numbers.data(), numbers.data() + numbers.size()};
}

std::vector<std::string> half_space_warnings(double half_width, double least_radius) {
  if (!(least_radius > 0 && half_width > small_ratio * least_radius)) return {};
  return {fmt::format(
      "the contact's half-width is {:.2g} of the least radius: half-spaces stand for bodies whose "
      "contact is less than {} of it",
      half_width / least_radius, small_ratio)};
}

}  // namespace app
