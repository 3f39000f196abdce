// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/spheres.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "numerics/scatter.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/prelude.hpp"
#include "point_contact/study/two_spheres.hpp"

namespace paper {
namespace {

using point_contact::ElementStudy;
using point_contact::TwoSpheres;

using PointElement = point_contact::Element;

constexpr std::array point_elements = {PointElement::pyramid, PointElement::bilinear,
                                       PointElement::uniform, PointElement::point};
constexpr std::array names_of_elements = {"pyramids", "bilinear", "uniform", "forces"};

// Of slopes the bound is (4/π) ln(a/r) δ, where r > c/8 is the distance of the nearest node, and
// of stresses near the surface not more.
double bound_between_nodes(double of_pressure) {
  return 10 * of_pressure;
}

// The coarser spacings, where factors are not constant yet, are drawn and not fitted: what is left
// are 25 to 50 elements over the radius.
constexpr std::size_t n_only_drawn = 2;

// What makes errors scatter about their power law.
constexpr const char* places = "places of the edge";

// One error of the study: its values and bounds, the order that is expected of elements with a
// pressure, and what the table says it is in units of.
struct StudiedError {
  const char* name;
  std::vector<double> ElementStudy::*errors;
  double (*bound)(double);
  std::array<double, 4> expected;  // in the order of point_elements
};

double bound_of_pressure(double of_pressure) {
  return of_pressure;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const std::array<StudiedError, 6> studied_errors = {{
    {"pressure, inside", &ElementStudy::inside, bound_of_pressure, {2, 2, 2, unknown}},
    {"pressure, largest", &ElementStudy::largest, bound_of_pressure, {0.5, 0.5, 0.5, unknown}},
    {"radius by second moments", &ElementStudy::radius, bound_of_radius, {2, 2, 2, unknown}},
    {"approach", &ElementStudy::approach, bound_of_approach, {2, 2, 2, unknown}},
    {"slope between nodes", &ElementStudy::slope, bound_between_nodes, {2, 2, 1, 0}},
    {"stress at depth $c/2$", &ElementStudy::stress, bound_between_nodes, {2, 2, 1, 0}},
}};
constexpr std::size_t inside = 0;

// The errors that are fitted, each times (a/c)^order.
std::vector<Estimate> factors_of(const ElementStudy& study, const StudiedError& error,
                                 double order) {
  std::vector<Estimate> factors;
  for (std::size_t i = n_only_drawn; i < study.elements.size(); ++i) {
    const double scale = std::pow(study.elements[i], order);
    factors.push_back(scale * Estimate{(study.*error.errors)[i], error.bound(study.bound[i])});
  }
  return factors;
}

numerics::ScatteredPower fit(const ElementStudy& study, const StudiedError& error) {
  const std::vector<double> elements(study.elements.begin() + n_only_drawn, study.elements.end());
  return numerics::fit_scattered_power(elements, factors_of(study, error, 0), places);
}

// The factor of one element over that of another, with the order of both.
Measured ratio(const ElementStudy& first, const ElementStudy& second, const StudiedError& error,
               double order) {
  const auto of_first = factors_of(first, error, order);
  const auto of_second = factors_of(second, error, order);
  std::vector<Estimate> ratios;
  for (std::size_t i = 0; i < of_first.size(); ++i) ratios.push_back(of_first[i] / of_second[i]);
  return numerics::mean_of(ratios, places);
}

Criterion of_order(const StudiedError& error, std::size_t element, const ElementStudy& study) {
  return is_of_order(std::string(error.name) + ", " + names_of_elements[element] + ": order",
                     fit(study, error).order, error.expected[element]);
}

void claim_elements(Document& document, const std::vector<ElementStudy>& studies) {
  std::vector<Criterion> orders, slopes;
  for (const StudiedError& error : studied_errors) {
    // The largest error is that of one node, and scatters with the place of the edge.
    if (error.errors == &ElementStudy::largest) continue;
    for (std::size_t element = 0; element < point_elements.size(); ++element) {
      if (std::isnan(error.expected[element])) continue;
      orders.push_back(of_order(error, element, studies[element]));
      if (error.errors == &ElementStudy::slope) slopes.push_back(orders.back());
    }
  }
  document.check("orders-of-point-elements", orders,
                 "the errors of two spheres converge with the expected orders");
  constexpr std::size_t pyramid = 0, hat = 1, uniform = 2;
  const StudiedError& pressure = studied_errors[inside];
  const Measured of_pyramids = ratio(studies[pyramid], studies[uniform], pressure, 2);
  const Measured of_hats = ratio(studies[hat], studies[uniform], pressure, 2);
  const Limit no_gain(LimitKind::data, 1.0, "a ratio below 1 would be a gain");
  std::vector<Criterion> criteria = slopes;
  criteria.push_back(
      Criterion::at_least("pressure inside: error of pyramids over that of uniform elements",
                          Value(of_pyramids, uncertain()), no_gain.counting(2)));
  criteria.push_back(
      Criterion::at_least("pressure inside: error of bilinear over that of uniform elements",
                          Value(of_hats, uncertain()), no_gain.counting(2)));
  document.claim(
      "pyramids-gain-between-nodes",
      {.route = "powers fitted to the errors against Hertz: of the pressure over 𝑟 ≤ 0.8 𝑎, of the "
                "slope at eight places between the nodes",
       .expected = Verdict::confirmed,
       .criteria = criteria});
  document.value("spheres.pressure-ratio", Value(of_pyramids, uncertain()));
  document.value("spheres.pressure-ratio-hats", Value(of_hats, uncertain()));
}

}  // namespace

void study_elements(Document& document, const ContactCase& c, const TwoSpheres& spheres) {
  std::vector<ElementStudy> studies;
  for (const PointElement element : point_elements) {
    studies.push_back(study_element(spheres, c.body1.material, element));
  }
  std::vector<Column> columns{Column::text("error of")};
  for (const char* const element : names_of_elements) {
    columns.push_back(Column(element, uncertain()).under("order"));
  }
  literate::Table table("point-elements", columns);
  for (const StudiedError& error : studied_errors) {
    std::vector<Cell> row = {literate::Cell::latex(error.name)};
    for (std::size_t element = 0; element < studies.size(); ++element) {
      const bool falls = error.expected[element] != 0;
      row.push_back(falls ? Cell(fit(studies[element], error).order) : literate::Cell::latex("--"));
    }
    table.add_row(row);
  }
  document.table(std::move(table));
  claim_elements(document, studies);

  const ElementStudy& squares = studies[1];
  const auto count = [&](const char* key, double number) {
    document.value(key, Value(closed_form(number), fixed(0)));
  };
  document.value("spheres.n-places", Value(point_contact::n_study_places, integer()));
  document.value("spheres.n-spacings",
                 Value(std::ssize(squares.elements) - static_cast<long>(n_only_drawn), integer()));
  count("spheres.coarsest", squares.elements[n_only_drawn]);
  count("spheres.finest", studies.front().elements.back());
}

}  // namespace paper
