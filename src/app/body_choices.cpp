// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/point_contact_options.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/csv_files.hpp"
#include "point_contact/closed_forms/revolution.hpp"
#include "system/require.hpp"

namespace app {
namespace {

using point_contact::Profile;

constexpr double infinite = std::numeric_limits<double>::infinity();

ChosenBody cone(const ChoiceOption& given, const Pressing& pressing) {
  const double slope = given.number("--slope");
  const Profile profile = Profile::cone(slope);
  const auto [load, exact] = pressed(pressing, 0.5, [&](double p) {
    return point_contact::Cone(pressing.contact_modulus, slope, p);
  });
  return {profile, {{"cone", exact.radius(), exact.radius(), infinite, exact.approach(), load}}};
}

ChosenBody flat_punch(const ChoiceOption& given, const Pressing& pressing) {
  const double radius = given.number("--flat");
  const Profile profile = Profile::flat_punch(radius);
  const auto [load, exact] = pressed(pressing, 1, [&](double p) {
    return point_contact::FlatPunch(pressing.contact_modulus, radius, p);
  });
  return {profile, {{"flat-punch", radius, radius, infinite, exact.approach(), load}}};
}

ChosenBody rounded_punch(const ChoiceOption& given, const Pressing& /*pressing*/) {
  const double flat = given.number("--flat");
  const double radius = sys::require_positive("edge-radius", given.number("--edge-radius"));
  return {Profile::rounded_punch(flat, 1 / radius)};
}

ChosenBody power_law(const ChoiceOption& given, const Pressing& pressing) {
  const int n = given.integer("--power", 1, Profile::max_power);
  const double coefficient = given.number("--coefficient");
  const Profile profile = Profile::power_law(coefficient, n);
  const auto [load, exact] = pressed(pressing, 2.0 * n / (2 * n + 1), [&](double p) {
    return point_contact::PowerLaw(pressing.contact_modulus, coefficient, n, p);
  });
  // The pressure is greatest inside, between the middle and the edge if n > 1.
  double peak = 0;
  constexpr int enough = 4000;
  for (int i = 0; i < enough; ++i) {
    peak = std::max(peak, exact.pressure(exact.radius() * i / enough));
  }
  return {profile, {{"power", exact.radius(), exact.radius(), peak, exact.approach(), load}}};
}

ChosenBody measured_gaps(const ChoiceOption& given, const Pressing& /*pressing*/) {
  const double spacing = sys::require_positive("spacing", given.number("--spacing"));
  return {Profile::height_map(read_grid(given.argument()), spacing)};
}

ChosenBody measured_heights(const ChoiceOption& given, const Pressing& /*pressing*/) {
  const double spacing = sys::require_positive("spacing", given.number("--spacing"));
  const auto heights = read_grid(given.argument());
  return {Profile::height_map(heights.maxCoeff() - heights, spacing)};
}

}  // namespace

const std::vector<BodyChoice>& body_choices() {
  const ChoiceFlag flat = {"--flat", "Flat and rounded punch: radius of its flat end"};
  const ChoiceFlag spacing = {"--spacing", "Measured surface: distance between its points"};
  static const std::vector<BodyChoice> choices = {
      {{"sphere", "", {{"--angle", "Degrees from the x axis of body 1 to that of body 2 [0]"}}},
       true,
       nullptr},
      {{"cone", "", {{"--slope", "Cone: tangent of the angle between its side and the surface"}}},
       true,
       cone},
      {{"flat-punch", "", {flat}}, true, flat_punch},
      {{"rounded-punch",
        "",
        {flat, {"--edge-radius", "Rounded punch: radius of its edge's rounding"}}},
       true,
       rounded_punch},
      {{"power",
        "",
        {{"--power", "Power law A r^2n: n"}, {"--coefficient", "Power law A r^2n: A"}}},
       true,
       power_law},
      {{"file", "PATH", {spacing}}, false, measured_gaps},
      {{"heights", "PATH", {spacing}}, false, measured_heights}};
  return choices;
}

}  // namespace app
