// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <string>

#include "assignment/exercises/displacement_checks.hpp"
#include "assignment/hidden/reference.hpp"

namespace assignment::displacement {
namespace {

// p₀a/E, the unit of the tolerances of displacements.
double unit_displacement(const Surface& surface) {
  return surface.peak_pressure * surface.half_width / surface.young;
}

// Adds to the tally whether u_z is right at each of these places.
void test_displacement(const Program& program, Surface surface, const Places& places,
                       Tally& tally) {
  surface.shape = places.shape;
  const Numbers x = times(surface.half_width, places.xi);
  const Numbers found = ask(program, surface, x);
  const Numbers reference = displacements(surface, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    tally.part(near(found[i], reference[i], 1e-8 * unit_displacement(surface)),
               place(places.xi[i], places.shape));
  }
}

Outcome displacement_is_right(const Program& program, const std::string& id) {
  Tally tally("u_z is right to 1e-8 of p0 a/E");
  for (const Places& places :
       {Places{shape::triangle, {0.7}}, Places{shape::smooth, {0, -0.3, 0.999, 1.2, 20}},
        Places{shape::one_sided, {0.001, 0.7, -0.99, 1, -3, -200}},
        Places{waves(id), {0.2, -0.8, 1.5}}}) {
    test_displacement(program, surface_of(id), places, tally);
  }
  return tally.outcome();
}

Outcome displacement_is_right_elsewhere(const Program& program, const std::string& id) {
  const OwnNumbers other = own_numbers(id);
  Surface surface{other.young2, other.poisson2, 0.37 * other.peak_pressure, 2.3 * other.half_width,
                  0};
  Tally tally("u_z is right to 1e-8 of p0 a/E for a different material, size and datum");
  for (const double datum : {0.45, 1.0, -2.5, 60.0}) {
    surface.datum = datum * surface.half_width;
    Tally of_datum("");
    test_displacement(program, surface, {shape::one_sided, {0.1, -0.6, 1.1, 7}}, of_datum);
    tally.part(of_datum.outcome().share == 1, at("datum/a", datum));
  }
  return tally.outcome();
}

}  // namespace

Checks hidden_checks() {
  return {{"displacement-reference", displacement_is_right},
          {"displacement-other", displacement_is_right_elsewhere}};
}

}  // namespace assignment::displacement
