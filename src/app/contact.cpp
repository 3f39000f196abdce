// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/csv_files.hpp"
#include "command_line/stopwatch.hpp"
#include "contact/limits.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"
#include "system/error.hpp"

namespace app {
namespace {

using config::UnitSystem;
using line_contact::Element;
using line_contact::Radius;
using parameters::ContactCase;

// Two unloaded bodies, and the closed form of their contact if there is one.
struct Bodies {
  line_contact::Profile profile;
  std::optional<line_contact::Hertz> hertz = {};
  double least_radius = 0;  // 0 if the profile is measured
};

Bodies cylinders_of(const ContactFlags& flags, const std::optional<ContactCase>& from_case,
                    const std::pair<Material, Material>& materials, double load,
                    const UnitSystem& units) {
  auto radius1 = radius_of(flags.radius1, units.length);
  auto radius2 = radius_of(flags.radius2, units.length);
  if (!radius1) radius1 = from_case->body1.radius;
  if (!radius2) radius2 = from_case ? from_case->body2.radius : Radius::of_plane();
  const double curvature1 = radius1->curvature(), curvature2 = radius2->curvature();
  if (!(curvature1 + curvature2 > 0)) {
    throw sys::InputError(
        fmt::format("1/radius1 + 1/radius2 = {}: must be greater than 0: at most one plane, and a "
                    "hollow only if "
                    "wider than the cylinder in it",
                    rounded(curvature1 + curvature2)));
  }
  const line_contact::CylinderPair cylinders(materials.first, *radius1, materials.second, *radius2);
  return {cylinders.profile(), line_contact::Hertz(cylinders, load),
          1 / std::max(std::abs(curvature1), std::abs(curvature2))};
}

Bodies bodies_of(const ContactFlags& flags, const std::optional<ContactCase>& from_case,
                 const std::pair<Material, Material>& materials, double load,
                 const UnitSystem& units) {
  const std::string given = flags.profile.text_or("cylinder");
  if (given == "cylinder") return cylinders_of(flags, from_case, materials, load, units);
  refuse_given({&flags.radius1, &flags.radius2}, "--profile " + given);
  const CurvePoints points = read_curve(given.substr(given.find(':') + 1), "x,gap", 4);
  return {line_contact::Profile::tabulated(points.x, points.y)};
}

line_contact::Grid grid_of(const ContactFlags& flags, const Bodies& bodies, long n_nodes,
                           const UnitSystem& units) {
  const auto width = flags.domain.positive(units.length);
  if (!bodies.hertz) {
    const double begin = bodies.profile.begin(), end = bodies.profile.end();
    return line_contact::grid_of_width(width.value_or(end - begin), n_nodes, (begin + end) / 2);
  }
  const double half_width = bodies.hertz->half_width();
  if (!width) return line_contact::grid_around(half_width, n_nodes);
  if (*width < 2 * half_width) {
    flags.domain.refuse(fmt::format("must be greater than {} {}, the width of Hertz's contact",
                                    rounded(2 * half_width), units.length));
  }
  return line_contact::grid_of_width(*width, n_nodes);
}

line_contact::Solution solution_of(const std::string& method, const line_contact::Problem& problem,
                                   double load) {
  if (method == "variational") return line_contact::solve_by_variational_method(problem, load);
  if (method == "matrix-inversion") return line_contact::solve_by_matrix_inversion(problem, load);
  return line_contact::solve_by_fft(problem, load);
}

}  // namespace

double SolvedContact::half_width() const {
  if (hertz) return solution.half_width();
  const auto regions = solution.regions();
  return regions.empty() ? 0 : (regions.back().end - regions.front().begin) / 2;
}

SolvedContact ContactFlags::solve(const Given& given) const {
  const UnitSystem& units = given.units;
  std::optional<ContactCase> from_case;
  if (given.file) from_case = given.file->contact();
  const bool is_measured = profile.text().starts_with("file:");
  if (!is_measured && profile.text_or("cylinder") != "cylinder") {
    profile.refuse("must be cylinder or file:PATH");
  }
  if (!from_case && !is_measured) require_given({&radius1, &load});
  const double p = read({{load, units.line_load, of_case(from_case, &ContactCase::line_load)}})[0];
  std::vector<std::string> assumed;
  const auto both = materials.read(from_case, units.stress, assumed);
  const Bodies bodies = bodies_of(*this, from_case, both, p, units);

  constexpr long usual_nodes = 401, quickly_inverted = 1000;
  const long n_nodes = nodes.count(line_contact::min_nodes, line_contact::max_nodes)
                           .value_or(from_case ? from_case->n_nodes : usual_nodes);
  const std::string usual = n_nodes <= quickly_inverted ? "matrix-inversion" : "fft";
  const std::string chosen = method.text_or(usual);
  const std::map<std::string, Element> elements = {{"triangular", Element::triangular},
                                                   {"uniform", Element::uniform},
                                                   {"point", Element::point}};
  const line_contact::Problem problem{
      bodies.profile, elasticity::contact_modulus(both.first, both.second),
      grid_of(*this, bodies, n_nodes, units), elements.at(element.text_or("triangular"))};
  auto place = datum.positive(units.length);
  if (!place) place = of_case(from_case, &ContactCase::datum);

  const command_line::Stopwatch stopwatch;
  SolvedContact solved{both.first,       solution_of(chosen, problem, p),
                       chosen,           place,
                       bodies.hertz,     stopwatch.seconds(),
                       note_of(assumed), {}};
  solved.warnings = half_space_warnings(solved.half_width(), bodies.least_radius);
  const std::string coarse = contact::resolution_warning(solved.solution.resolution());
  if (!coarse.empty()) solved.warnings.push_back(coarse);
  return solved;
}

}  // namespace app
