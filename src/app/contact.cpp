// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "command_line/stopwatch.hpp"
#include "contact/accuracy.hpp"
#include "line_contact/element.hpp"
#include "line_contact/methods.hpp"
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
  const line_contact::CylinderPair cylinders(materials.first, *radius1, materials.second, *radius2);
  return {cylinders.profile(), line_contact::Hertz(cylinders, load),
          1 / std::max(std::abs(radius1->curvature()), std::abs(radius2->curvature()))};
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

line_contact::Solution solution_of(const ContactFlags& flags, const std::string& method,
                                   const line_contact::Problem& problem, double load) {
  if (method == "variational") return line_contact::solve_by_variational_method(problem, load);
  if (method == "matrix-inversion") return line_contact::solve_by_matrix_inversion(problem, load);
  const auto tolerance = flags.tolerance.positive("1");
  return line_contact::solve_by_fft(problem, load,
                                    tolerance.value_or(line_contact::default_tolerance));
}

struct ContactOptions {
  CLI::App& command;
  ContactFlags contact{command};
  Output output{command, "[contact]"};
};

std::vector<Quantity> quantities_of(const SolvedContact& solved, const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  std::vector<Quantity> quantities = {
      {"half_width", "half-width", units.length, solved.half_width()},
      {"peak_pressure", "peak pressure", units.stress, s.peak_pressure()},
      {"load", "load", units.line_load, s.line_load()}};
  if (solved.datum) {
    quantities.push_back({"approach", "approach", units.length, s.approach(*solved.datum)});
  }
  if (!solved.hertz) return quantities;
  quantities[0].exact = solved.hertz->half_width();
  quantities[1].exact = solved.hertz->peak_pressure();
  if (solved.datum) quantities[3].exact = solved.hertz->approach(*solved.datum);
  return quantities;
}

Json details_of(const ContactFlags& flags, const SolvedContact& solved) {
  const line_contact::Solution& s = solved.solution;
  Json details = {{"profile", flags.profile.text_or("cylinder")},
                  {"element", line_contact::name_of(s.element)},
                  {"method", solved.method},
                  {"nodes", s.grid.n_nodes},
                  {"nodes_in_contact", s.n_in_contact()},
                  {"solves", s.work.revisions},
                  {"iterations", s.work.iterations},
                  {"products", s.work.products},
                  {"seconds", solved.seconds},
                  {"residuals",
                   {{"gap", std::max(s.residuals.gap, s.residuals.separation)},
                    {"pressure", s.residuals.pressure},
                    {"load", s.residuals.load}}},
                  {"contact_regions", Json::array()}};
  for (const line_contact::Region& region : s.regions()) {
    details["contact_regions"].push_back({{"begin", region.begin},
                                          {"end", region.end},
                                          {"load", region.load},
                                          {"nodes", region.n_nodes}});
  }
  return details;
}

// The CSV also has Hertz's pressure; in JSON its half-width and peak define it.
Table nodes_of(const SolvedContact& solved, bool is_csv) {
  const line_contact::Solution& s = solved.solution;
  const Eigen::VectorXd x = s.grid.nodes();
  Table table = {{.key = "x", .numbers = to_vector(x)},
                 {.key = "pressure", .numbers = to_vector(s.pressure)}};
  if (solved.hertz && is_csv) {
    const auto hertz = x.unaryExpr([&](double at) { return solved.hertz->pressure(at); });
    table.push_back({.key = "hertz_pressure", .numbers = to_vector(hertz)});
  }
  table.push_back({.key = "gap", .numbers = to_vector(s.gap)});
  return table;
}

void add_notes(std::vector<std::string>& notes, const SolvedContact& solved,
               const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  const auto regions = s.regions();
  if (regions.size() > 1) notes.push_back(fmt::format("{} regions in contact", regions.size()));
  if (solved.datum) {
    notes.push_back(
        fmt::format("approach of points at x = {} {}", rounded(*solved.datum), units.length));
  }
  notes.push_back(fmt::format("{} of {} nodes in contact, {:.4g} {} apart", s.n_in_contact(),
                              s.grid.n_nodes, s.grid.spacing, units.length));
  notes.push_back(fmt::format("{} elements, {}", line_contact::name_of(s.element), solved.method));
}

// The pressure at the nodes around the contact, with Hertz's if there is one.
Picture picture_of(const SolvedContact& solved, const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  const auto regions = s.regions();
  const double margin = 0.15 * (regions.back().end - regions.front().begin);
  const double begin = regions.front().begin - margin, end = regions.back().end + margin;
  Picture picture{
      fmt::format("x ({})", units.length), fmt::format("pressure ({})", units.stress), {}};
  if (solved.hertz) {
    picture.curves.push_back(
        line("Hertz", begin, end, [&](double x) { return solved.hertz->pressure(x); }));
  }
  picture.curves.push_back({"elements", !solved.hertz, {}, {}});
  // With about a hundred points, the line below them stays visible.
  const Eigen::Index step = solved.hertz ? 1 + s.n_in_contact() / 100 : 1;
  for (Eigen::Index i = 0; i < s.grid.n_nodes; i += step) {
    if (s.grid.x(i) < begin || s.grid.x(i) > end) continue;
    picture.curves.back().x.push_back(s.grid.x(i));
    picture.curves.back().y.push_back(s.pressure[i]);
  }
  return picture;
}

void run(const ContactOptions& options) {
  const Given given = options.output.given();
  const config::UnitSystem& units = given.units;
  const SolvedContact solved = options.contact.solve(given);
  constexpr int most_digits = 7;
  Result result{
      .quantities = quantities_of(solved, units),
      .digits = earned_digits(contact::relative_error(solved.solution.resolution()), most_digits),
      .is_hertz = solved.hertz.has_value(),
      .details = details_of(options.contact, solved),
      .table = nodes_of(solved, options.output.format() == "csv"),
      .units = {{"half_width", units.length},
                {"peak_pressure", units.stress},
                {"load", units.line_load},
                {"approach", units.length},
                {"x", units.length},
                {"pressure", units.stress},
                {"gap", units.length}},
      .notes = solved.notes,
      .warnings = solved.warnings};
  add_notes(result.notes, solved, units);
  options.output.print(result, [&] { return picture_of(solved, units); });
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
  if (chosen != "fft") refuse_given({&tolerance}, "--method " + chosen);
  const std::map<std::string, Element> elements = {{"triangular", Element::triangular},
                                                   {"uniform", Element::uniform},
                                                   {"point", Element::point}};
  const line_contact::Problem problem{
      bodies.profile, elasticity::contact_modulus(both.first, both.second),
      grid_of(*this, bodies, n_nodes, units), elements.at(element.text_or("triangular"))};
  auto place = datum.positive(units.length);
  if (!place) place = of_case(from_case, &ContactCase::datum);

  const command_line::Stopwatch stopwatch;
  SolvedContact solved{both.first,       solution_of(*this, chosen, problem, p),
                       chosen,           place,
                       bodies.hertz,     stopwatch.seconds(),
                       note_of(assumed), {}};
  solved.warnings = half_space_warnings(solved.half_width(), bodies.least_radius);
  const std::string coarse = contact::resolution_warning(solved.solution.resolution());
  if (!coarse.empty()) solved.warnings.push_back(coarse);
  return solved;
}

void add_contact_command(CLI::App& program) {
  add_command<ContactOptions>(
      program, "contact",
      "Hertz line contact: two cylinders, or a cylinder on a plane, pressed together along a line",
      R"(Pressure, half-width and gap by boundary elements are compared with Hertz's
closed form; the profile may also be measured.

Examples:
  A steel cylinder of radius 10 mm on a steel plane, 100 N/mm, plotted below:
    halfspace contact --radius1 10 --load 100 --plot -
  A steel shaft in a bronze bearing, in inches and pounds, with the approach:
    halfspace contact --units in-lbf --radius1 1 --radius2 -1.1 --load 2500 \
      --young1 30e6 --poisson1 0.3 --young2 16e6 --poisson2 0.34 --datum 1
  A measured profile on a million nodes, all pressures as CSV:
    halfspace contact --profile file:gap.csv --load 50N/mm --nodes 1e6 \
      --format csv)",
      run);
}

}  // namespace app
