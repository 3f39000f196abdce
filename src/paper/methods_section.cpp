// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"
#include "paper/bounds.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using Eigen::Index;
using line_contact::Problem;
using line_contact::Solution;

// The same discrete contact by three methods.
void register_methods(Document& document, const ContactCase& c, const Hertz& hertz) {
  constexpr Index n_nodes = 181;
  const Problem problem{c.cylinders.profile(), c.cylinders.contact_modulus(),
                        line_contact::grid_around(hertz.half_width(), n_nodes)};
  const Solution inversion = line_contact::solve_by_matrix_inversion(problem, c.line_load);
  const Solution least = line_contact::solve_by_variational_method(problem, c.line_load);
  const Solution fast = line_contact::solve_by_fft(problem, c.line_load);

  // The differences are nothing but rounding and what the methods leave over.
  double pressure = 0;
  double approach = 0;
  const auto difference = [&](const Solution& other) {
    const double largest = (other.pressure - inversion.pressure).lpNorm<Eigen::Infinity>();
    pressure = std::max(pressure, largest / hertz.peak_pressure());
    approach =
        std::max(approach, std::abs(other.approach(c.datum) / inversion.approach(c.datum) - 1));
  };
  difference(least);
  difference(fast);
  const double of_pressures =
      pressure_error(inversion) + std::max(pressure_error(least), pressure_error(fast));
  document.value("methods.pressure",
                 Value(pressure + of_pressures, scientific(1).rounded_up()).as_is());
  document.value("methods.nodes", Value(n_nodes, integer()));
  document.value("methods.in-contact", Value(inversion.n_in_contact(), integer()));
  document.value("methods.approach", Value(approach, scientific(1).rounded_up()).as_is());
  document.check(
      "three-methods-agree",
      {Criterion::at_most("largest difference of the pressures, over p0",
                          Value(Estimate{pressure, of_pressures}, scientific(1).rounded_up()),
                          {LimitKind::choice, 1e-9,
                           "ten times the tolerance of the iterations; all three solve the same "
                           "discrete problem"}),
       Criterion::at_most("largest difference of the approach, relative",
                          Value(approach, scientific(1).rounded_up()).as_is(),
                          {LimitKind::choice, 1e-12, "what was found, with a margin"})},
      "three methods give the same pressures and the same approach");
}

}  // namespace

void compute_methods(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const Hertz hertz(c.cylinders, c.line_load);
  register_methods(document, c, hertz);
}

}  // namespace paper
