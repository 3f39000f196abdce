// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/friction.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "line_contact/cattaneo_mindlin.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/friction.hpp"
#include "numerics/scatter.hpp"
#include "paper/bounds.hpp"
#include "paper/convergence.hpp"
#include "paper/prelude.hpp"

namespace paper {
namespace {

using line_contact::CattaneoMindlin;
using line_contact::Solution;
using numerics::fit_scattered_power;

// One load on one grid, against the closed form.
struct SlipErrors {
  double stick;    ///< half-width of the strip that sticks, relative
  double largest;  ///< of q, over μp₀
  double mean;
  double from_edge;  ///< of the largest, to the nearest edge of contact or strip, in spacings
};

// The half-width of what is taken away, p − q/μ, as Solution::half_width does it.
double stick_half_width(const Solution& solution, const line_contact::Friction& friction,
                        double mu) {
  Solution sticking = solution;
  sticking.pressure = solution.pressure - friction.shear / mu;
  return sticking.half_width();
}

struct Slip {
  CattaneoMindlin exact;
  line_contact::Friction friction;
  double stick;
  SlipErrors errors;
};

Slip partial_slip(const Pair& pair, double mu, double share) {
  const double load = share * mu * pair.solution.line_load();
  Slip slip{CattaneoMindlin(pair.hertz, mu, load),
            line_contact::partial_slip(pair.problem, pair.solution, mu, load,
                                       line_contact::solve_by_matrix_inversion),
            0,
            {}};
  slip.stick = stick_half_width(pair.solution, slip.friction, mu);
  slip.errors.stick = slip.stick / slip.exact.stick_half_width() - 1;
  const double c = pair.solution.grid.spacing;
  for (Eigen::Index i = 0; i < pair.solution.grid.n_nodes; ++i) {
    const double x = pair.solution.grid.x(i);
    const double error = std::abs(slip.friction.shear[i] - slip.exact.traction(x)) /
                         (mu * pair.hertz.peak_pressure());
    slip.errors.mean += error * c / (2 * pair.hertz.half_width());
    if (error <= slip.errors.largest) continue;
    slip.errors.largest = error;
    slip.errors.from_edge = std::min(std::abs(std::abs(x) - pair.hertz.half_width()),
                                     std::abs(std::abs(x) - slip.exact.stick_half_width())) /
                            c;
  }
  return slip;
}

// The shear traction under one tangential load, q over μp₀ against x/a.
struct SlipCurve {
  double stick;                      // half-width of the strip that sticks, over a
  std::vector<double> x, shear;      // the closed form
  std::vector<double> node_x, node;  // the elements
};

SlipCurve curve_of(const Pair& pair, double mu, const Slip& slip) {
  const double a = pair.hertz.half_width();
  const double scale = mu * pair.hertz.peak_pressure();
  SlipCurve curve{slip.exact.stick_half_width() / a, {}, {}, {}, {}};
  for (Eigen::Index i = 0; i < pair.solution.grid.n_nodes; ++i) {
    if (pair.solution.pressure[i] == 0) continue;
    curve.node_x.push_back(pair.solution.grid.x(i) / a);
    curve.node.push_back(slip.friction.shear[i] / scale);
  }
  // Both sides of the strip even in their angles: the traction is steep at either end of each.
  constexpr int n = 120;
  const auto add = [&](double begin, double end) {
    for (int i = 0; i <= n; ++i) {
      const double x = (begin + end - (end - begin) * std::cos(std::numbers::pi * i / n)) / 2;
      curve.x.push_back(x);
      curve.shear.push_back(slip.exact.traction(x * a) / scale);
    }
  };
  add(-1, -curve.stick);
  add(-curve.stick, curve.stick);
  add(curve.stick, 1);
  return curve;
}

constexpr double parts_of_sliding[] = {0.3, 0.6, 0.9};

// What the elements make of each load: the strip, and the errors of the shear, over μp₀.
void tabulate(Document& document, const std::vector<Slip>& slips, const Pair& pair) {
  literate::Table table("partial-slip",
                        {Column("$Q/(\\mu P)$", fixed(1)).exact(), Column("$a_s/a$", fixed(4)),
                         Column("$a_s$, relative", fixed(0)).scaled(-6).under("error of"),
                         Column("$q$, largest", fixed(1)).scaled(-3).under("error of"),
                         Column("$q$, mean", fixed(2)).scaled(-3).under("error of")});
  // The shear is the difference of two pressures. What is taken away has its peak in proportion to
  // the strip's half-width aₛ, which is wrong as half_width_error() says with a/aₛ times the error.
  const double of_shears = 2 * pressure_error(pair.solution) + closed_form(1).abs_error;
  const double a = pair.hertz.half_width();
  for (std::size_t k = 0; k < slips.size(); ++k) {
    const double stick = slips[k].exact.stick_half_width() / a;
    const SlipErrors& errors = slips[k].errors;
    // The root of a difference, 1 − Q/(μP).
    const Estimate exact{stick, closed_form(1).abs_error / stick};
    table.add_row({parts_of_sliding[k], exact,
                   Estimate{errors.stick, 1.5 * of_shears / stick + rounded(1)},
                   Estimate{errors.largest, of_shears}, Estimate{errors.mean, of_shears}});
  }
  document.table(std::move(table));
}

// The errors of the middle one of the loads; at each spacing the root mean square over grids on
// which the edge lies anywhere between two nodes.
void fit_slip_orders(Document& document, const ContactCase& c, double mu) {
  constexpr std::array n_nodes = {67L, 95L, 133L, 179L};
  constexpr int n_places = 10;
  const elasticity::Material& material = c.body1.material;
  Pair pair = pair_of(c, material, material);
  std::vector<double> elements;
  std::vector<Estimate> largest, mean;
  for (const long n : n_nodes) {
    std::vector<Estimate> largest_here, mean_here;
    double logarithms = 0;
    for (const line_contact::Grid& grid : grids_of(pair.hertz, n, n_places)) {
      pair.problem.grid = grid;
      pair.solution = line_contact::solve_by_matrix_inversion(pair.problem, pair.line_load);
      const SlipErrors errors = partial_slip(pair, mu, parts_of_sliding[1]).errors;
      // The shear is the difference of two pressures, the second that of a lesser load.
      const double bound = 2 * pressure_error(pair.solution);
      largest_here.push_back({errors.largest, bound});
      mean_here.push_back({errors.mean, bound});
      logarithms += std::log(pair.hertz.half_width() / grid.spacing);
    }
    elements.push_back(std::exp(logarithms / n_places));
    largest.push_back(root_mean_square(largest_here));
    mean.push_back(root_mean_square(mean_here));
  }
  const Measured of_largest = fit_scattered_power(elements, largest, "grids").order;
  const Measured of_mean = fit_scattered_power(elements, mean, "grids").order;
  document.value("slip.fit.share", Value(parts_of_sliding[1], exact()));
  document.value("slip.fit.least", Value(closed_form(elements.front()), fixed(0)));
  document.value("slip.fit.most", Value(closed_form(elements.back()), fixed(0)));
  document.value("slip.fit.largest", Value(of_largest, uncertain()));
  document.value("slip.fit.mean", Value(of_mean, uncertain()));
  const auto agrees = [](const char* what, const Measured& order, double expected) {
    const Limit near(LimitKind::choice, 0.25, "nearer to it than to any other half order");
    return Criterion::agrees(what, Value(order, uncertain()), Value(expected, exact()),
                             near.counting(2));
  };
  document.check("slip-orders",
                 {agrees("order of the largest error", of_largest, 0.5),
                  agrees("order of the mean error", of_mean, 1.5)},
                 "the shear's largest error is of order 1/2, its mean error of order 3/2");
}

// What Cattaneo's and Mindlin's traction does to the surfaces, by eq. (2a) for both bodies, of the
// first one's material. The strain of body 1 less that of body 2, over μa/R, the largest under
// sliding: where they stick it is to be 0, and where they slip body 1 is to stay behind.
struct SlipStrains {
  Estimate in_strip;  // the largest
  long n_points = 0;  // where they slip
  long n_ahead = 0;   // of these, where body 1 does not stay behind
};

SlipStrains slip_strains(const Slip& slip, const Pair& pair, const elasticity::Material& material,
                         double mu) {
  const double a = pair.hertz.half_width();
  const double stick = slip.exact.stick_half_width();
  const auto loaded = [&](double sign) {
    return elasticity::SurfaceQuadrature(
        material,
        elasticity::distributed_load(
            [&](double x) { return pair.hertz.pressure(x); },
            [&slip, sign](double x) { return sign * slip.exact.traction(x); },
            {-a, -stick, 0, stick, a}),
        10 * a);
  };
  const auto body1 = loaded(1);
  const auto body2 = loaded(-1);
  const double scale = 1 / (mu * a * pair.cylinders.relative_curvature());
  const auto strain = [&](double x) {
    return scale * (body1.tangential_gradient(x) - body2.tangential_gradient(x));
  };
  SlipStrains strains;
  for (const double part : {-0.95, -0.6, -0.2, 0.0, 0.37, 0.72, 0.93}) {
    const Estimate found = abs(strain(part * stick));
    strains.in_strip.value = std::max(strains.in_strip.value, found.value);
    strains.in_strip.abs_error = std::max(strains.in_strip.abs_error, found.abs_error);
  }
  for (const double part : {0.05, 0.3, 0.6, 0.95}) {
    const double x = stick + part * (a - stick);
    for (const double side : {-1.0, 1.0}) {
      // From the strip outwards the displacement of body 1 against body 2 decreases.
      const Estimate found = side * strain(side * x);
      ++strains.n_points;
      if (!(found.value < -found.abs_error)) ++strains.n_ahead;
    }
  }
  return strains;
}

// How wrong the strip may be, relatively: the traction that is taken away is the difference of two
// pressures, and the strip carries the square of its share of the load.
double stick_error(const Pair& pair, double stick_half_width) {
  const double share = stick_half_width / pair.hertz.half_width();
  return 2 * half_width_error(pair.solution) / (share * share);
}

}  // namespace

void compute_partial_slip(Document& document, const ContactCase& c, const Pair& own, double mu) {
  Figure figure{.width_cm = 13.5, .height_cm = 5.0};
  std::vector<Slip> slips;
  std::vector<double> sliding_x, sliding;
  Estimate worst_stick;
  double from_edge = 0;
  for (std::size_t k = 0; k < std::size(parts_of_sliding); ++k) {
    slips.push_back(partial_slip(own, mu, parts_of_sliding[k]));
    const SlipCurve curve = curve_of(own, mu, slips[k]);
    figure.data[fmt::format("curve_{}", k + 1)] = {{"x", curve.x}, {"shear", curve.shear}};
    figure.data[fmt::format("nodes_{}", k + 1)] = {{"x", curve.node_x}, {"shear", curve.node}};
    figure.numbers[fmt::format("share_{}", k + 1)] = parts_of_sliding[k];
    figure.numbers[fmt::format("stick_{}", k + 1)] = curve.stick;
    if (k + 1 == std::size(parts_of_sliding)) sliding_x = curve.x;
    const double strip = own.solution.grid.spacing / slips[k].exact.stick_half_width();
    from_edge = std::max(from_edge, slips[k].errors.from_edge);
    const Estimate error{std::abs(slips[k].errors.stick),
                         stick_error(own, slips[k].exact.stick_half_width())};
    const Estimate stick = 1 / (strip * strip) * error;
    if (stick.value > worst_stick.value) worst_stick = stick;
  }
  const double a = own.hertz.half_width();
  for (const double x : sliding_x) {
    sliding.push_back(own.hertz.pressure(x * a) / own.hertz.peak_pressure());
  }
  tabulate(document, slips, own);
  figure.data["sliding"] = {{"x", sliding_x}, {"shear", sliding}};
  document.figure("partial-slip", std::move(figure));
  // As for the half-width of the contact itself (0.36 (c/a)²), with the strip for the contact.
  const char* const what = "largest relative error of the strip's half-width, over its (𝑐/𝑎ₛ)²";
  document.check("strip-of-cattaneo-and-mindlin",
                 {Criterion::at_most(what, Value(worst_stick, fixed(2)),
                                     {LimitKind::choice, 1.0,
                                      "the elements have this order, and errors no larger"})},
                 "the strip that sticks is that of Cattaneo and Mindlin");
  Estimate in_strip;
  long n_points = 0;
  long n_ahead = 0;
  for (const Slip& slip : slips) {
    const SlipStrains strains = slip_strains(slip, own, c.body1.material, mu);
    in_strip.value = std::max(in_strip.value, strains.in_strip.value);
    in_strip.abs_error = std::max(in_strip.abs_error, strains.in_strip.abs_error);
    n_points += strains.n_points;
    n_ahead += strains.n_ahead;
  }
  document.value("slip.strain",
                 Value(in_strip.value + in_strip.abs_error, scientific(1).rounded_up()).as_is());
  document.value("slip.strain.points", Value(n_points, integer()));
  document.value("slip.strain.opposed", Value(n_points - n_ahead, integer()));
  document.check(
      "closed-form-of-partial-slip",
      {Criterion::at_most(
           "largest relative strain of the surfaces where they stick, over μa/R",
           Value(in_strip, scientific(1).rounded_up()),
           {LimitKind::choice, 1e-9, "what the quadrature loses at singular ends"}),
       Criterion::at_most("points of slip at which the friction does not oppose it",
                          Value(n_ahead, exact()), {LimitKind::data, 0.0, "it is a count"})},
      "the traction of Cattaneo and Mindlin makes the surfaces stick and slip as it should");
  document.check(
      "slip-errors-at-edges",
      {Criterion::at_most("distance of the largest error from an edge, in elements",
                          Value(from_edge, significant(2)).as_is(),
                          {LimitKind::choice, 2.0, "what was found, with a margin"})},
      "the shear's largest error is beside an edge of slip");
  fit_slip_orders(document, c, mu);
}

}  // namespace paper
