// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bodies.hpp"

#include <fmt/format.h>

#include "config/units.hpp"
#include "system/error.hpp"

namespace app {

Material material_of(const std::vector<const MaterialFlags*>& flags,
                     const std::optional<Material>& from_case, const std::string& unit,
                     std::vector<std::string>& assumed) {
  std::optional<double> e, nu;
  for (const MaterialFlags* of : flags) {
    if (!e) e = of->young.positive(unit);
    if (nu) continue;
    nu = of->poisson.quantity("1");
    if (nu && !(*nu > -1 && *nu < 0.5)) {
      of->poisson.refuse("must be between -1 and 0.5, both excluded");
    }
  }
  if (!e && from_case) e = from_case->young();
  if (!nu && from_case) nu = from_case->poisson();
  const std::string& number = flags.front()->number;
  if (!e) {
    e = config::converted(210, "GPa", unit);
    assumed.push_back(fmt::format("E{} = {} {}", number, rounded(*e), unit));
  }
  if (!nu) {
    nu = 0.3;
    assumed.push_back(fmt::format("nu{} = {}", number, *nu));
  }
  return {*e, *nu};
}

std::pair<Material, Material> PairOfMaterialFlags::read(
    const std::optional<parameters::ContactCase>& from_case, const std::string& unit,
    std::vector<std::string>& assumed) const {
  const auto of_body = [&](parameters::CylinderCase parameters::ContactCase::*body) {
    return of_case(of_case(from_case, body), &parameters::CylinderCase::material);
  };
  const Material first =
      material_of({&body1, &both}, of_body(&parameters::ContactCase::body1), unit, assumed);
  return {first,
          material_of({&body2, &both}, of_body(&parameters::ContactCase::body2), unit, assumed)};
}

std::vector<std::string> note_of(const std::vector<std::string>& assumed) {
  if (assumed.empty()) return {};
  return {fmt::format("assumed: {}", fmt::join(assumed, ", "))};
}

std::optional<line_contact::Radius> radius_of(const Flag& flag, const std::string& unit) {
  if (flag.text() == "plane") return line_contact::Radius::of_plane();
  const auto length = flag.quantity(unit);
  if (!length) return std::nullopt;
  if (*length == 0) flag.refuse("must not be 0; write 'plane' for a plane");
  return line_contact::Radius::of_cylinder("radius", *length);
}

std::vector<std::string> half_space_warnings(double half_width, double least_radius) {
  constexpr double small = 0.1;
  if (!(least_radius > 0 && half_width > small * least_radius)) return {};
  return {fmt::format(
      "the contact's half-width is {:.2g} of the least radius; half-spaces represent the bodies "
      "well below {}",
      half_width / least_radius, small)};
}

}  // namespace app
