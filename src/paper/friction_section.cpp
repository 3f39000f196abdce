// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/friction.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/coupled_sliding.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "literate/document/document.hpp"
#include "paper/bounds.hpp"
#include "paper/convergence.hpp"
#include "paper/friction_pair.hpp"
#include "paper/partial_slip.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using contact::CoupledSliding;
using contact::Hertz;
using elasticity::Material;
using literate::Column;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::LimitKind;
using literate::percent;
using literate::scientific;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;

constexpr double light_friction = 0.1;  // greased ones

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

}  // namespace

void compute_friction(literate::Document& document, const parameters::ContactCase& c) {
  const Pair own = pair_of(c, c.body1.material, c.body2.material);
  document.value("friction.mu", Value(friction_coefficient, exact()));
  compare_bodies(document, c, own);
  compare_pairs(document, c, own);
  compute_partial_slip(document, c, own);
}

}  // namespace paper
