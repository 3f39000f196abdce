// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/tasks.hpp"

#include <cmath>
#include <cstddef>

#include "assignment/answers.hpp"

namespace assignment {

using course::Numbers;
using course::Program;

namespace {

double number_of(Shape shape) {
  return static_cast<double>(shape);
}

}  // namespace

Surface surface_of(const course::Variant& variant) {
  return {variant("young1"), variant("poisson1"), variant("peak_pressure"), variant("half_width"),
          variant("datum")};
}

Numbers ask_gradient(const Program& program, const Surface& s, const Numbers& x) {
  const Numbers inputs = joined({s.young, s.poisson, s.peak_pressure, s.half_width}, x);
  return nonzero_answer(program, "gradient", inputs, x.size());
}

Quadratures ask_quadrature(const Program& program, const Surface& s, const Numbers& x) {
  const Numbers inputs =
      joined({s.young, s.poisson, number_of(s.shape), s.peak_pressure, s.half_width}, x);
  const Numbers pairs = nonzero_answer(program, "gradient_by_quadrature", inputs, 2 * x.size());
  Quadratures found;
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    found.value.push_back(pairs[i]);
    found.abs_error.push_back(pairs[i + 1]);
  }
  return found;
}

Numbers ask_displacement(const Program& program, const Surface& s, const Numbers& x) {
  const Numbers inputs =
      joined({s.young, s.poisson, number_of(s.shape), s.peak_pressure, s.half_width, s.datum}, x);
  return nonzero_answer(program, "displacement", inputs, x.size());
}

Numbers ask_influence(const Program& program, double contact_modulus, double spacing, double datum,
                      const Numbers& k) {
  const Numbers inputs = joined({contact_modulus, spacing, datum}, k);
  return nonzero_answer(program, "influence", inputs, k.size());
}

double Cylinders::contact_modulus() const {
  return 1 / ((1 - poisson1 * poisson1) / young1 + (1 - poisson2 * poisson2) / young2);
}

Cylinders cylinders_of(const course::Variant& variant) {
  return {
      variant("young1"),    variant("poisson1"), variant("radius1"),
      variant("young2"),    variant("poisson2"), variant("radius2"),
      variant("line_load"), variant("spacing"),  static_cast<int>(std::lround(variant("nodes"))),
      variant("datum")};
}

ContactAnswer ask_contact(const Program& program, const Cylinders& c) {
  const Numbers inputs = {c.young1,    c.poisson1, c.radius1,
                          c.young2,    c.poisson2, c.radius2,
                          c.line_load, c.spacing,  static_cast<double>(c.n_nodes),
                          c.datum};
  const std::size_t n_before_pressures = 2;
  const Numbers numbers = finite_answer(program, "contact", inputs,
                                        n_before_pressures + static_cast<std::size_t>(c.n_nodes));
  return {
      numbers[0], numbers[1],
      Numbers(numbers.begin() + static_cast<std::ptrdiff_t>(n_before_pressures), numbers.end())};
}

}  // namespace assignment
