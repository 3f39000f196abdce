// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "line_contact/dense_methods.hpp"
#include "line_contact/fft_solver.hpp"
#include "line_contact/influence_operator.hpp"
#include "paper/bounds.hpp"
#include "paper/convergence.hpp"
#include "paper/sections.hpp"

namespace paper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
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

// What the rounding of displacements would do to the pressure, over its peak: the gap from them,
// less the gap from their differences, as a pressure with an unchanged load.
double rounding_of_displacements(const Problem& problem, const Solution& solution) {
  const VectorXd in_contact = (solution.pressure.array() > 0).cast<double>().matrix();
  const VectorXd phi = solution.pressure / solution.pressure_per_phi;
  line_contact::InfluenceOperator influence(problem.element, phi.size());
  VectorXd misfit, change, uniform_answer;
  influence.potentials(phi, misfit);
  for (Index i = 0; i < phi.size(); ++i) {
    misfit[i] = problem.profile.gap(problem.grid.x(i)) - misfit[i] - solution.gap[i];
  }
  misfit.array() -= misfit.dot(in_contact) / in_contact.sum();
  influence.precondition(misfit.cwiseProduct(in_contact), change);
  influence.precondition(in_contact, uniform_answer);
  change -= change.dot(in_contact) / uniform_answer.dot(in_contact) * uniform_answer;
  return change.cwiseProduct(in_contact).lpNorm<Eigen::Infinity>() / phi.maxCoeff();
}

void register_large_grids(Document& document, const ContactCase& c, const Hertz& hertz) {
  std::vector<double> n, rounding;
  std::vector<int> products;
  double left_over = 0;
  for (const int power : {7, 10, 13, 16}) {
    const Index n_nodes = Index{1} << power;
    const Problem problem{
        c.cylinders.profile(), c.cylinders.contact_modulus(),
        line_contact::grid_of_width(cylinder_domain * hertz.half_width(), n_nodes)};
    const Solution solution = line_contact::solve_by_fft(problem, c.line_load);
    n.push_back(static_cast<double>(n_nodes));
    rounding.push_back(rounding_of_displacements(problem, solution));
    products.push_back(solution.work.products);
    left_over = solution.residuals.pressure / hertz.peak_pressure();
  }
  const auto [least, most] = std::minmax_element(products.begin() + 1, products.end());
  document.value("large.nodes", Value(std::lround(n.back()), integer()));
  document.value("large.growth", Value(std::lround(n.back() / n.front()), integer()));
  document.value("large.products.coarsest", Value(products.front(), integer()));
  document.value("large.products.least", Value(*least, integer()));
  document.value("large.products.most", Value(*most, integer()));
  document.value("large.rounding", Value(rounding.back(), scientific(1)).as_is());
  document.value("large.left-over", Value(left_over, scientific(1).rounded_up()).as_is());
  document.value("large.tolerance", Value(line_contact::default_tolerance, exact()));
  document.check(
      "work-does-not-grow",
      {Criterion::at_most(
           "products on the finest grid", Value(products.back(), integer()),
           {LimitKind::method, static_cast<double>(products.front()), "those on the coarsest"}),
       Criterion::at_most("products, at most", Value(*most, integer()),
                          {LimitKind::choice, 30.0, "what was found, with a margin"})},
      "products on the finest grid do not grow with the number of nodes");
  const auto ratio = [&](const char* what, double other, double limit) {
    return Criterion::at_least(what, Value(rounding.back() / other, significant(1)).as_is(),
                               {LimitKind::choice, limit, "so much more that it is no scatter"});
  };
  document.check("differences-keep-the-digits",
                 {ratio("rounding of displacements over what the differences leave", left_over, 5),
                  ratio("over that on the coarsest grid", rounding.front(), 50)},
                 "displacements round the pressure off, in proportion to N; differences do not");
}

}  // namespace

void compute_methods(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const Hertz hertz(c.cylinders, c.line_load);
  register_methods(document, c, hertz);
  register_large_grids(document, c, hertz);
}

}  // namespace paper
