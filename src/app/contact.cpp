// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/csv_files.hpp"
#include "command_line/stage.hpp"
#include "contact/resolution.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"
#include "system/error.hpp"

namespace app {
namespace {

using config::UnitSystem;
using line_contact::Element;
using line_contact::Radius;
using parameters::ContactCase;

// Two cylinders, and what is known of their contact.
struct Cylinders {
  line_contact::Profile profile;
  line_contact::Hertz hertz;
  double least_radius;
};

Cylinders cylinders_of(const ContactFlags& flags, const std::optional<ContactCase>& from_case,
                       const elasticity::Material& material1, const elasticity::Material& material2,
                       double load, const UnitSystem& units) {
  auto radius1 = radius_of(flags.radius1, units.length);
  auto radius2 = radius_of(flags.radius2, units.length);
  if (!radius1 && from_case) radius1 = from_case->body1.radius;
  if (!radius2) radius2 = from_case ? from_case->body2.radius : Radius::of_plane();
  if (!radius1) throw sys::InputError("--radius1 is missing");
  const double curvature1 = radius1->curvature(), curvature2 = radius2->curvature();
  if (!(curvature1 + curvature2 > 0)) {
    throw sys::InputError(fmt::format(
        "1/radius1 + 1/radius2 = {}: must be greater than 0: at most one plane, and a hollow wider "
        "than the cylinder in it",
        rounded(curvature1 + curvature2)));
  }
  const line_contact::CylinderPair cylinders(material1, *radius1, material2, *radius2);
  return {cylinders.profile(), line_contact::Hertz(cylinders, load),
          1 / std::max(std::abs(curvature1), std::abs(curvature2))};
}

line_contact::Profile measured_profile(const std::string& file) {
  const CurvePoints points = read_curve(file, "x,gap", 4);
  return line_contact::Profile::tabulated(points.x, points.y);
}

}  // namespace

double SolvedContact::half_width() const {
  if (hertz) return solution.half_width();
  const auto regions = solution.regions();
  return regions.empty() ? 0 : (regions.back().end - regions.front().begin) / 2;
}

std::vector<const Flag*> ContactFlags::own() const {
  return {&load,          &datum,   &radius1, &radius2, &body1.young, &body1.poisson, &body2.young,
          &body2.poisson, &profile, &nodes,   &domain,  &element,     &method,        &tolerance};
}

line_contact::Grid ContactFlags::grid_of(const line_contact::Profile& gap,
                                         const std::optional<line_contact::Hertz>& hertz,
                                         long n_nodes, const UnitSystem& units) const {
  const auto width = domain.positive(units.length);
  if (!hertz) {
    const double given_width = gap.end() - gap.begin();
    return line_contact::grid_of_width(width.value_or(given_width), n_nodes,
                                       (gap.begin() + gap.end()) / 2);
  }
  if (!width) return line_contact::grid_around(hertz->half_width(), n_nodes);
  if (*width < 2 * hertz->half_width()) {
    domain.refuse(fmt::format("must be greater than {} {}, the width of Hertz's contact",
                              rounded(2 * hertz->half_width()), units.length));
  }
  return line_contact::grid_of_width(*width, n_nodes);
}

SolvedContact ContactFlags::solve(const Given& given) const {
  const UnitSystem& units = given.units;
  std::optional<ContactCase> from_case;
  if (given.file) from_case = given.file->contact();
  const auto material_of_case = [&](parameters::CylinderCase ContactCase::*body) {
    return of_case(of_case(from_case, body), &parameters::CylinderCase::material);
  };
  std::vector<std::string> notes;
  const elasticity::Material material1 =
      material_of(body1, both, material_of_case(&ContactCase::body1), units.stress, notes);
  const elasticity::Material material2 =
      material_of(body2, both, material_of_case(&ContactCase::body2), units.stress, notes);
  const double p = read({{load, units.line_load, of_case(from_case, &ContactCase::line_load)}})[0];
  constexpr long usual_nodes = 401, quickly_inverted = 1000;
  const long n_nodes = nodes.count(line_contact::min_nodes, line_contact::max_nodes)
                           .value_or(from_case ? from_case->n_nodes : usual_nodes);

  using Method = std::function<line_contact::Solution(const line_contact::Problem&)>;
  const auto relative_error = tolerance.positive("1");
  const std::string name = method.text_or(n_nodes <= quickly_inverted ? "matrix-inversion" : "fft");
  if (name != "fft") refuse_given({&tolerance}, "--method " + name);
  const Method fft = [&](const auto& problem) {
    return line_contact::solve_by_fft(problem, p,
                                      relative_error.value_or(line_contact::default_tolerance));
  };
  const Method inversion = [&](const auto& problem) {
    return line_contact::solve_by_matrix_inversion(problem, p);
  };
  const Method variational = [&](const auto& problem) {
    return line_contact::solve_by_variational_method(problem, p);
  };
  const Method solve = method.choice_or(
      name == "fft" ? fft : inversion,
      {{"fft", fft}, {"matrix-inversion", inversion}, {"variational", variational}});

  line_contact::Problem problem{
      line_contact::Profile::parabola(1),
      elasticity::contact_modulus(material1, material2),
      {},
      element.choice_or(Element::triangular, {{"triangular", Element::triangular},
                                              {"uniform", Element::uniform},
                                              {"point", Element::point}})};
  std::optional<line_contact::Hertz> hertz;
  double least_radius = 0;
  const std::string shape = profile.text_or("cylinder");
  if (shape == "cylinder") {
    const Cylinders cylinders = cylinders_of(*this, from_case, material1, material2, p, units);
    problem.profile = cylinders.profile;
    hertz = cylinders.hertz;
    least_radius = cylinders.least_radius;
  } else if (shape.starts_with("file:")) {
    refuse_given({&radius1, &radius2}, "--profile " + shape);
    problem.profile = measured_profile(shape.substr(5));
  } else {
    profile.refuse("must be cylinder or file:PATH");
  }
  problem.grid = grid_of(problem.profile, hertz, n_nodes, units);
  auto place = datum.positive(units.length);
  if (!place) place = of_case(from_case, &ContactCase::datum);

  const command_line::Stopwatch stopwatch;
  SolvedContact solved{material1, material2, naming(own(), [&] { return solve(problem); }),
                       name,      place,     hertz,
                       0,         notes,     {}};
  solved.seconds = stopwatch.seconds();
  solved.warnings = half_space_warnings(solved.half_width(), least_radius);
  const std::string coarse = contact::resolution_warning(solved.solution.nodes_across());
  if (!coarse.empty()) solved.warnings.push_back(coarse);
  return solved;
}

}  // namespace app
