// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/spheres.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "paper/bounds.hpp"
#include "paper/prelude.hpp"
#include "point_contact/study/two_spheres.hpp"

namespace paper {
namespace {

using point_contact::ElementStudy;
using point_contact::TwoSpheres;

using PointElement = point_contact::Element;

constexpr std::array point_elements = {PointElement::pyramid, PointElement::bilinear,
                                       PointElement::uniform, PointElement::point};

// Of slopes the bound is (4/π) ln(a/r) δ, where r > c/8 is the distance of the nearest node, and
// of stresses near the surface not more.
double bound_between_nodes(double of_pressure) {
  return 10 * of_pressure;
}

// One error of the study: where its grids, values and bounds are, and what order is expected of
// each element; none of an element that has no pressure between its nodes.
struct StudiedError {
  const char* name;
  std::vector<double> ElementStudy::*elements;
  std::vector<double> ElementStudy::*errors;
  double (*bound)(double);
  std::array<double, 4> expected;  // in the order of point_elements
};

double bound_of_pressure(double of_pressure) {
  return of_pressure;
}
double no_bound(double /*of_pressure*/) {
  return 0;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const std::array<StudiedError, 7> studied_errors = {{
    {"pressure, inside",
     &ElementStudy::elements,
     &ElementStudy::inside,
     bound_of_pressure,
     {2, 2, 2, unknown}},
    {"pressure, largest",
     &ElementStudy::elements,
     &ElementStudy::largest,
     bound_of_pressure,
     {0.5, 0.5, 0.5, unknown}},
    {"radius, by area",
     &ElementStudy::elements,
     &ElementStudy::radius_by_area,
     no_bound,
     {1, 1, 1, unknown}},
    {"radius, by moments",
     &ElementStudy::elements,
     &ElementStudy::radius,
     bound_of_radius,
     {2, 2, 2, unknown}},
    {"approach",
     &ElementStudy::elements,
     &ElementStudy::approach,
     bound_of_approach,
     {2, 2, 2, unknown}},
    {"slope between nodes",
     &ElementStudy::surface_elements,
     &ElementStudy::slope,
     bound_between_nodes,
     {2, 2, 1, 0}},
    {"stress near the surface",
     &ElementStudy::surface_elements,
     &ElementStudy::stress,
     bound_between_nodes,
     {2, 2, 1, 0}},
}};

PowerFit fit(const ElementStudy& study, const StudiedError& error) {
  const std::vector<double>& values = study.*error.errors;
  std::vector<double> bounds;
  for (std::size_t i = 0; i < values.size(); ++i) bounds.push_back(error.bound(study.bound[i]));
  return fit_power(study.*error.elements, values, bounds);
}

void claim_elements(Document& document, const std::array<std::array<PowerFit, 4>, 7>& fits) {
  constexpr std::size_t inside = 0;
  constexpr std::size_t slope = 5;
  const char* const scatter = "where the edge lies between the nodes differs from grid to grid";
  const auto of_order = [&](std::size_t error, std::size_t element, const Limit& limit) {
    const StudiedError& e = studied_errors[error];
    return Criterion::agrees(
        std::string(e.name) + ", " + std::string(name_of(point_elements[element])) + ": order",
        Value(fits[error][element].order, fixed(2)), Value(e.expected[element], exact()), limit);
  };
  std::vector<Criterion> orders;
  for (std::size_t error = 0; error < studied_errors.size(); ++error) {
    for (std::size_t element = 0; element < point_elements.size(); ++element) {
      if (std::isnan(studied_errors[error].expected[element])) continue;
      // The area is that of whole cells, whose number scatters with each grid.
      const bool is_count = studied_errors[error].errors == &ElementStudy::radius_by_area;
      orders.push_back(
          of_order(error, element, {LimitKind::choice, is_count ? 0.5 : 0.35, scatter}));
    }
  }
  document.check("orders-of-point-elements", orders,
                 "the errors of two spheres converge with the expected orders");
  const auto ratio = [&](std::size_t element, std::size_t other) {
    return fits[inside][element].factor / fits[inside][other].factor;
  };
  const auto nearest = [&](std::size_t element, const char* reason) {
    return of_order(slope, element, {LimitKind::choice, 0.25, reason});
  };
  const char* const same = "nearer to it than to any other half order";
  document.claim(
      "pyramids-gain-between-nodes",
      {.route = "powers fitted to the errors against Hertz: of the pressure over 𝑟 ≤ 0.8𝑎, of the "
                "slope at eighths between the nodes",
       .expected = Verdict::confirmed,
       .criteria = {nearest(0, same), nearest(1, same), nearest(2, same), nearest(3, same),
                    Criterion::at_least(
                        "pressure inside: factor 𝐵 of pyramids over that of uniform elements",
                        Value(ratio(0, 2), significant(2)),
                        {LimitKind::choice, 0.8, "less would be a gain of a fifth"})}});
  document.value("spheres.pressure-ratio", Value(ratio(0, 2), fixed(1)));
  document.value("spheres.pressure-ratio-hats", Value(ratio(1, 2), fixed(1)));
}

}  // namespace

void study_elements(Document& document, const ContactCase& c, const TwoSpheres& spheres) {
  std::vector<ElementStudy> studies;
  for (const PointElement element : point_elements) {
    studies.push_back(study_element(spheres, c.body1.material, element));
  }
  const char* const pyramids = "pyramids";
  const char* const hats = "bilinear";
  const char* const uniform = "uniform";
  const char* const forces = "forces";
  literate::Table table(
      "point-elements",
      {Column::text("error of"), Column("$r$", fixed(2)).under(pyramids),
       Column("$B$", fixed(3)).under(pyramids), Column("$r$", fixed(2)).under(hats),
       Column("$B$", fixed(3)).under(hats), Column("$r$", fixed(2)).under(uniform),
       Column("$B$", fixed(3)).under(uniform), Column("$r$", fixed(2)).under(forces),
       Column("$B$", fixed(3)).under(forces)});
  std::array<std::array<PowerFit, 4>, 7> fits{};
  for (std::size_t error = 0; error < studied_errors.size(); ++error) {
    std::vector<Cell> row = {studied_errors[error].name};
    for (std::size_t element = 0; element < studies.size(); ++element) {
      const PowerFit power = fit(studies[element], studied_errors[error]);
      fits[error][element] = power;
      row.emplace_back(power.order);
      row.emplace_back(power.factor);
    }
    table.add_row(row);
  }
  document.table(std::move(table));
  claim_elements(document, fits);

  const ElementStudy& first = studies.front();
  const auto count = [&](const char* key, double number) {
    document.value(key, Value(closed_form(number), fixed(0)));
  };
  document.value("spheres.n-grids", Value(std::ssize(first.elements), integer()));
  count("spheres.coarsest", first.elements.front());
  count("spheres.finest", first.elements.back());
  count("spheres.finest-surface", first.surface_elements.back());

  Figure figure{.width_cm = 14, .height_cm = 5.2};
  for (std::size_t i = 0; i < studies.size(); ++i) {
    const std::string name(name_of(point_elements[i]));
    figure.data[name] = {{"elements", studies[i].elements}, {"inside", studies[i].inside}};
    figure.data[name + "_surface"] = {{"elements", studies[i].surface_elements},
                                      {"slope", studies[i].slope}};
  }
  document.figure("sphere-convergence", std::move(figure));
}

}  // namespace paper
