// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 4: its task and its public checks. They contain no answers: each tests a property that
// correct numbers have. This header is part of the handout.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "assignment/exercises/displacement_checks.hpp"
#include "assignment/given/bodies.hpp"

namespace assignment::influence {

inline constexpr const char* task = "influence";

/// Returns A_k for each whole number k. The inputs are E* c datum k₁ k₂ …
inline Numbers answer(const Numbers& in) {
  return for_each_from(3, in, [&](double k, Numbers& out) {
    const int distance = static_cast<int>(std::lround(k));
    out.push_back(exercise::influence_coefficient(in[0], in[1], in[2], distance));
  });
}

/// Asks for u_z1 + u_z2 at k spacings from a triangle of pressure 1, for each whole number k.
inline Numbers ask(const Program& program, double contact_modulus, double spacing, double datum,
                   const Numbers& k) {
  const Numbers inputs = joined({contact_modulus, spacing, datum}, k);
  return judge::answer_of(program, task, inputs, k.size());
}

inline Outcome influence_has_the_shape(const Program& program, const std::string& id) {
  const Cylinders c = cylinders_of(id);
  const double datum = 40 * c.spacing;
  const Numbers u = ask(program, c.contact_modulus(), c.spacing, datum,
                        {0, 1, 2, 3, 7, -1, -7, 40, 100, 200, 400});
  const double tolerance = roundings * greatest(u);
  const double fall = u[8] - u[9];

  Tally tally("the coefficients are those of a triangle");
  tally.part(near(u[1], u[5], tolerance) && near(u[4], u[6], tolerance), "k and −k give the same");
  tally.part(u[0] > u[1] && u[1] > u[2] && u[2] > u[3] && u[3] > u[4], "they decrease with k ≥ 0");
  tally.part(near(u[7], 0, tolerance), "zero at the datum");
  tally.part(fall > 0 && near(u[9] - u[10], fall, 1e-3 * fall),
             "far away, they decrease by the same amount with each doubling of k");
  return tally.outcome();
}

inline Outcome influence_refines(const Program& program, const std::string& id) {
  const Cylinders c = cylinders_of(id);
  const double modulus = c.contact_modulus();
  const Numbers k = {0, 1, 2, 3, 4, 5};
  const Numbers large = ask(program, modulus, 2 * c.spacing, c.datum, k);
  Numbers fine_k;
  for (int i = -1; i <= 11; ++i) fine_k.push_back(i);
  const Numbers fine = ask(program, modulus, c.spacing, c.datum, fine_k);
  const auto composed = [&](std::size_t i) {
    return fine[2 * i] / 2 + fine[2 * i + 1] + fine[2 * i + 2] / 2;
  };

  // Compare differences, because the small triangles have different distances from the datum.
  Tally tally(
      "a triangle four spacings wide is the sum of three that are two wide, with weights 1/2, 1, "
      "1/2");
  for (std::size_t i = 1; i < k.size(); ++i) {
    const double scale = large[0] - large[i];
    tally.part(near(large[0] - large[i], composed(0) - composed(i), 100 * roundings * scale),
               at("k", k[i]));
  }
  return tally.outcome();
}

inline Outcome influence_is_displacement(const Program& program, const std::string& id) {
  const Cylinders c = cylinders_of(id);
  const double modulus = c.contact_modulus();
  const Numbers k = {0, 1, 2, 7, 30};
  const Numbers coefficients = ask(program, modulus, c.spacing, c.datum, k);
  // One body with E/(1−ν²) = E* is equivalent to the two.
  const Surface surface{modulus * (1 - c.poisson1 * c.poisson1), c.poisson1, 1, c.spacing, c.datum};
  const Numbers u = displacement::ask(program, surface, times(c.spacing, k));

  Tally tally("the coefficients agree with your displacements of exercise 3");
  for (std::size_t i = 0; i < k.size(); ++i) {
    tally.part(near(coefficients[i], u[i], 1e-7 * greatest(u)), at("k", k[i]));
  }
  return tally.outcome();
}

inline Checks public_checks() {
  return {{"influence-shape", influence_has_the_shape},
          {"influence-refinement", influence_refines},
          {"influence-displacement", influence_is_displacement}};
}

}  // namespace assignment::influence
