// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bodies.hpp"

#include <fmt/format.h>

#include "config/units.hpp"
#include "system/error.hpp"

namespace app {
namespace {

Material steel(const std::string& which, const std::string& unit, std::vector<std::string>& notes) {
  const Material steel(config::converted(210, "GPa", unit), 0.3);
  notes.push_back(fmt::format("steel is assumed{}: E = {} {}, nu = {} (see --young and --poisson)",
                              which, rounded(steel.young()), unit, steel.poisson()));
  return steel;
}

}  // namespace

std::optional<Material> MaterialFlags::read(const std::optional<Material>& from_case,
                                            const std::string& unit,
                                            const MaterialFlags* of_both) const {
  const bool is_own = of_both == nullptr || young.is_given() || poisson.is_given();
  const Flag& e = young.is_given() || of_both == nullptr ? young : of_both->young;
  const Flag& nu = poisson.is_given() || of_both == nullptr ? poisson : of_both->poisson;
  if (!e.is_given() && !nu.is_given()) return from_case;
  const auto given_e = e.positive(unit), given_nu = nu.quantity("1");
  if (given_nu && !(*given_nu > -1 && *given_nu < 0.5)) {
    nu.refuse("must be between -1 and 0.5, both excluded");
  }
  if (!from_case)
    require_given(
        {is_own && !e.is_given() ? &young : &e, is_own && !nu.is_given() ? &poisson : &nu});
  return Material(given_e ? *given_e : from_case->young(),
                  given_nu ? *given_nu : from_case->poisson());
}

Material read_material(const MaterialFlags& flags, const std::optional<Material>& from_case,
                       const std::string& unit, std::vector<std::string>& notes) {
  const auto material = flags.read(from_case, unit);
  return material ? *material : steel("", unit, notes);
}

std::pair<Material, Material> PairOfMaterials::read(
    const std::optional<parameters::ContactCase>& from_case, const std::string& unit,
    std::vector<std::string>& notes) const {
  const auto read_one = [&](const MaterialFlags& own,
                            parameters::CylinderCase parameters::ContactCase::*body) {
    return own.read(of_case(of_case(from_case, body), &parameters::CylinderCase::material), unit,
                    &both);
  };
  const auto first = read_one(body1, &parameters::ContactCase::body1);
  const auto second = read_one(body2, &parameters::ContactCase::body2);
  if (!first && !second) {
    const Material both_of_steel = steel("", unit, notes);
    return {both_of_steel, both_of_steel};
  }
  return {first ? *first : steel(" for body 1", unit, notes),
          second ? *second : steel(" for body 2", unit, notes)};
}

std::optional<line_contact::Radius> radius_of(const Flag& flag, const std::string& unit) {
  if (flag.text() == "plane") return line_contact::Radius::of_plane();
  const auto length = flag.quantity(unit);
  if (!length) return std::nullopt;
  if (*length == 0) flag.refuse("must be other than 0; 'plane' is a plane");
  return line_contact::Radius::of_cylinder("radius", *length);
}

std::vector<std::string> half_space_warnings(double half_width, double least_radius) {
  constexpr double small = 0.1;
  if (!(least_radius > 0 && half_width > small * least_radius)) return {};
  return {fmt::format(
      "the contact's half-width is {:.2g} of the least radius; half-spaces represent the bodies "
      "well if it is less than {}",
      half_width / least_radius, small)};
}

}  // namespace app
