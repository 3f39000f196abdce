// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "elasticity/stress.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/element.hpp"
#include "line_contact/methods.hpp"
#include "line_contact/solution.hpp"
#include "numerics/fit.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using line_contact::Element;
using line_contact::Grid;
using line_contact::Solution;

constexpr double inner_part = 0.9;  // of the half-width, where the pressure is smooth
constexpr double domain = 2.2;      // half-widths that a grid covers

// An order of convergence or a factor, with the standard uncertainty from its scatter.
struct Scattered {
  double value, standard;

  Number number() const { return number_with(value, standard); }
};

Scattered mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  for (const double v : values) squares += std::pow(v - sum / n, 2);
  return {sum / n, std::sqrt(squares / (n - 1) / n)};
}

// The order r of errors proportional to elements^−r.
Scattered order_of(const std::vector<double>& elements, const std::vector<double>& errors) {
  const numerics::PowerLaw law = numerics::fit_power(elements, errors);
  return {law.order, law.order_standard};
}

Solution solve(const ContactCase& c, const Grid& grid, Element element) {
  return line_contact::solve_by_fft(
      {c.cylinders.profile(), c.cylinders.contact_modulus(), grid, element}, c.line_load, 1e-12);
}

// A grid of n nodes with n/domain + `more` elements over the half-width, 0 ≤ more ≤ 1.
Grid grid_with(const Hertz& hertz, long n_nodes, double more) {
  return {.n_nodes = n_nodes,
          .spacing = hertz.half_width() / (static_cast<double>(n_nodes) / domain + more)};
}

// --- At the nodes

// The errors of one solution against Hertz: relative, or over p₀.
using NodalErrors = std::array<double, 3>;
enum Quantity : std::size_t { inside, by_moment, greatest_error };
constexpr std::array<const char*, 3> names_of_errors = {
    "pressure, inside", "half-width by second moment", "pressure, largest"};
constexpr std::array<double, 3> expected_orders = {2, 2, 0.5};

NodalErrors errors_at_nodes(const Hertz& hertz, const Solution& solution) {
  double squares = 0, greatest = 0;
  int n_inside = 0;
  for (Eigen::Index i = 0; i < solution.grid.n_nodes; ++i) {
    const double x = solution.grid.x(i);
    const double error = (solution.pressure[i] - hertz.pressure(x)) / hertz.peak_pressure();
    greatest = std::max(greatest, std::abs(error));
    if (std::abs(x) > inner_part * hertz.half_width()) continue;
    squares += error * error;
    ++n_inside;
  }
  return {std::sqrt(squares / n_inside), solution.half_width() / hertz.half_width() - 1, greatest};
}

// The errors at one spacing for many positions of the edge between two nodes. In every other one
// the middle of the contact is a node.
struct AtSpacing {
  double elements = 0;  // a/c, the geometric mean
  std::vector<NodalErrors> errors;

  // The root mean square of an error over every `step`-th position from `first` on.
  double mean(std::size_t which, std::size_t first = 0, std::size_t step = 1) const {
    double squares = 0;
    int n = 0;
    for (std::size_t k = first; k < errors.size(); k += step, ++n) {
      squares += errors[k][which] * errors[k][which];
    }
    return std::sqrt(squares / n);
  }
};
using Study = std::vector<AtSpacing>;

constexpr int n_places = 20;
constexpr std::array spacings = {133L, 179L, 241L, 335L, 447L, 607L, 881L};  // nodes

Study study_of(const ContactCase& c, const Hertz& hertz, Element element) {
  Study study;
  for (const long n_nodes : spacings) {
    AtSpacing at;
    double logarithms = 0;
    for (int k = 0; k < n_places; ++k) {
      const Grid grid = grid_with(hertz, n_nodes + k % 2, static_cast<double>(k) / n_places);
      at.errors.push_back(errors_at_nodes(hertz, solve(c, grid, element)));
      logarithms += std::log(hertz.half_width() / grid.spacing);
    }
    at.elements = std::exp(logarithms / n_places);
    study.push_back(at);
  }
  return study;
}

Scattered order_of(const Study& study, std::size_t which) {
  std::vector<double> elements, errors;
  for (const AtSpacing& at : study) {
    elements.push_back(at.elements);
    errors.push_back(at.mean(which));
  }
  return order_of(elements, errors);
}

// A mean over the spacings. Its uncertainty combines their scatter with half the difference between
// even and odd positions, which averaging does not reduce because the positions are the same at
// each spacing.
template <class Found>
Scattered mean_over(const Study& study, const Found& found) {
  std::vector<double> all;
  double squares = 0;
  for (std::size_t i = 0; i < study.size(); ++i) {
    all.push_back(found(i, 0, 1));
    squares += std::pow((found(i, 0, 2) - found(i, 1, 2)) / 2, 2);
  }
  const Scattered mean = mean_of(all);
  const double of_places = std::sqrt(squares / static_cast<double>(study.size()));
  return {mean.value, std::hypot(mean.standard, of_places)};
}

// B in the error B(c/a)^r with the expected order r.
Scattered factor_of(const Study& study, std::size_t which) {
  return mean_over(study, [&](std::size_t i, std::size_t first, std::size_t step) {
    return study[i].mean(which, first, step) * std::pow(study[i].elements, expected_orders[which]);
  });
}

Scattered ratio_of(const Study& study, const Study& other, std::size_t which) {
  return mean_over(study, [&](std::size_t i, std::size_t first, std::size_t step) {
    return study[i].mean(which, first, step) / other[i].mean(which, first, step);
  });
}

void compare_at_nodes(Document& document, const Study& triangular, const Study& uniform) {
  literate::Table table(
      "element-orders",
      {Column::text("error of"), Column("$r$", uncertain()).under("triangles"),
       Column("$B$", uncertain()).under("triangles"), Column("$r$", uncertain()).under("uniform"),
       Column("ratio of $B$", uncertain())});
  for (const std::size_t which : {inside, by_moment, greatest_error}) {
    table.add_row({names_of_errors[which], order_of(triangular, which).number(),
                   factor_of(triangular, which).number(), order_of(uniform, which).number(),
                   ratio_of(triangular, uniform, which).number()});
  }
  document.table(std::move(table));
  const Number ratio = ratio_of(triangular, uniform, inside).number();
  document.value("elements.inside-ratio", Value(ratio, uncertain()));
  document.value("elements.n-places", Value(n_places, integer()));
  document.value("elements.n-spacings", Value(std::ssize(spacings), integer()));
  const auto count = [&](const char* key, const AtSpacing& at) {
    document.value(key, Value(at.elements, fixed(0)).as_is());
  };
  count("elements.coarsest", triangular.front());
  count("elements.finest", triangular.back());
  document.claim(
      "pressure-at-the-nodes",
      {.route =
           "root mean squares of the errors against Hertz over many positions of the edge, with "
           "and without a node in the middle, on grids of 60 to 400 elements over the "
           "half-width",
       .expected = Verdict::holds,
       .criteria = {
           is_of_order("order of the error inside, triangles",
                       order_of(triangular, inside).number(), 2),
           is_of_order("order of the error inside, uniform elements",
                       order_of(uniform, inside).number(), 2),
           Criterion::at_least(
               "error inside, triangles over uniform elements", Value(ratio, uncertain()),
               Limit(1, LimitKind::data, "a ratio below 1 would be a gain").counting(2))}});
}

// --- Between the nodes

// Mean absolute errors over |x| ≤ 0.9 a: of the surface slope, relative to a/R, and of the greatest
// shear half a spacing beneath it, relative to p₀.
struct BetweenErrors {
  double slope, shear;
};

// The stress beneath a solution; uniform elements are strips.
elasticity::Stress stress_at(const Solution& solution, double x, double z) {
  if (solution.element == Element::triangular) return line_contact::stress_beneath(solution, x, z);
  const Grid& grid = solution.grid;
  elasticity::Stress sum;
  for (Eigen::Index i = 0; i < grid.n_nodes; ++i) {
    const double p = solution.pressure[i];
    if (p == 0) continue;
    const std::array ends{grid.x(i) - grid.spacing / 2, grid.x(i) + grid.spacing / 2};
    sum += elasticity::stress_beneath(ends, std::array{p, p}, x, z);
  }
  return sum;
}

// Uses the midpoint rule with n_points per element, on one side only because of symmetry. At the
// ends of uniform elements the slope has a logarithmic singularity; no point lies there.
BetweenErrors mean_errors(const ContactCase& c, const Hertz& hertz, const Solution& solution,
                          int n_points) {
  const line_contact::McEwen mcewen(hertz);
  const Grid& grid = solution.grid;
  const double curvature = c.cylinders.relative_curvature();
  const double z = grid.spacing / 2;
  BetweenErrors sum{0, 0};
  int n = 0;
  for (Eigen::Index i = grid.n_nodes / 2; i + 1 < grid.n_nodes; ++i) {
    for (int k = 0; k < n_points; ++k) {
      const double x = grid.x(i) + (k + 0.5) / n_points * grid.spacing;
      if (x > inner_part * hertz.half_width()) continue;
      const double slope = line_contact::surface_slope(solution, x);
      sum.slope += std::abs(slope + curvature * x) / (curvature * hertz.half_width());
      sum.shear +=
          std::abs(stress_at(solution, x, z).max_shear() - mcewen.stress(x, z).max_shear()) /
          hertz.peak_pressure();
      ++n;
    }
  }
  return {sum.slope / n, sum.shear / n};
}

// Beside a logarithmic singularity the error of the midpoint rule is proportional to the distance
// of its points; extrapolation removes it.
BetweenErrors errors_between_nodes(const ContactCase& c, const Hertz& hertz,
                                   const Solution& solution) {
  const BetweenErrors coarse = mean_errors(c, hertz, solution, 8);
  const BetweenErrors fine = mean_errors(c, hertz, solution, 16);
  return {2 * fine.slope - coarse.slope, 2 * fine.shear - coarse.shear};
}

struct BetweenStudy {
  std::vector<double> elements, slope, shear;
};

BetweenStudy study_between(const ContactCase& c, const Hertz& hertz, Element element) {
  BetweenStudy study;
  for (const long n_nodes : {133L, 187L, 265L}) {
    for (const double more : {0.0, 1. / 3, 2. / 3}) {
      const Grid grid = grid_with(hertz, n_nodes, more);
      const BetweenErrors errors = errors_between_nodes(c, hertz, solve(c, grid, element));
      study.elements.push_back(hertz.half_width() / grid.spacing);
      study.slope.push_back(errors.slope);
      study.shear.push_back(errors.shear);
    }
  }
  return study;
}

void compare_between_nodes(Document& document, const ContactCase& c, const Hertz& hertz) {
  const BetweenStudy triangular = study_between(c, hertz, Element::triangular);
  const BetweenStudy uniform = study_between(c, hertz, Element::uniform);
  document.value("elements.count", Value(triangular.elements.front(), fixed(0)).as_is());
  document.value("elements.most-count", Value(triangular.elements.back(), fixed(0)).as_is());
  std::vector<Criterion> orders;
  const auto add = [&](const std::string& what, const BetweenStudy& study, double expected) {
    const auto one = [&](const std::string& error, const std::vector<double>& errors) {
      document.value("between." + error + "." + what, Value(errors.front(), scientific(2)).as_is());
      orders.push_back(is_of_order("order of the " + error + ", " + what,
                                   order_of(study.elements, errors).number(), expected));
    };
    one("slope", study.slope);
    one("shear", study.shear);
  };
  add("triangles", triangular, 2);
  add("uniform", uniform, 1);
  document.claim("triangles-gain-between-nodes",
                 {.route = "powers fitted to the mean errors of the slope and of the shear stress "
                           "at the depth c/2, on grids of 60 to 120 elements over the half-width",
                  .expected = Verdict::holds,
                  .criteria = orders});
}

}  // namespace

void compute_elements(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const Hertz hertz(c.cylinders, c.line_load);
  compare_at_nodes(document, study_of(c, hertz, Element::triangular),
                   study_of(c, hertz, Element::uniform));
  compare_between_nodes(document, c, hertz);
}

}  // namespace paper
