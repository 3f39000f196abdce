// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "line_contact/power_law.hpp"
#include "line_contact/rounded_punch.hpp"
#include "line_contact/solver.hpp"
#include "line_contact/wedge.hpp"
#include "numerics/scatter.hpp"
#include "paper/bounds.hpp"
#include "paper/convergence.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using Eigen::Index;
using line_contact::Grid;
using line_contact::Profile;
using line_contact::Solution;

// A profile that has a closed form, scaled to have the half-width of the cylinders.
struct KnownContact {
  std::string name;  // LaTeX
  Profile profile;
  std::function<double(double)> pressure;
  double half_width;
  double peak;      // infinite for the wedge
  double singular;  // the |x| where the pressure or its slope is infinite; none: infinite
};

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double flat_share = 0.7;  // of the contact under the rounded punch

double punch_curvature(const ContactCase& c, double a) {
  return line_contact::RoundedPunch::edge_curvature_for(c.cylinders.contact_modulus(),
                                                        flat_share * a, a, c.line_load);
}

std::vector<KnownContact> known_contacts(const ContactCase& c, const Hertz& hertz) {
  const double a = hertz.half_width();
  const double load = c.line_load;
  const double modulus = c.cylinders.contact_modulus();
  std::vector<KnownContact> contacts;
  const auto add = [&](std::string name, Profile profile, const auto& solution, double peak,
                       double singular) {
    contacts.push_back({std::move(name), std::move(profile),
                        [solution](double x) { return solution.pressure(x); },
                        solution.half_width(), peak, singular});
  };
  add("cylinders", c.cylinders.profile(), hertz, hertz.peak_pressure(), none);
  const double slope = load / (modulus * a);
  add("wedge", Profile::wedge(slope), line_contact::Wedge(modulus, slope, load), none, 0);
  const double curvature = punch_curvature(c, a);
  const line_contact::RoundedPunch punch(modulus, flat_share * a, curvature, load);
  add("rounded punch", Profile::rounded_punch(flat_share * a, curvature), punch,
      punch.peak_pressure(), flat_share * a);
  for (const int n : {2, 3}) {
    const double coefficient = line_contact::PowerLaw::coefficient_for(modulus, n, a, load);
    const line_contact::PowerLaw law(modulus, coefficient, n, load);
    add(fmt::format("power law, $n = {}$", n), Profile::power_law(coefficient, n), law,
        law.peak_pressure(), none);
  }
  return contacts;
}

// How far the elements are from a closed form; pressures over p₀ of the cylinders.
struct ProfileErrors {
  double elements;  // a/c
  double inside;    // root mean square over |x| ≤ 0.9 a
  double away;      // the same, farther than a/10 from where the pressure is singular
  double beside;    // at the node beside x = 0
  double peak;      // relative
  double edge;      // of the half-width, over c
  double bound;     // of how wrong the pressures are as solutions on their grid
  double of_edge;   // the same of the half-width, over a
};

ProfileErrors errors_of(const KnownContact& known, const Solution& solution, double scale) {
  const double a = known.half_width;
  const Grid& grid = solution.grid;
  std::array<double, 2> squares{};
  std::array<int, 2> counts{};
  for (Index i = 0; i < grid.n_nodes; ++i) {
    const double x = std::abs(grid.x(i));
    const double exact = known.pressure(x);
    if (x > 0.9 * a || !std::isfinite(exact)) continue;
    const double error = (solution.pressure[i] - exact) / scale;
    const bool is_away = std::abs(x - known.singular) > a / 10;
    for (std::size_t k = 0; k < (is_away ? 2U : 1U); ++k) {
      squares[k] += error * error;
      ++counts[k];
    }
  }
  const line_contact::Region region = solution.regions().front();
  const Index beside = grid.n_nodes / 2 + 1;  // n is odd
  return {a / grid.spacing,
          std::sqrt(squares[0] / counts[0]),
          std::sqrt(squares[1] / counts[1]),
          std::abs(solution.pressure[beside] - known.pressure(grid.x(beside))) / scale,
          solution.peak_pressure() / known.peak - 1,
          ((region.end - region.begin) / 2 - a) / grid.spacing,
          pressure_error(solution) * solution.peak_pressure() / scale,
          edge_error(solution) / a};
}

// The root mean squares of the errors on some grids, and the largest of their bounds.
ProfileErrors together(const std::vector<ProfileErrors>& errors) {
  ProfileErrors mean{};
  const auto take = [&](double ProfileErrors::*part) {
    double squares = 0;
    for (const ProfileErrors& e : errors) squares += std::pow(e.*part, 2);
    mean.*part = std::sqrt(squares / static_cast<double>(errors.size()));
  };
  for (const auto part : {&ProfileErrors::elements, &ProfileErrors::inside, &ProfileErrors::away,
                          &ProfileErrors::beside, &ProfileErrors::peak, &ProfileErrors::edge}) {
    take(part);
  }
  for (const ProfileErrors& e : errors) {
    mean.bound = std::max(mean.bound, e.bound);
    mean.of_edge = std::max(mean.of_edge, e.of_edge);
  }
  return mean;
}

// One profile on four sets of grids.
struct ProfileStudy {
  std::vector<double> elements, inside, away, beside, bound;  // of each set
  std::vector<Estimate> edges;  // errors of the half-width on each grid, in elements
  ProfileErrors printed{};      // on the grids of the table
  double fewest = 0, most = 0;  // elements on these
};

// The edge is worst just before a node comes into contact, within a tenth of a spacing.
constexpr int n_places = 100;

ProfileStudy study_of(const KnownContact& known, const ContactCase& c, const Hertz& hertz) {
  constexpr Index printed = 177;
  const double scale = hertz.peak_pressure();
  ProfileStudy study;
  for (const Index n_nodes : {Index{89}, printed, Index{353}, Index{705}}) {
    std::vector<ProfileErrors> on_grids;
    for (const Grid& grid : grids_of(hertz, n_nodes, n_places)) {
      const Solution solution = line_contact::solve_by_fft(
          {known.profile, c.cylinders.contact_modulus(), grid}, c.line_load);
      const ProfileErrors& e = on_grids.emplace_back(errors_of(known, solution, scale));
      study.edges.push_back({std::abs(e.edge), e.bound * e.elements});
    }
    const ProfileErrors errors = together(on_grids);
    study.elements.push_back(errors.elements);
    study.inside.push_back(errors.inside);
    study.away.push_back(errors.away);
    study.beside.push_back(errors.beside);
    study.bound.push_back(errors.bound);
    if (n_nodes != printed) continue;
    study.printed = errors;
    study.fewest = on_grids.front().elements;
    study.most = on_grids.back().elements;
  }
  return study;
}

Measured order_of(const ProfileStudy& study, const std::vector<double>& errors) {
  std::vector<Estimate> bounded;
  for (std::size_t i = 0; i < errors.size(); ++i) bounded.push_back({errors[i], study.bound[i]});
  return numerics::fit_scattered_power(study.elements, bounded, "grids").order;
}

void check_orders(Document& document, const std::vector<ProfileStudy>& studies) {
  // A pressure that is infinite like ln|x| is wrong by as much at a few nodes on every grid, one
  // whose slope is by c: root mean squares of orders 1/2 and 3/2.
  constexpr std::array<double, 5> expected = {2, 0.5, 1.5, 2, 2};
  const auto of_order = [](const ProfileStudy& study, const std::vector<double>& errors,
                           double order) {
    const Limit margin(LimitKind::choice, 0.1, "what was found, with a margin");
    return Criterion::agrees("order", Value(order_of(study, errors), uncertain()),
                             Value(order, exact()), margin.counting(2));
  };
  std::vector<Criterion> orders, orders_away, edges;
  Estimate worst_edge;
  for (std::size_t k = 0; k < studies.size(); ++k) {
    const ProfileStudy& study = studies[k];
    orders.push_back(of_order(study, study.inside, expected[k]));
    orders_away.push_back(of_order(study, study.away, 2));
    for (const Estimate& edge : study.edges) {
      // The edge is extrapolated from p²; errors δp₀ of p move it by less than δa.
      edges.push_back(
          Criterion::at_most("edge", Value(edge, significant(2)),
                             {LimitKind::choice, 0.5, "the error that counting nodes would have"}));
      worst_edge = std::max(worst_edge, edge, [](const Estimate& one, const Estimate& other) {
        return one.value < other.value;
      });
    }
  }
  document.value("profiles.worst-edge", Value(worst_edge, significant(2).rounded_up()));
  document.claim("edges-found", {.route = "the closed forms of five profiles, with the edge at "
                                          "every hundredth of a spacing; the elements' edge "
                                          "is extrapolated from the last two loaded nodes, to the "
                                          "next node at most",
                                 .expected = Verdict::confirmed,
                                 .criteria = {Criterion::in_each(
                                     "error of the half-width, in elements", "contacts", edges)}});
  const auto [least, most] = std::ranges::minmax_element(studies[1].beside);
  document.check("profiles-converge", orders, "each profile converges with its own order");
  document.check("singularities-stay-local",
                 {Criterion::in_each("order away from the singularity", "profiles", orders_away)},
                 "a tenth of a from a singularity the error is of second order");
  document.check("wedge-apex-error-stays",
                 {Criterion::at_most("largest over smallest error on the grids",
                                     Value(*most / *least, significant(3)).as_is(),
                                     {LimitKind::choice, 1.02, "what was found, with a margin"})},
                 "beside the wedge's apex the error is the same on all grids");
}

void register_profiles(Document& document, const ContactCase& c, const Hertz& hertz,
                       const UnitSystem& units) {
  literate::Table table("profiles", {Column::text("profile"), Column("peak$/p_0$", fixed(4)),
                                     Column("peak", fixed(0)).scaled(-6).under("error of"),
                                     Column("half-width", fixed(0)).scaled(-6).under("error of"),
                                     Column("error", fixed(0)).scaled(-6).under("$p$, inside"),
                                     Column("order", uncertain()).under("$p$, inside")});
  const double p0 = hertz.peak_pressure();
  const double a = hertz.half_width();
  std::vector<ProfileStudy> studies;
  std::vector<Criterion> half_widths;
  for (const KnownContact& known : known_contacts(c, hertz)) {
    half_widths.push_back(Criterion::at_most(
        "difference", Value(std::abs(known.half_width / a - 1), scientific(1).rounded_up()).as_is(),
        {LimitKind::choice, 1e-12, "each is a root of the load, found to rounding"}));
    studies.push_back(study_of(known, c, hertz));
    const ProfileStudy& study = studies.back();
    const ProfileErrors& e = study.printed;
    const bool is_finite = std::isfinite(known.peak);
    const Cell nothing = Cell::latex("--");
    // The closed forms of all profiles have at most five times the roundings of Hertz.
    const double closed = 5 * rounded(c, 1);
    table.add_row({Cell::latex(known.name),
                   is_finite ? Cell(Estimate{known.peak / p0, closed * known.peak / p0}) : "∞",
                   is_finite ? Estimate{e.peak, e.bound + closed} : nothing,
                   Estimate{e.edge / e.elements, e.of_edge + closed},
                   Estimate{e.inside, e.bound + closed}, order_of(study, study.inside)});
  }
  document.table(std::move(table));
  document.value("profiles.elements.least", Value(closed_form(studies[0].fewest), fixed(1)));
  document.value("profiles.elements.most", Value(closed_form(studies[0].most), fixed(1)));
  document.value("profiles.n-positions", Value(n_places, integer()));
  const double slope = c.line_load / (c.cylinders.contact_modulus() * a);
  document.value("profiles.slope", Value(slope, significant(3)).within(rounded(c, slope)));
  document.value("profiles.flat", Value(flat_share, exact()));
  // The difference in punch_curvature() is 0.30 a², of terms of 0.80 a² and 0.50 a².
  const double edge_radius = 1 / punch_curvature(c, a);
  document.value(
      "profiles.edge-radius",
      Value(edge_radius, significant(3), units.length).within(5 * rounded(c, edge_radius)));
  document.value("profiles.coarsest", Value(closed_form(studies[0].elements.front()), fixed(0)));
  document.value("profiles.finest", Value(closed_form(studies[0].elements.back()), fixed(0)));
  document.value("profiles.wedge-away", Value(order_of(studies[1], studies[1].away), uncertain()));
  document.value("profiles.punch-away", Value(order_of(studies[2], studies[2].away), uncertain()));
  document.value("profiles.apex-error",
                 Value(Estimate{studies[1].beside.back(), studies[1].bound.back()}, percent(0)));
  document.check("profiles-share-their-half-width",
                 {Criterion::in_each("relative difference from that of the cylinders", "profiles",
                                     half_widths)},
                 "the closed forms have the half-width of the cylinders");
  check_orders(document, studies);
}

}  // namespace

void compute_profiles(Document& document, const Case& from) {
  register_profiles(document, from.contact, Hertz(from.contact.cylinders, from.contact.line_load),
                    from.units);
}

}  // namespace paper
