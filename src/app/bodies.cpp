// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/units.hpp"
#include "system/error.hpp"

namespace app {

elasticity::Material material_of(const MaterialFlags& own, const MaterialFlags& of_both,
                                 const MaterialOfCase& from_case, const std::string& unit,
                                 std::vector<std::string>& notes) {
  const Flag& young = own.young.is_given() ? own.young : of_both.young;
  const Flag& poisson = own.poisson.is_given() ? own.poisson : of_both.poisson;
  if (!young.is_given() && !poisson.is_given()) {
    if (from_case) return *from_case;
    const elasticity::Material steel(config::converted(210, "GPa", unit), 0.3);
    const std::string note =
        fmt::format("steel is assumed: E = {} {}, nu = {} (--young and --poisson change it)",
                    rounded(steel.young()), unit, steel.poisson());
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    return steel;
  }
  for (const Flag* flag : {&young, &poisson}) {
    if (!from_case && !flag->is_given()) throw sys::InputError(flag->name() + " is missing");
  }
  const auto e = young.positive(unit);
  const auto nu = poisson.quantity("1");
  if (nu && !(*nu > -1 && *nu < 0.5)) poisson.refuse("must be between -1 and 0.5, both excluded");
  return {e ? *e : from_case->young(), nu ? *nu : from_case->poisson()};
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
