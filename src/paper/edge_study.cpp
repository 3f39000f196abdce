// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/edge_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "elasticity/piecewise_linear_load.hpp"
#include "line_contact/graded_contact.hpp"
#include "numerics/dense_lu.hpp"
#include "numerics/scatter.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/prelude.hpp"

namespace paper {
namespace {

constexpr std::array n_elements = {12L, 25L, 50L, 100L};  // over the half-width

// Where the nodes lie, from −1 to 1.
double evenly(double t) {
  return t;
}
double by_sine(double t) {
  return std::sin(std::numbers::pi / 2 * t);
}
double more_closely(double t) {
  return by_sine(by_sine(t));
}

std::vector<double> nodes_up_to(double edge, long n, double (*place)(double)) {
  std::vector<double> x;
  for (long j = -n; j <= n; ++j) {
    x.push_back(edge * place(static_cast<double>(j) / static_cast<double>(n)));
  }
  return x;
}

// What eq. (1a) lacks at the last node, beside the one in the middle, a length.
double misfit_at_edge(const ContactCase& c, const std::vector<double>& x,
                      const std::vector<double>& pressure) {
  const double edge = x.back();
  const double middle = x[x.size() / 2];
  double rise = 0;  // of Σ V p, lengths over the half-width
  for (std::size_t e = 0; e + 1 < x.size(); ++e) {
    const auto at_edge =
        elasticity::element_potential((x[e] - edge) / edge, (x[e + 1] - edge) / edge);
    const auto in_middle =
        elasticity::element_potential((x[e] - middle) / edge, (x[e + 1] - middle) / edge);
    rise += (at_edge.begin - in_middle.begin) * pressure[e] +
            (at_edge.end - in_middle.end) * pressure[e + 1];
  }
  const double modulus = std::numbers::pi / 2 * c.cylinders.contact_modulus();
  const line_contact::Profile profile = c.cylinders.profile();
  return edge * rise / modulus - (profile.gap(edge) - profile.gap(middle));
}

// The half-width of the grid on which eq. (1a) holds at its ends too, by the secant method.
double edge_that_fits(const ContactCase& c, const Hertz& hertz, long n, double (*place)(double)) {
  constexpr double tolerance = 1e-9;
  constexpr int most_steps = 30;
  const auto misfit = [&](double edge) {
    const std::vector<double> x = nodes_up_to(edge, n, place);
    return misfit_at_edge(c, x, pressures_on_nodes(c, x));
  };
  double before = 0.999 * hertz.half_width();
  double edge = hertz.half_width();
  double misfit_before = misfit(before);
  for (int step = 0; step < most_steps; ++step) {
    const double found = misfit(edge);
    const double next = edge - found * (edge - before) / (found - misfit_before);
    before = edge;
    misfit_before = found;
    edge = next;
    if (std::abs(edge / before - 1) < tolerance) break;
  }
  return edge;
}

EdgeErrors errors_of_triangles(const ContactCase& c, const Hertz& hertz, double (*place)(double),
                               bool is_edge_known) {
  constexpr double of_system = 1e-9;
  // Rounding moves an edge that is found by 2e-11 of itself, seen in other units.
  constexpr double of_edge = 1e-10;
  EdgeErrors errors;
  for (const long n : n_elements) {
    const double edge = is_edge_known ? hertz.half_width() : edge_that_fits(c, hertz, n, place);
    const std::vector<double> x = nodes_up_to(edge, n, place);
    const std::vector<double> pressure = pressures_on_nodes(c, x);
    double largest = 0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
      const double error = pressure[i] - hertz.pressure(x[i]);
      largest = std::max(largest, std::abs(error) / hertz.peak_pressure());
    }
    errors.elements.push_back(static_cast<double>(n));
    errors.largest.push_back(largest);
    // A pressure that goes with √(2d) at the distance d from the edge changes most at the last
    // node.
    const double last = 1 - x[x.size() - 2] / edge;
    const double moved = is_edge_known ? 0 : of_edge / std::sqrt(2 * last);
    errors.bounds.push_back(of_system + moved + rounded(c, 1));
  }
  return errors;
}

// Rounding leaves 2e-6 in the pressures at 300 elements and 1e-5 at 500, as the cube of their
// number (line_contact/graded_contact.hpp), and so less than 1e-7 at 100; this bound has a margin.
// At the edge it is 6 times its square in the half-width, as 0.23/n² is of 0.30/n⁴. The peak goes
// with the load over the half-width.
constexpr double of_graded_pressure = 4e-7;
constexpr double of_graded_width = 2.4e-11;

struct Graded {
  EdgeErrors pressure;
  std::vector<double> half_width, peak;
};

Graded errors_of_graded(const ContactCase& c, const Hertz& hertz) {
  const double a = hertz.half_width();
  Graded graded;
  for (const long n : n_elements) {
    const line_contact::GradedSolution s = line_contact::solve_on_graded_grid(
        c.cylinders.profile(), c.cylinders.contact_modulus(), c.line_load, n, {-1.3 * a, 1.3 * a});
    double largest = 0;
    for (Eigen::Index i = 0; i < s.x.size(); ++i) {
      const double error = s.pressure[i] - hertz.pressure(s.x[i]);
      largest = std::max(largest, std::abs(error) / hertz.peak_pressure());
    }
    graded.pressure.elements.push_back(static_cast<double>(n));
    graded.pressure.largest.push_back(largest);
    graded.pressure.bounds.push_back(of_graded_pressure);
    graded.half_width.push_back(std::abs(s.half_width() / a - 1));
    graded.peak.push_back(std::abs(s.peak_pressure() / hertz.peak_pressure() - 1));
  }
  return graded;
}

Measured order_of(const EdgeErrors& errors) {
  std::vector<Estimate> largest;
  for (std::size_t i = 0; i < errors.largest.size(); ++i) {
    largest.push_back({errors.largest[i], errors.bounds[i]});
  }
  return numerics::fit_scattered_power(errors.elements, largest, "grids").order;
}

Criterion of_order(const char* what, const EdgeErrors& errors, double expected) {
  return is_of_order(what, order_of(errors), expected);
}

void check_graded(Document& document, const Graded& graded) {
  const auto small = [&](const char* what, double error, double limit) {
    return Criterion::at_most(
        what, Value({error, of_graded_pressure}, scientific(1).rounded_up()),
        {LimitKind::choice, limit, "what was found on the finest grid, with a margin"});
  };
  document.check(
      "graded-grid-removes-the-edge-error",
      {small("largest error of the pressure, over the peak", graded.pressure.largest.back(), 1e-4),
       small("of the half-width", graded.half_width.back(), 1e-5),
       small("of the peak", graded.peak.back(), 1e-5)},
      "graded elements have no error of order 1/2 at the edge");
}

}  // namespace

std::vector<double> pressures_on_nodes(const ContactCase& c, const std::vector<double>& nodes) {
  const auto n = static_cast<Eigen::Index>(nodes.size());
  const auto at = [&](Eigen::Index i) { return nodes[static_cast<std::size_t>(i)]; };
  const line_contact::Profile profile = c.cylinders.profile();
  const double half_span = (nodes.back() - nodes.front()) / 2;

  // Assemble Σ V φ + δ = h at the inner nodes and Σ w φ = 2P/(πE*), lengths over the half-span
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n - 1, n - 1);
  Eigen::VectorXd right_side(n - 1);
  for (Eigen::Index e = 0; e + 1 < n; ++e) {
    const double length = (at(e + 1) - at(e)) / half_span;
    const bool has_begin = e > 0;
    const bool has_end = e + 2 < n;
    for (Eigen::Index i = 1; i + 1 < n; ++i) {
      const auto v = elasticity::element_potential((at(e) - at(i)) / half_span,
                                                   (at(e + 1) - at(i)) / half_span);
      if (has_begin) matrix(i - 1, e - 1) += v.begin;
      if (has_end) matrix(i - 1, e) += v.end;
    }
    if (has_begin) matrix(n - 2, e - 1) += length / 2;
    if (has_end) matrix(n - 2, e) += length / 2;
  }
  matrix.col(n - 2).head(n - 2).setOnes();
  for (Eigen::Index i = 1; i + 1 < n; ++i) right_side[i - 1] = profile.gap(at(i)) / half_span;
  right_side[n - 2] =
      2 * c.line_load / (std::numbers::pi * c.cylinders.contact_modulus() * half_span);

  // Solve, and turn φ = 2p/(πE*) into pressures
  const Eigen::VectorXd unknowns = numerics::DenseLu(matrix).solve(right_side);
  std::vector<double> pressure(nodes.size(), 0.0);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    pressure[static_cast<std::size_t>(i)] =
        std::numbers::pi * c.cylinders.contact_modulus() / 2 * unknowns[i - 1];
  }
  return pressure;
}

void study_edge(Document& document, const ContactCase& c, const Hertz& hertz) {
  const EdgeErrors even = errors_of_triangles(c, hertz, evenly, true);
  const EdgeErrors sine = errors_of_triangles(c, hertz, by_sine, true);
  const EdgeErrors closer = errors_of_triangles(c, hertz, more_closely, true);
  const EdgeErrors unknown = errors_of_triangles(c, hertz, more_closely, false);
  const Graded graded = errors_of_graded(c, hertz);

  std::vector<Column> columns{Column::text("nodes")};
  for (const long n : n_elements) {
    columns.push_back(Column(std::to_string(n), fixed(3))
                          .under("largest error ($10^{-3}$) by number of elements"));
  }
  columns.push_back(Column("order", uncertain()));
  literate::Table table("graded", columns);
  const auto add = [&](const char* nodes, const EdgeErrors& errors, bool is_power = true) {
    std::vector<Cell> row{literate::Cell::latex(nodes)};
    for (std::size_t i = 0; i < errors.largest.size(); ++i) {
      row.emplace_back(1e3 * Estimate{errors.largest[i], errors.bounds[i]});
    }
    row.push_back(is_power ? Cell(order_of(errors)) : Cell::latex("--"));
    table.add_row(row);
  };
  add("evenly spaced", even);
  add("$x = a\\sin\\theta$", sine);
  add("closer still", closer);
  add("closer still, edge unknown", unknown, false);
  add("the same, parabolas", graded.pressure);
  document.table(std::move(table));

  document.value("graded.width-order",
                 Value(order_of({graded.pressure.elements, graded.half_width,
                                 std::vector<double>(graded.half_width.size(), of_graded_width)}),
                       uncertain()));
  document.claim("graded-order",
                 {.route = "powers fitted to the largest errors of the pressure against Hertz, on "
                           "grids of a dozen to a hundred elements over the half-width",
                  .expected = Verdict::confirmed,
                  .criteria = {of_order("order, evenly spaced grid of triangles", even, 0.5),
                               of_order("graded grid of triangles", sine, 1),
                               of_order("closer still, with parabolas and the edge as an unknown",
                                        graded.pressure, 2)}});
  check_graded(document, graded);
}

}  // namespace paper
