// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/friction.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "line_contact/cylinder_friction.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/convergence.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using elasticity::Material;
using line_contact::CoupledSliding;

// Two bodies with the case's radii, pressed to the case's half-width.
//
// Lengths, loads and stresses in the case's units; `line_load` is a force per length, `beta` is
// Dundurs's second constant, without dimension.
struct Pair {
  line_contact::CylinderPair cylinders;
  double line_load;
  Hertz hertz;
  line_contact::Problem problem;
  line_contact::Solution solution;
  double beta;
};

// The pair of these two materials, solved without friction by matrix inversion on the case's
// nodes. The load is the case's times the ratio of the contact moduli, so that Hertz's half-width
// is the case's. Throws what solve_by_matrix_inversion() throws.
Pair pair_of(const ContactCase& c, const elasticity::Material& first,
             const elasticity::Material& second) {
  const line_contact::CylinderPair cylinders(first, c.body1.radius, second, c.body2.radius);
  const double load = c.line_load * cylinders.contact_modulus() / c.cylinders.contact_modulus();
  const Hertz hertz(cylinders, load);
  const line_contact::Problem problem{cylinders.profile(), cylinders.contact_modulus(),
                                      line_contact::grid_around(hertz.half_width(), c.n_nodes)};
  return {cylinders,
          load,
          hertz,
          problem,
          line_contact::solve_by_matrix_inversion(problem, load),
          elasticity::dundurs_beta(first, second)};
}

line_contact::Slopes sliding_slopes(const Pair& pair, double mu) {
  return line_contact::surface_slopes(pair.problem, pair.solution,
                                      line_contact::sliding(pair.solution, mu).shear, pair.beta);
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
Estimate departure(const CoupledSliding& exact, double mu, const Material& first,
                   const Material& second, double curvature) {
  const auto loaded = [&](const Material& material, double signed_mu) {
    return elasticity::SurfaceQuadrature(
        material,
        elasticity::distributed_load([=](double x) { return exact.pressure(x); },
                                     [=](double x) { return signed_mu * exact.pressure(x); },
                                     {exact.shift() - exact.half_width(), exact.shift(),
                                      exact.shift() + exact.half_width()}),
        10 * exact.half_width());
  };
  const auto body1 = loaded(first, mu);
  const auto body2 = loaded(second, -mu);
  Estimate largest;
  for (const double xi : {-0.93, -0.61, -0.2, 0.0, 0.37, 0.72, 0.95}) {
    const double x = exact.shift() + xi * exact.half_width();
    const Estimate slope = body1.normal_gradient(x) + body2.normal_gradient(x);
    largest = max(largest, abs(slope + curvature * x));
  }
  return 1 / (curvature * exact.half_width()) * largest;
}

// How far a pair's measured ratio of slopes is from |β|μ.
double departure_from_beta_mu(const Pair& pair, double mu) {
  return std::abs(slope_ratio(pair, mu) - std::abs(pair.beta) * mu);
}

// A number that rounds to zero in its column is said to be near zero; its digits and their power of
// ten would make the column too wide for the page.
Cell near_zero_or(Estimate value, int n_decimals) {
  const double size = std::abs(value.value);
  if (size > value.abs_error && size < std::pow(10.0, -n_decimals) / 2) {
    return literate::Cell::latex("$\\approx 0$");
  }
  return value;
}

// What sliding takes from the precision of the contact: how far it moves and widens, over its
// half-width.
Estimate loss_of(const CoupledSliding& exact, double half_width, double closed) {
  return {std::abs(exact.shift()) / half_width + exact.half_width() / half_width - 1, 3 * closed};
}

// The friction at which the loss is just negligible for |β| = ½, the greatest of any two materials
// with ν ≥ 0; with s = 2|γ| it is s + 1/√(1 − s²) − 1, tan ½πs = |β|μ.
Estimate friction_of_small_loss() {
  constexpr double greatest_beta = 0.5;
  double low = 0;
  double high = 0.5;  // of s
  while (high - low > 1e-15) {
    const double s = (low + high) / 2;
    (s + 1 / std::sqrt(1 - s * s) - 1 < nearly_identical().number() ? low : high) = s;
  }
  return closed_form(std::tan(std::numbers::pi / 2 * low) / greatest_beta);
}

void claim_small_loss(Document& document, const std::vector<Criterion>& losses, double mu) {
  document.value("friction.mu-of-small-loss", Value(friction_of_small_loss(), fixed(2)));
  document.value("friction.small-loss", Value(nearly_identical().number(), exact()));
  const Criterion each =
      Criterion::in_each("shift and widening of the contact, over its half-width",
                         "pairs of unlike materials", losses);
  // Up to that friction the loss of any pair is small; beyond, of some.
  const bool is_small =
      mu <= friction_of_small_loss().value || each.outcome() == literate::Outcome::holds;
  document.flag("friction.loss-is-small", is_small);
  document.claim("friction-small-loss",
                 {.route = fmt::format(
                      "shift and widening of the contact by the closed form for bodies that slide "
                      "on one another with μ = {}; the sentence is taken to be one about where the "
                      "contact lies and how wide it is, not about the pressure at a given place or "
                      "the stresses beneath",
                      mu),
                  .expected = is_small                                     ? Verdict::confirmed
                              : each.outcome() == literate::Outcome::fails ? Verdict::refuted
                                                                           : Verdict::partly,
                  .criteria = {each}});
}

void compare_pairs(Document& document, const ContactCase& c, const FrictionCase& friction,
                   const Pair& own) {
  const double mu = friction.coefficient;
  const char* const of_contact = "contact (\\% of $a$)";
  literate::Table table("friction-pairs",
                        {Column::text("bodies"), Column("$E_1/E_2$", fixed(2)),
                         Column("$\\nu_1$", fixed(3)), Column("$\\nu_2$", fixed(3)),
                         Column("$\\beta$", fixed(3)), Column("shift", fixed(2)).under(of_contact),
                         Column("widening", fixed(3)).under(of_contact)});
  std::vector<Criterion> losses;
  double departure_of_ratio = 0;
  Estimate departure_of_exact;
  const auto add = [&](const std::string& name, const Pair& pair, Cell young_ratio,
                       const Material& first, const Material& second) {
    const CoupledSliding exact(pair.cylinders, pair.line_load, mu, pair.beta);
    const double closed = rounded(c, 1);
    const double a = pair.hertz.half_width();
    table.add_row({name, young_ratio, Estimate{first.poisson(), 0}, Estimate{second.poisson(), 0},
                   near_zero_or(Estimate{pair.beta, rounded(1)}, 3),
                   near_zero_or(100 * Estimate{std::abs(exact.shift()) / a, closed}, 2),
                   near_zero_or(100 * Estimate{exact.half_width() / a - 1, 2 * closed}, 3)});
    // Bodies of one β lose nothing, whatever the friction.
    if (pair.beta != 0 || friction.pairs.empty())
      losses.push_back(Criterion::at_most("loss", Value(loss_of(exact, a, closed), percent(1)),
                                          nearly_identical()));
    departure_of_ratio = std::max(departure_of_ratio, departure_from_beta_mu(pair, mu));
    departure_of_exact = max(departure_of_exact, departure(exact, mu, first, second,
                                                           pair.cylinders.relative_curvature()));
  };
  const Material& body1 = c.body1.material;
  const Material& body2 = c.body2.material;
  add("our bodies", own, closed_form(body1.young() / body2.young()), body1, body2);
  // Only the ratio of the moduli matters, so that the second body may have this case's.
  for (const parameters::SlidingPair& pair : friction.pairs) {
    const double ratio = pair.young_ratio.value();
    const Material first(ratio * body1.young(), pair.poisson1);
    const Material second(body1.young(), pair.poisson2);
    add(pair.bodies, pair_of(c, first, second),
        literate::Cell::quoted(ratio, pair.young_ratio.place()), first, second);
  }
  document.table(table);
  claim_small_loss(document, losses, mu);
  const double bound =
      mu * (pressure_error(own.solution) + half_width_error(own.solution) + rounded(c, 1));
  document.value("friction.ratio-error",
                 Value(Estimate{departure_of_ratio, bound}, scientific(1).rounded_up()));
  // Half-width and peak, from which the ratio is taken, are of second order in c/a.
  document.check(
      "friction-ratio-is-beta-mu",
      {Criterion::at_most(
          "largest difference of the ratio from βμ",
          Value(Estimate{departure_of_ratio, bound}, scientific(1).rounded_up()),
          Limit::theory(
              "μ(c/a)²",
              {{"μ", mu}, {"c", own.solution.grid.spacing}, {"a", own.hertz.half_width()}},
              "the order of the elements"))},
      "the largest slope of the shear over that of the pressure is beta mu");
  document.claim(
      "sliding-in-closed-form",
      {.route = "eq. (2) for both bodies by quadrature, for every pair of materials listed",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_most(
           "largest departure of the slope from −𝑥/𝑅, over 𝑎/𝑅",
           Value(departure_of_exact, scientific(1).rounded_up()),
           {LimitKind::choice, 1e-11, "what the quadrature loses at singular ends"})}});
}

bool are_alike(const ContactCase& c) {
  return c.body1.material.young() == c.body2.material.young() &&
         c.body1.material.poisson() == c.body2.material.poisson();
}

// What the shear does to each body's slope, and to their sum, at the middle of the contact.
void compare_bodies(Document& document, const ContactCase& c, const Pair& own, double mu) {
  const line_contact::Friction sliding = line_contact::sliding(own.solution, mu);
  const double peak = sliding.shear.maxCoeff() / edge_slope(own);
  const double slope1 = c.body1.material.local_compliance() * peak;
  const double slope2 = c.body2.material.local_compliance() * peak;
  const Eigen::VectorXd of_shear = sliding_slopes(own, mu).of_shear;
  Eigen::Index middle = 0;
  own.solution.pressure.maxCoeff(&middle);
  const double sum = of_shear[middle] / edge_slope(own);
  // Of Hertz's pressure they are the compliance times μp₀R/a: the elements' are wrong by the rest.
  const double exact = mu * own.hertz.peak_pressure() /
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
  const Estimate lost = abs(body1 - body2);
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
          Value(std::abs(sum - (slope1 - slope2)) / larger, scientific(1).rounded_up()).as_is(),
          {LimitKind::choice, 1e-14, "a difference of two"})},
      "the shear's slopes of the two bodies are subtracted");
  document.check("slopes-of-like-bodies-cancel", !like || sum == 0,
                 "the shear's slopes of two bodies alike cancel");
}

}  // namespace

void compute_friction(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const FrictionCase& friction = c.friction.value();
  const Pair own = pair_of(c, c.body1.material, c.body2.material);
  document.value("friction.mu", Value(friction.coefficient, exact()));
  compare_bodies(document, c, own, friction.coefficient);
  compare_pairs(document, c, friction, own);
}

}  // namespace paper
