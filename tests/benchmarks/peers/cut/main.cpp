// SPDX-License-Identifier: GPL-3.0-or-later
// The displacement under a triangular load, by quadrature and in closed form: two figures, a table,
// four numbers. ../knitr contains the same in R.
#include <algorithm>
#include <cmath>
#include <vector>

#include "config/table.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/triangular_load.hpp"
#include "literate/main/main.hpp"

namespace {

using literate::Column;
using literate::exact;
using literate::fixed;
using literate::scientific;
using literate::significant;
using literate::Value;
using numerics::Estimate;

struct Case {
  elasticity::Material material;
  elasticity::TriangularLoad load;
  double datum;
};

Case read_case(const std::filesystem::path& file) {
  const config::Table table = config::Table::parse_file(file);
  const Case c{{table.quantity("young", "psi"), table.number("poisson")},
               {table.quantity("peak", "psi"), table.quantity("half_width", "in")},
               table.quantity("datum", "in")};
  table.reject_unknown_keys();
  return c;
}

void compute(literate::Document& document, const std::filesystem::path& case_file) {
  const Case c = read_case(case_file);
  const double a = c.load.half_width();
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  const auto closed_form = [&](double x) {
    return normal_displacement(c.material, c.load, x, c.datum);
  };

  std::vector<double> points, quadrature;
  literate::Table table("displacements", {Column("$x$", fixed(3), "in").exact(),
                                          Column("eq.\\ (2)", fixed(8), "in").scaled(-6),
                                          Column("eq.\\ (3)", fixed(8), "in").scaled(-6)});
  double largest = 0;
  for (int i = 0; i <= 10; ++i) {
    const double x = 0.5 * i * a;
    points.push_back(x);
    const Estimate by_quadrature = surface.normal_displacement(x);
    quadrature.push_back(by_quadrature.value);
    largest = std::max(largest, std::abs(quadrature.back() / closed_form(x) - 1));
    table.add_row({x, by_quadrature, Estimate{closed_form(x), 1e-14 * std::abs(closed_form(x))}});
  }
  document.table(std::move(table));
  document.value("peak", Value(c.load.peak_pressure(), exact(), "psi"));
  document.value("half-width", Value(a, exact(), "in"));
  const double middle = closed_form(0);
  document.value("middle", Value(Estimate{middle, 1e-14 * std::abs(middle)}, significant(8), "in"));
  document.value("largest", Value(largest, scientific(1).rounded_up()).as_is());

  std::vector<double> x, displacement, gradient;
  for (int i = -200; i <= 200; ++i) {
    x.push_back(0.025 * i * a);
    displacement.push_back(closed_form(x.back()));
    gradient.push_back(normal_gradient(c.material, c.load, x.back()));
  }
  document.figure("displacement", {.width_cm = 12,
                                   .height_cm = 7,
                                   .data = {{"line", {{"x", x}, {"u", displacement}}},
                                            {"integrals", {{"x", points}, {"u", quadrature}}}}});
  document.figure("gradient", {.width_cm = 12,
                               .height_cm = 7,
                               .data = {{"line", {{"x", x}, {"slope", gradient}}}},
                               .numbers = {{"half_width", a}}});
}

}  // namespace

int main(int argc, char** argv) {
  return literate::main(argc, argv, compute);
}
