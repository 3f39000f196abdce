// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "line_contact/element.hpp"
#include "line_contact/solver.hpp"
#include "numerics/scatter.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/convergence.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using line_contact::Element;
using numerics::fit_scattered_power;
using numerics::mean_of;

// What makes errors scatter about their power law, and their means.
constexpr const char* places = "places of the edge";

// How many standard uncertainties count: about 95 % of a normal distribution.
constexpr double counted = 2;

// Grids of so many nodes, odd so that one lies in the middle: 60 to 400 elements over the
// half-width, where the factors of all errors are constant, and before them the coarser ones that
// are only drawn.
constexpr std::size_t n_only_drawn = 2;
constexpr std::array n_nodes_of_spacings = {67L, 95L, 133L, 179L, 241L, 335L, 447L, 607L, 881L};

using Study = std::vector<SpacingErrors>;

Study study_of(const ContactCase& c, const Hertz& hertz, Element element) {
  Study study;
  for (const long n_nodes : n_nodes_of_spacings) {
    study.push_back(errors_at_spacing(c, hertz, element, n_nodes));
  }
  return study;
}

// One error of the study: what its bound is, none of a count, and the order that theory gives it.
struct Quantity {
  const char* name;
  double expected;
  double HertzErrors::*error;
  double SpacingErrors::*bound;
};

const std::array<Quantity, 6> quantities = {{
    {"pressure, inside", 2, &HertzErrors::inside, &SpacingErrors::of_pressure},
    {"peak", 2, &HertzErrors::peak, &SpacingErrors::of_pressure},
    {"half-width by second moment", 2, &HertzErrors::half_width_moment, &SpacingErrors::of_moment},
    {"half-width extrapolated", 1, &HertzErrors::half_width_extrapolated, &SpacingErrors::of_edge},
    {"half-width by count", 1, &HertzErrors::half_width_count, nullptr},
    {"pressure, largest", 0.5, &HertzErrors::largest, &SpacingErrors::of_pressure},
}};
constexpr std::size_t inside = 0;
constexpr std::size_t of_peak = 1;

// The factors of one error at the spacings that are fitted.
std::vector<Estimate> factors_of(const Study& study, const Quantity& quantity, double order) {
  std::vector<Estimate> factors;
  for (std::size_t i = n_only_drawn; i < study.size(); ++i) {
    const double bound = quantity.bound == nullptr ? 0 : study[i].*quantity.bound;
    factors.push_back(factor_of(study[i], quantity.error, bound, order));
  }
  return factors;
}

Measured order_of(const Study& study, const Quantity& quantity) {
  std::vector<double> elements;
  for (std::size_t i = n_only_drawn; i < study.size(); ++i) elements.push_back(study[i].elements);
  return fit_scattered_power(elements, factors_of(study, quantity, 0), places).order;
}

// The study at every second place of the edge, from the given one on.
Study every_second(const Study& study, std::size_t first) {
  Study half = study;
  for (std::size_t i = 0; i < study.size(); ++i) {
    half[i].errors.clear();
    for (std::size_t k = first; k < study[i].errors.size(); k += 2) {
      half[i].errors.push_back(study[i].errors[k]);
    }
  }
  return half;
}

// The mean over the spacings of what is found of a study, uncertain by its scatter and by the
// choice of the places: half of what every second place changes. The places are the same at each
// spacing, so that the mean does not lessen the latter.
template <class Found>
Measured mean_over_spacings(const Found& found) {
  const std::vector<Estimate> first = found(0), second = found(1);
  double squares = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    squares += std::pow((first[i].value - second[i].value) / 2, 2);
  }
  const double of_choice = std::sqrt(squares / static_cast<double>(first.size()));
  const Measured mean = mean_of(found(std::nullopt), places);
  return of_choice == 0 ? mean : mean + Measured(0, of_choice, "choice of the places");
}

Measured mean_factor(const Study& study, const Quantity& quantity) {
  return mean_over_spacings([&](std::optional<std::size_t> half) {
    return factors_of(half ? every_second(study, *half) : study, quantity, quantity.expected);
  });
}

// How many times as large as that of uniform elements the factor of triangles is: at each spacing
// both have the edge at the same places.
Measured mean_ratio(const Study& triangular, const Study& uniform, const Quantity& quantity) {
  return mean_over_spacings([&](std::optional<std::size_t> half) {
    const auto of = [&](const Study& study) {
      return factors_of(half ? every_second(study, *half) : study, quantity, quantity.expected);
    };
    const std::vector<Estimate> of_triangles = of(triangular), of_uniform = of(uniform);
    std::vector<Estimate> ratios;
    for (std::size_t i = 0; i < of_triangles.size(); ++i) {
      ratios.push_back(of_triangles[i] / of_uniform[i]);
    }
    return ratios;
  });
}

void claim_pressures(Document& document, const Study& triangular, const Study& uniform) {
  const Limit same(LimitKind::data, 1.0, "a ratio below 1 would be a gain");
  const auto no_better = [&](const char* what, std::size_t quantity) {
    return Criterion::at_least(
        what, Value(mean_ratio(triangular, uniform, quantities[quantity]), uncertain()),
        same.counting(counted));
  };
  document.claim(
      "pressure-at-the-nodes",
      {.route = "the errors against Hertz with the edge at 20 places between two nodes, on grids "
                "of 60 to 400 elements over the half-width",
       .expected = Verdict::confirmed,
       .criteria = {is_of_order("order of the error inside, triangles",
                                order_of(triangular, quantities[inside]), 2),
                    is_of_order("order of the error inside, uniform elements",
                                order_of(uniform, quantities[inside]), 2),
                    no_better("error inside, triangles over uniform elements", inside),
                    no_better("error of the peak, triangles over uniform elements", of_peak)}});
}

// How many times as large as the smallest the largest error inside is at one spacing.
void register_spread(Document& document, const SpacingErrors& at) {
  const auto [least, most] = std::ranges::minmax(at.errors, {}, &HertzErrors::inside);
  document.value("elements.spread", Value(Estimate{most.inside, at.of_pressure} /
                                              Estimate{least.inside, at.of_pressure},
                                          significant(2)));
  document.value("elements.spread.least", Value(closed_form(at.errors.front().elements), fixed(1)));
  document.value("elements.spread.most", Value(closed_form(at.errors.back().elements), fixed(1)));
}

void register_orders(Document& document, const Study& triangular, const Study& uniform) {
  literate::Table table(
      "element-orders",
      {Column::text("error of"), Column("$r$", uncertain()).under("triangles"),
       Column("$B$", uncertain()).under("triangles"), Column("$r$", uncertain()).under("uniform"),
       Column("ratio of $B$", uncertain())});
  std::vector<Criterion> orders;
  for (const Quantity& quantity : quantities) {
    const Measured first = order_of(triangular, quantity);
    const Measured second = order_of(uniform, quantity);
    for (const Measured& order : {first, second}) {
      orders.push_back(is_of_order(quantity.name, order, quantity.expected));
    }
    table.add_row({quantity.name, first, mean_factor(triangular, quantity), second,
                   mean_ratio(triangular, uniform, quantity)});
  }
  document.table(std::move(table));
  document.check("orders-of-convergence", orders,
                 "all errors of contact converge with the expected orders");
  claim_pressures(document, triangular, uniform);
  register_spread(document, triangular[n_only_drawn + 1]);
  const auto ratio = [&](const char* key, std::size_t quantity) {
    document.value(key, Value(mean_ratio(triangular, uniform, quantities[quantity]), uncertain()));
  };
  ratio("elements.inside-ratio", inside);
  ratio("elements.peak-ratio", of_peak);
  document.value("elements.n-places", Value(n_edge_places, integer()));
  document.value("elements.n-spacings",
                 Value(std::ssize(triangular) - static_cast<long>(n_only_drawn), integer()));
  const auto count = [&](const char* key, const SpacingErrors& at) {
    document.value(key, Value(closed_form(at.errors.front().elements), fixed(0)));
  };
  count("elements.coarsest", triangular[n_only_drawn]);
  count("elements.finest", triangular.back());
}

// The mean errors of one kind of element between and beneath the nodes at one spacing.
struct QualityAt {
  double elements = 0;  // a/c on the coarsest of the grids
  std::vector<Estimate> slope, shear;
};

QualityAt quality_at(const ContactCase& c, const Hertz& hertz, Element element, long n_nodes) {
  constexpr int n_places = 3;
  constexpr double tolerance = 1e-12;
  QualityAt at;
  for (const line_contact::Grid& grid : grids_of(hertz, n_nodes, n_places)) {
    const line_contact::Solution solution = line_contact::solve_by_fft(
        {c.cylinders.profile(), c.cylinders.contact_modulus(), grid, element}, c.line_load,
        tolerance);
    const ElementQuality quality = quality_of(c, hertz, solution);
    // Pressures that are wrong by δp₀ move the slope by (2/π)(ln N + 1)δ a/R at most, five for any
    // N up to 500, and the shear by less.
    const double bound = 5 * pressure_error(solution) + rounded(c, 1);
    if (at.slope.empty()) at.elements = hertz.half_width() / grid.spacing;
    at.slope.push_back({quality.slope.value, quality.slope.abs_error + bound});
    at.shear.push_back({quality.shear.value, quality.shear.abs_error + bound});
  }
  return at;
}

using Errors = std::vector<Estimate> QualityAt::*;

Measured order_between_nodes(const std::vector<QualityAt>& study, Errors errors) {
  std::vector<double> elements;
  std::vector<Estimate> all;
  for (const QualityAt& at : study) {
    const auto n = static_cast<double>((at.*errors).size());
    for (std::size_t k = 0; k < (at.*errors).size(); ++k) {
      elements.push_back(at.elements + static_cast<double>(k) / n);
      all.push_back((at.*errors)[k]);
    }
  }
  return fit_scattered_power(elements, all, places).order;
}

void claim_quality(Document& document, const std::vector<QualityAt>& triangular,
                   const std::vector<QualityAt>& uniform) {
  const auto order = [&](const char* what, const std::vector<QualityAt>& study, Errors errors,
                         double expected) {
    return is_of_order(what, order_between_nodes(study, errors), expected);
  };
  document.claim(
      "triangles-gain-between-nodes",
      {.route = "powers fitted to the mean errors of the slope and of the shear stress at the "
                "depth 𝑐/2, |𝑥| ≤ 0.9 𝑎, on grids of 60 to 120 elements over the half-width",
       .expected = Verdict::confirmed,
       .criteria = {
           order("order of the slope, triangles", triangular, &QualityAt::slope, 2),
           order("order of the slope, uniform elements", uniform, &QualityAt::slope, 1),
           order("order of the shear stress, triangles", triangular, &QualityAt::shear, 2),
           order("order of the shear stress, uniform elements", uniform, &QualityAt::shear, 1)}});
}

// What each kind of element says between and beneath the nodes of the same contact. The slope that
// forces make has no mean: beside each of them it goes with 1/x.
void register_quality(Document& document, const ContactCase& c, const Hertz& hertz) {
  constexpr std::array n_nodes = {133L, 187L, 265L};  // from 60 elements on, as above
  std::vector<QualityAt> triangular, uniform;
  for (const long n : n_nodes) {
    triangular.push_back(quality_at(c, hertz, Element::triangular, n));
    uniform.push_back(quality_at(c, hertz, Element::uniform, n));
  }
  const QualityAt point = quality_at(c, hertz, Element::point, n_nodes.front());

  const auto under = [](const char* what) {
    return std::array{Column("error", scientific(2)).under(what),
                      Column("order", uncertain()).under(what)};
  };
  const auto slope = under("slope, over $a/R$");
  const auto shear = under("shear stress, over $p_0$");
  literate::Table table("between-nodes",
                        {Column::text("element"), slope[0], slope[1], shear[0], shear[1]});
  const Cell none = Cell::latex("--");
  table.add_row({"force", "infinite", none, mean_of(point.shear, places), none});
  const auto add = [&](const char* element, const std::vector<QualityAt>& study) {
    table.add_row({element, mean_of(study.front().slope, places),
                   order_between_nodes(study, &QualityAt::slope),
                   mean_of(study.front().shear, places),
                   order_between_nodes(study, &QualityAt::shear)});
  };
  add("uniform", uniform);
  add("triangle", triangular);
  document.table(std::move(table));
  document.value("elements.count", Value(closed_form(triangular.front().elements), fixed(0)));
  document.value("elements.most-count", Value(closed_form(triangular.back().elements), fixed(0)));
  claim_quality(document, triangular, uniform);
}

}  // namespace

void compute_elements(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const Hertz hertz(c.cylinders, c.line_load);
  register_quality(document, c, hertz);
  const Study triangular = study_of(c, hertz, Element::triangular);
  const Study uniform = study_of(c, hertz, Element::uniform);
  register_orders(document, triangular, uniform);
}

}  // namespace paper
