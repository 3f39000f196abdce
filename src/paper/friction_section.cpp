// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/friction.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/cattaneo_mindlin.hpp"
#include "contact/coupled_sliding.hpp"
#include "contact/matrix_inversion.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "literate/document/document.hpp"
#include "numerics/power_fit.hpp"
#include "paper/bounds.hpp"
#include "paper/convergence.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using contact::CattaneoMindlin;
using contact::CoupledSliding;
using contact::Hertz;
using contact::Solution;
using elasticity::Material;
using literate::Column;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::LimitKind;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;
using numerics::fit_power;
using numerics::PowerFit;

constexpr double friction_coefficient = 0.3;  // dry metals, and a round number
constexpr double light_friction = 0.1;        // greased ones

// Two bodies with the case's radii, pressed to the case's half-width; their pressure and slopes.
struct Pair {
  contact::CylinderPair cylinders;
  double line_load;
  Hertz hertz;
  contact::Problem problem;
  Solution solution;
  double beta;
};

Pair pair_of(const parameters::ContactCase& c, const Material& first, const Material& second) {
  const contact::CylinderPair cylinders(first, c.body1.radius, second, c.body2.radius);
  const double load = c.line_load * cylinders.contact_modulus() / c.cylinders.contact_modulus();
  const Hertz hertz(cylinders, load);
  const contact::Problem problem{cylinders.profile(), cylinders.contact_modulus(),
                                 contact::grid_around(hertz.half_width(), c.n_nodes)};
  return {cylinders,
          load,
          hertz,
          problem,
          contact::solve_by_matrix_inversion(problem, load),
          elasticity::dundurs_beta(first, second)};
}

contact::Slopes sliding_slopes(const Pair& pair, double mu) {
  return contact::surface_slopes(pair.problem, pair.solution,
                                 contact::sliding(pair.solution, mu).shear, pair.beta);
}

// The slope at the edge of contact, a/R, from the elements' half-width.
double edge_slope(const Pair& pair) {
  return pair.solution.half_width() * pair.cylinders.relative_curvature();
}

// The largest slope of the shear over the largest of the pressure.
double slope_ratio(const Pair& pair, double mu) {
  return sliding_slopes(pair, mu).of_shear.cwiseAbs().maxCoeff() / edge_slope(pair);
}

// Puts the closed form into eq. (2) for both bodies and returns the largest departure of the slope
// from −x/R, over a/R.
Estimate departure(const CoupledSliding& exact, const Material& first, const Material& second,
                   double curvature) {
  const auto loaded = [&](const Material& material, double mu) {
    return elasticity::SurfaceQuadrature(
        material,
        elasticity::distributed_load([=](double x) { return exact.pressure(x); },
                                     [=](double x) { return mu * exact.pressure(x); },
                                     {exact.shift() - exact.half_width(), exact.shift(),
                                      exact.shift() + exact.half_width()}),
        10 * exact.half_width());
  };
  const auto body1 = loaded(first, friction_coefficient);
  const auto body2 = loaded(second, -friction_coefficient);
  Estimate largest;
  for (const double xi : {-0.93, -0.61, -0.2, 0.0, 0.37, 0.72, 0.95}) {
    const double x = exact.shift() + xi * exact.half_width();
    const Estimate slope = body1.normal_gradient(x) + body2.normal_gradient(x);
    largest.value = std::max(largest.value, std::abs(slope.value + curvature * x));
    largest.abs_error = std::max(largest.abs_error, slope.abs_error);
  }
  return 1 / (curvature * exact.half_width()) * largest;
}

// Materials on steel, by ratios and so in any unit: round values as engineering handbooks print
// them. The softer body is the first, and β > 0.
struct Mating {
  const char* name;
  double young_ratio;
  int place;  ///< of the ratio's last digit
  double poisson;
};
constexpr double steel_poisson = 0.29;
constexpr Mating matings[] = {
    {"steel on steel", 1, -2, steel_poisson}, {"brass on steel", 0.52, -2, 0.34},
    {"aluminium on steel", 0.34, -2, 0.33},   {"glass on steel", 0.34, -2, 0.22},
    {"nylon on steel", 0.014, -3, 0.40},      {"rubber on steel", 0.0001, -4, 0.499}};

// How far a pair's measured ratio of slopes is from |β|μ.
double departure_from_beta_mu(const Pair& pair) {
  return std::abs(slope_ratio(pair, friction_coefficient) -
                  std::abs(pair.beta) * friction_coefficient);
}

// A number that rounds to zero in its column is said to be near zero; its digits and their power of
// ten would make the column too wide for the page.
literate::Cell near_zero_or(Estimate value, int n_decimals) {
  const double size = std::abs(value.value);
  if (size > value.abs_error && size < std::pow(10.0, -n_decimals) / 2) {
    return literate::Cell::latex("$\\approx 0$");
  }
  return value;
}

void compare_pairs(literate::Document& document, const parameters::ContactCase& c,
                   const Pair& own) {
  const char* const of_slopes = "ratio of slopes, \\%";
  const char* const of_contact = "of the contact, \\%";
  literate::Table table(
      "friction-pairs",
      {Column::text("bodies"), Column("$E_1/E_2$", fixed(2)), Column("$\\nu_1$", fixed(3)).exact(),
       Column("$\\nu_2$", fixed(3)).exact(), Column("$\\beta$", fixed(3)),
       Column(fmt::format("$\\mu = {}$", light_friction), fixed(2)).under(of_slopes),
       Column(fmt::format("$\\mu = {}$", friction_coefficient), fixed(2)).under(of_slopes),
       Column("shift", fixed(2)).under(of_contact),
       Column("widening", fixed(3)).under(of_contact)});
  std::vector<Criterion> losses;
  double departure_of_ratio = 0;
  Estimate departure_of_exact;
  const auto add = [&](const char* name, const Pair& pair, literate::Cell young_ratio,
                       const Material& first, const Material& second) {
    const CoupledSliding exact(pair.cylinders, pair.line_load, friction_coefficient, pair.beta);
    const double closed = rounded(c, 1);
    // The ratio is μ|β| times peak over half-width, of which each is wrong by so much.
    const double of_ratio =
        pressure_error(pair.solution) + half_width_error(pair.solution) + closed;
    const double a = pair.hertz.half_width();
    table.add_row(
        {name, young_ratio, first.poisson(), second.poisson(),
         near_zero_or(Estimate{pair.beta, rounded(1)}, 3),
         near_zero_or(100 * Estimate{slope_ratio(pair, light_friction), light_friction * of_ratio},
                      2),
         near_zero_or(100 * Estimate{slope_ratio(pair, friction_coefficient),
                                     friction_coefficient * of_ratio},
                      2),
         near_zero_or(100 * Estimate{std::abs(exact.shift()) / a, closed}, 2),
         100 * Estimate{exact.half_width() / a - 1, 2 * closed}});
    losses.push_back(Criterion::at_most(
        "loss",
        Value({std::abs(exact.shift()) / a + exact.half_width() / a - 1, 3 * closed}, percent(1)),
        {LimitKind::convention, 0.1, "a tenth of the half-width, which a plot would show"}));
    departure_of_ratio = std::max(departure_of_ratio, departure_from_beta_mu(pair));
    const Estimate off = departure(exact, first, second, pair.cylinders.relative_curvature());
    departure_of_exact.value = std::max(departure_of_exact.value, off.value);
    departure_of_exact.abs_error = std::max(departure_of_exact.abs_error, off.abs_error);
  };
  const Material& body1 = c.body1.material;
  const Material& body2 = c.body2.material;
  add("this case", own, closed_form(body1.young() / body2.young()), body1, body2);
  for (const Mating& mating : matings) {
    const Material steel(body1.young(), steel_poisson);
    const Material other(mating.young_ratio * steel.young(), mating.poisson);
    add(mating.name, pair_of(c, other, steel),
        literate::Cell::quoted(mating.young_ratio, mating.place), other, steel);
  }
  document.table(table);
  document.claim(
      "friction-small-loss",
      {.route = "the closed form for bodies that slide on one another, for this case and for other "
                "pairs of materials",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::in_each("shift and widening of the contact, over its half-width",
                                       "pairs", losses)}});
  const double bound = friction_coefficient * (pressure_error(own.solution) +
                                               half_width_error(own.solution) + rounded(c, 1));
  document.value("friction.ratio-error",
                 Value(Estimate{departure_of_ratio, bound}, scientific(1).rounded_up()));
  // Half-width and peak, from which the ratio is taken, are of second order in c/a.
  const double square = std::pow(own.solution.grid.spacing / own.hertz.half_width(), 2);
  document.check(
      "friction-ratio-is-beta-mu",
      {Criterion::at_most("largest difference of the ratio from βμ",
                          Value(Estimate{departure_of_ratio, bound}, scientific(1).rounded_up()),
                          {LimitKind::derived, friction_coefficient * square,
                           "μ(c/a)², the order of the elements"})},
      "the largest slope of the shear over that of the pressure is beta mu");
  document.claim(
      "sliding-in-closed-form",
      {.route = "eq. (2) for both bodies by quadrature, for all pairs of materials",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_most(
           "largest departure of the slope from −x/R, over a/R",
           Value(departure_of_exact, scientific(1).rounded_up()),
           {LimitKind::rounding, 1e-11, "what the quadrature loses at singular ends"})}});
}

bool are_alike(const parameters::ContactCase& c) {
  return c.body1.material.young() == c.body2.material.young() &&
         c.body1.material.poisson() == c.body2.material.poisson();
}

// What the shear does to each body's slope, and to their sum, at the middle of the contact.
void compare_bodies(literate::Document& document, const parameters::ContactCase& c,
                    const Pair& own) {
  const contact::Friction sliding = contact::sliding(own.solution, friction_coefficient);
  const double peak = sliding.shear.maxCoeff() / edge_slope(own);
  const double slope1 = c.body1.material.local_compliance() * peak;
  const double slope2 = c.body2.material.local_compliance() * peak;
  const Eigen::VectorXd of_shear = sliding_slopes(own, friction_coefficient).of_shear;
  Eigen::Index middle = 0;
  own.solution.pressure.maxCoeff(&middle);
  const double sum = of_shear[middle] / edge_slope(own);
  // Of Hertz's pressure they are the compliance times μp₀R/a: the elements' are wrong by the rest.
  const double exact = friction_coefficient * own.hertz.peak_pressure() /
                       (own.hertz.half_width() * own.cylinders.relative_curvature());
  const auto against_hertz = [&](double slope, double compliance) {
    const double closed = compliance * exact;
    return Estimate{slope, std::abs(slope - closed) + rounded(c, closed)};
  };
  const Estimate body1 = against_hertz(slope1, c.body1.material.local_compliance());
  const Estimate body2 = against_hertz(slope2, c.body2.material.local_compliance());
  document.value("friction.body1", Value(body1, percent(2)));
  document.value("friction.body2", Value(body2, percent(2)));
  const bool like = are_alike(c);
  document.flag("friction.like", like);
  const Estimate lost = magnitude(body1 - body2);
  // What `lost` shows when it is printed.
  constexpr double visible = 1e-4;
  const bool nearly_cancels = lost.value + lost.abs_error < visible;
  document.flag("friction.nearly-cancels", nearly_cancels);
  // Of like bodies the prose names neither.
  if (!like && nearly_cancels) {
    document.value("friction.visible", Value(visible, literate::exact()));
  } else if (!like) {
    document.value("friction.lost", Value(lost, percent(2)));
  }
  const double larger = std::max(slope1, slope2);
  document.check(
      "slopes-of-two-bodies",
      {Criterion::at_most(
          "slope of both less the difference, over the larger",
          Value(std::abs(sum - (slope1 - slope2)) / larger, scientific(1).rounded_up()).within(0),
          {LimitKind::rounding, 1e-14, "a difference of two"})},
      "the shear's slopes of the two bodies are subtracted");
  document.check("slopes-of-like-bodies-cancel", !like || sum == 0,
                 "the shear's slopes of two bodies alike cancel");
}

// One load on one grid, against the closed form.
struct SlipErrors {
  double stick;    ///< half-width of the strip that sticks, relative
  double largest;  ///< of q, over μp₀
  double mean;
  double from_edge;  ///< of the largest, to the nearest edge of contact or strip, in spacings
};

// The half-width of what is taken away, p − q/μ, as Solution::half_width does it.
double stick_half_width(const Solution& solution, const contact::Friction& friction, double mu) {
  Solution sticking = solution;
  sticking.pressure = solution.pressure - friction.shear / mu;
  return sticking.half_width();
}

struct Slip {
  CattaneoMindlin exact;
  contact::Friction friction;
  double stick;
  SlipErrors errors;
};

Slip partial_slip(const Pair& pair, double share) {
  const double mu = friction_coefficient;
  const double load = share * mu * pair.solution.line_load();
  Slip slip{CattaneoMindlin(pair.hertz, mu, load),
            contact::partial_slip(pair.problem, pair.solution, mu, load,
                                  contact::solve_by_matrix_inversion),
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

SlipCurve curve_of(const Pair& pair, const Slip& slip) {
  const double a = pair.hertz.half_width();
  const double scale = friction_coefficient * pair.hertz.peak_pressure();
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

constexpr double shares[] = {0.3, 0.6, 0.9};

literate::Table slip_table(const std::vector<Slip>& slips, const Pair& pair) {
  const char* const of_strip = "half-width of the strip over $a$";
  const char* const of_shear = "error of $q/(\\mu p_0)$";
  literate::Table table(
      "partial-slip",
      {Column("$Q/(\\mu P)$", fixed(1)).exact(), Column("elements", fixed(5)).under(of_strip),
       Column("closed form", fixed(5)).under(of_strip),
       Column("relative difference", scientific(2)).under(of_strip),
       Column("largest", scientific(2)).under(of_shear),
       Column("mean", scientific(2)).under(of_shear)});
  // The shear is the difference of two pressures. What is taken away has its peak in proportion to
  // the strip's half-width b, which is wrong as half_width_error() says with a/b times the error.
  const double of_shears = 2 * pressure_error(pair.solution) + closed_form(1).abs_error;
  const double a = pair.hertz.half_width();
  for (std::size_t k = 0; k < slips.size(); ++k) {
    // √(1 − Q/(μP)), where the difference cancels the more the greater the load.
    const double strip = slips[k].exact.stick_half_width() / a;
    const Estimate closed{strip, rounded(strip) / (1 - shares[k])};
    const double of_stick = 1.5 * of_shears / closed.value;
    table.add_row({shares[k], Estimate{slips[k].stick / a, of_stick * closed.value}, closed,
                   Estimate{slips[k].errors.stick, of_stick + rounded(1)},
                   Estimate{slips[k].errors.largest, of_shears},
                   Estimate{slips[k].errors.mean, of_shears}});
  }
  return table;
}

// The errors of the middle one of the loads over grids on which the edges fall anywhere.
void fit_slip_orders(literate::Document& document, parameters::ContactCase c) {
  std::vector<double> elements, largest, mean, bounds;
  double root_factor = 0;
  for (double n = 21; n < 190; n *= 1.08) {
    c.n_nodes = std::lround(n);
    const Pair pair = pair_of(c, c.body1.material, c.body2.material);
    const SlipErrors errors = partial_slip(pair, shares[1]).errors;
    elements.push_back(pair.hertz.half_width() / pair.solution.grid.spacing);
    largest.push_back(errors.largest);
    mean.push_back(errors.mean);
    // The shear is the difference of two pressures, the second that of a lesser load.
    bounds.push_back(2 * pressure_error(pair.solution));
    root_factor = std::max(root_factor, errors.largest * std::sqrt(elements.back()));
  }
  const PowerFit of_largest = fit_power(elements, largest, bounds);
  const PowerFit of_mean = fit_power(elements, mean, bounds);
  document.value("slip.fit.share", Value(shares[1], exact()));
  document.value("slip.fit.least", Value(closed_form(elements.front()), fixed(0)));
  document.value("slip.fit.most", Value(closed_form(elements.back()), fixed(0)));
  document.value("slip.fit.largest", Value(of_largest.order_estimate(), fixed(1)));
  document.value("slip.fit.mean", Value(of_mean.order_estimate(), fixed(1)));
  const char* const scatter = "the scatter of where the edges fall between the nodes";
  document.check(
      "slip-orders",
      {Criterion::agrees("order of the largest error", Value(of_largest.order_estimate(), fixed(2)),
                         Value(0.5, exact()).within(0), {LimitKind::regression, 0.25, scatter}),
       Criterion::agrees("order of the mean error", Value(of_mean.order_estimate(), fixed(2)),
                         Value(1.5, exact()).within(0), {LimitKind::regression, 0.3, scatter}),
       Criterion::at_most("largest error times the root of the elements over a",
                          Value({root_factor, 1e-6 * root_factor}, significant(2)),
                          {LimitKind::regression, 0.25, "what was found, with a margin"})},
      "the shear's largest error is of order 1/2, its mean error of order 3/2");
}

// How wrong the strip may be, relatively: the traction that is taken away is the difference of two
// pressures, and the strip carries the square of its share of the load.
double stick_error(const Pair& pair, double stick_half_width) {
  const double share = stick_half_width / pair.hertz.half_width();
  return 2 * half_width_error(pair.solution) / (share * share);
}

void compare_partial_slip(literate::Document& document, const parameters::ContactCase& c,
                          const Pair& own) {
  literate::Figure figure{.width_cm = 13.5, .height_cm = 7};
  std::vector<Slip> slips;
  std::vector<double> sliding_x, sliding;
  Estimate worst_stick;
  double from_edge = 0;
  for (std::size_t k = 0; k < std::size(shares); ++k) {
    slips.push_back(partial_slip(own, shares[k]));
    const SlipCurve curve = curve_of(own, slips[k]);
    figure.data[fmt::format("curve_{}", k + 1)] = {{"x", curve.x}, {"shear", curve.shear}};
    figure.data[fmt::format("nodes_{}", k + 1)] = {{"x", curve.node_x}, {"shear", curve.node}};
    figure.numbers[fmt::format("share_{}", k + 1)] = shares[k];
    figure.numbers[fmt::format("stick_{}", k + 1)] = curve.stick;
    if (k + 1 == std::size(shares)) sliding_x = curve.x;
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
  document.table(slip_table(slips, own));
  figure.data["sliding"] = {{"x", sliding_x}, {"shear", sliding}};
  document.figure("partial-slip", std::move(figure));
  // As for the half-width of the contact itself (0.36 (c/a)²), with the strip for the contact.
  document.claim(
      "strip-of-cattaneo-and-mindlin",
      {.route = "the difference of two frictionless contacts against the closed form, under "
                "three loads",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_most(
           "largest relative error of the strip, over the square of the elements' width over it",
           Value(worst_stick, fixed(2)),
           {LimitKind::convention, 1.0, "the elements have this order, and errors no larger"})}});
  document.check(
      "slip-errors-at-edges",
      {Criterion::at_most("distance of the largest error from an edge, in elements",
                          Value(from_edge, significant(2)).within(0),
                          {LimitKind::regression, 2.0, "what was found, with a margin"})},
      "the shear's largest error is beside an edge of slip");
  fit_slip_orders(document, c);
}

}  // namespace

void compute_friction(literate::Document& document, const parameters::ContactCase& c) {
  const Pair own = pair_of(c, c.body1.material, c.body2.material);
  document.value("friction.mu", Value(friction_coefficient, exact()));
  compare_bodies(document, c, own);
  compare_pairs(document, c, own);
  compare_partial_slip(document, c, own);
}

}  // namespace paper
