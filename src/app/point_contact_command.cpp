// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/bodies.hpp"
#include "app/output.hpp"
#include "command_line/stopwatch.hpp"
#include "contact/accuracy.hpp"
#include "point_contact/hertz.hpp"
#include "point_contact/methods.hpp"
#include "point_contact/problem.hpp"
#include "point_contact/solution.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace app {
namespace {

using config::UnitSystem;
using parameters::ContactCase;
using point_contact::HertzElliptic;
using point_contact::Vector2;

// One radius describes a sphere, two an ellipsoid.
struct RadiusFlags {
  CLI::App& command;
  std::string number, help;
  Flag radius{command, "--radius" + number, "LENGTH", "Bodies", help};
  Flag along_x{command, "--radius" + number + "x", "LENGTH", "Bodies",
               "Principal radius along x, for an ellipsoid"};
  Flag along_y{command, "--radius" + number + "y", "LENGTH", "Bodies", "Principal radius along y"};

  bool has_two() const { return along_x.is_given() || along_y.is_given(); }
};

struct PointContactOptions {
  CLI::App& command;
  Flag load{command, "--load", "FORCE", "Load", "Load P, a force"};
  RadiusFlags radius1{command, "1",
                      "Radius of body 1, a sphere; 'plane' for a plane, negative for a hollow"};
  RadiusFlags radius2{command, "2", "Radius of body 2 [plane]"};
  PairOfMaterialFlags materials{command};
  Flag profile{
      command, "--profile", "sphere|heights:PATH", "Bodies",
      "Gap between the unloaded bodies: from their radii, or measured: a CSV grid of the heights "
      "of a surface, one line per y [sphere]"};
  Flag spacing{command, "--spacing", "LENGTH", "Bodies", "Distance between measured points"};
  Flag nodes{command, "--nodes", "COUNT", "Solution",
             "Number of nodes along the longer side of the domain [256]"};
  Flag domain{
      command, "--domain", "LENGTH", "Solution",
      "Width of the square that the nodes fill [a ninth wider than the contact, or the file's]"};
  Choice element{command,
                 "--element",
                 {"pyramid", "uniform"},
                 "Solution",
                 "Pressure around a node: a pyramid, or uniform on a square [pyramid]"};
  Choice method{command,
                "--method",
                {"fft", "variational"},
                "Solution",
                "Solution method; variational is a slower reference [fft]"};
  Flag tolerance{command, "--tolerance", "NUMBER", "Solution",
                 "Error of the pressure, relative to the peak [1e-8]"};
  Flag field{command, "--field", "FILE", "Input and output",
             "Write pressure and gap at the nodes as CSV, columns x,y,pressure,gap"};
  Output output{command, "[contact], for its bodies"};

  bool is_measured() const { return profile.text().starts_with("heights:"); }
};

// Two unloaded bodies, and the closed form of their contact if there is one.
struct Solids {
  point_contact::Profile profile;
  std::optional<HertzElliptic> hertz = {};
  double least_radius = 0;  // of the principal radii; 0 if the surface is measured
};

// The principal curvatures along x and y.
Vector2 curvatures_of(const RadiusFlags& flags,
                      const std::optional<line_contact::Radius>& otherwise,
                      const std::string& length) {
  if (!flags.has_two()) {
    auto radius = radius_of(flags.radius, length);
    if (!radius) radius = otherwise;
    if (!radius) throw sys::InputError(flags.radius.name() + " is missing");
    return Vector2::Constant(radius->curvature());
  }
  refuse_given({&flags.radius}, "a body with two principal radii");
  require_given({&flags.along_x, &flags.along_y});
  return {radius_of(flags.along_x, length)->curvature(),
          radius_of(flags.along_y, length)->curvature()};
}

Solids curved_bodies(const PointContactOptions& options,
                     const std::optional<ContactCase>& from_case, double modulus, double load,
                     const UnitSystem& units) {
  const auto radius_of_case = [&](parameters::CylinderCase ContactCase::*body) {
    return of_case(of_case(from_case, body), &parameters::CylinderCase::radius);
  };
  const Vector2 first =
      curvatures_of(options.radius1, radius_of_case(&ContactCase::body1), units.length);
  const Vector2 second = curvatures_of(
      options.radius2,
      radius_of_case(&ContactCase::body2).value_or(line_contact::Radius::of_plane()), units.length);
  const Vector2 sum = first + second;
  if (!(sum.minCoeff() > 0)) {
    throw sys::InputError(fmt::format(
        "1/radius1 + 1/radius2 = {} along x and {} along y: both must be greater than 0",
        rounded(sum.x()), rounded(sum.y())));
  }
  const double greatest = std::max(first.cwiseAbs().maxCoeff(), second.cwiseAbs().maxCoeff());
  return {point_contact::Profile::elliptic_paraboloid(sum.x(), sum.y()),
          HertzElliptic(modulus, sum.x(), sum.y(), load), 1 / greatest};
}

Solids bodies_of(const PointContactOptions& options, const std::optional<ContactCase>& from_case,
                 double modulus, double load, const UnitSystem& units) {
  const std::string given = options.profile.text_or("sphere");
  if (!options.is_measured()) {
    refuse_given({&options.spacing}, "--profile sphere");
    return curved_bodies(options, from_case, modulus, load, units);
  }
  for (const RadiusFlags* flags : {&options.radius1, &options.radius2}) {
    refuse_given({&flags->radius, &flags->along_x, &flags->along_y}, "--profile " + given);
  }
  const double spacing = read({{options.spacing, units.length}})[0];
  const Eigen::ArrayXXd heights = read_grid(given.substr(given.find(':') + 1));
  return {point_contact::Profile::height_map(heights.maxCoeff() - heights, spacing)};
}

point_contact::Grid grid_of(const PointContactOptions& options, const Solids& bodies,
                            const UnitSystem& units) {
  constexpr long usual = 256;
  const long n =
      options.nodes.count(point_contact::min_nodes, point_contact::max_nodes).value_or(usual);
  const auto width = options.domain.positive(units.length);
  if (!bodies.hertz) {
    const Vector2 sides = 2 * bodies.profile.half_sides();
    return width ? point_contact::square_grid(*width, n)
                 : point_contact::rectangular_grid(sides.x(), sides.y(), n);
  }
  const double a = bodies.hertz->semi_axis_x(), b = bodies.hertz->semi_axis_y();
  constexpr double room = 1 / 0.9;
  if (!width) return point_contact::rectangular_grid(2 * room * a, 2 * room * b, n);
  if (*width < 2 * std::max(a, b)) {
    options.domain.refuse(fmt::format("must be greater than {} {}, the width of Hertz's contact",
                                      rounded(2 * std::max(a, b)), units.length));
  }
  return point_contact::square_grid(*width, n);
}

std::vector<Quantity> quantities_of(const Solids& bodies, const point_contact::Solution& s,
                                    double load, const UnitSystem& units) {
  // From the pressure for curved bodies, from the area for measured ones.
  const Vector2 widths = bodies.hertz ? s.semi_axes() : s.area_semi_axes();
  std::vector<Quantity> quantities = {
      {"half_widths", "half-width, greatest", units.length, widths[0]},
      {"half_widths", "half-width, least", units.length, widths[1]},
      {"peak_pressure", "peak pressure", units.stress, s.peak_pressure()},
      {"approach", "approach", units.length, s.approach},
      {"load", "load", units.force, s.load()}};
  if (const auto& hertz = bodies.hertz) {
    quantities[0].exact = std::max(hertz->semi_axis_x(), hertz->semi_axis_y());
    quantities[1].exact = std::min(hertz->semi_axis_x(), hertz->semi_axis_y());
    quantities[2].exact = hertz->peak_pressure();
    quantities[3].exact = hertz->approach();
    quantities[4].exact = load;
  }
  return quantities;
}

Json details_of(const PointContactOptions& options, const point_contact::Solution& s,
                double seconds) {
  Json details = {{"contact_area", s.contact_area()},
                  {"profile", options.profile.text_or("sphere")},
                  {"element", point_contact::name_of(s.element)},
                  {"method", options.method.text_or("fft")},
                  {"nodes", s.grid.n1},
                  {"rows", s.grid.n2},
                  {"nodes_in_contact", s.n_in_contact()},
                  {"seconds", seconds},
                  {"work",
                   {{"products", s.work.products},
                    {"preconditionings", s.work.preconditionings},
                    {"iterations", s.work.iterations},
                    {"revisions", s.work.revisions}}},
                  {"residuals",
                   {{"gap", s.residuals.gap},
                    {"separation", s.residuals.separation},
                    {"pressure", s.residuals.pressure},
                    {"load", s.residuals.load}}},
                  {"contact_regions", Json::array()}};
  for (const point_contact::Region& region : point_contact::regions(s)) {
    details["contact_regions"].push_back({{"x", region.centre.x()},
                                          {"y", region.centre.y()},
                                          {"load", region.load},
                                          {"area", region.area},
                                          {"nodes", region.n_nodes}});
  }
  return details;
}

Table nodes_of(const point_contact::Solution& s) {
  Column x{.key = "x"}, y{.key = "y"};
  for (Eigen::Index j = 0; j < s.grid.n2; ++j) {
    for (Eigen::Index i = 0; i < s.grid.n1; ++i) {
      const Vector2 at = s.grid.node(i, j);
      x.numbers.push_back(at.x());
      y.numbers.push_back(at.y());
    }
  }
  return {x,
          y,
          {.key = "pressure", .numbers = to_vector(s.pressure)},
          {.key = "gap", .numbers = to_vector(s.gap)}};
}

void add_notes(std::vector<std::string>& notes, const PointContactOptions& options,
               const point_contact::Solution& s, const UnitSystem& units) {
  const auto regions = point_contact::regions(s);
  if (regions.size() > 1) notes.push_back(fmt::format("{} regions in contact", regions.size()));
  notes.push_back(fmt::format("{} of {} x {} nodes in contact, {:.4g} {} apart", s.n_in_contact(),
                              s.grid.n1, s.grid.n2, s.grid.spacing, units.length));
  notes.push_back(fmt::format("{} elements, {}", point_contact::name_of(s.element),
                              options.method.text_or("fft")));
}

// The pressure along the two axes, with Hertz's if there is one.
Picture picture_of(const Solids& bodies, const point_contact::Solution& s,
                   const UnitSystem& units) {
  Picture picture{
      fmt::format("x, y ({})", units.length), fmt::format("pressure ({})", units.stress), {}};
  for (const int axis : {0, 1}) {
    const std::string name = axis == 0 ? "along x" : "along y";
    Curve curve{name, !bodies.hertz, {}, {}};
    for (Eigen::Index k = 0; k < (axis == 0 ? s.grid.n1 : s.grid.n2); ++k) {
      const Eigen::Index i = axis == 0 ? k : s.grid.n1 / 2, j = axis == 0 ? s.grid.n2 / 2 : k;
      curve.x.push_back(s.grid.node(i, j)[axis]);
      curve.y.push_back(s.pressure[s.grid.index(i, j)]);
    }
    if (bodies.hertz) {
      picture.curves.push_back(
          line("Hertz, " + name, curve.x.front(), curve.x.back(),
               [&](double at) { return bodies.hertz->pressure(at * Vector2::Unit(axis)); }));
    }
    picture.curves.push_back(curve);
  }
  return picture;
}

void run(const PointContactOptions& options) {
  const Given given = options.output.given();
  const UnitSystem& units = given.units;
  std::optional<ContactCase> from_case;
  if (given.file) from_case = given.file->contact();
  Result result{.units = {{"half_widths", units.length},
                          {"peak_pressure", units.stress},
                          {"approach", units.length},
                          {"load", units.force},
                          {"contact_area", units.length + "^2"}}};
  if (!options.is_measured() && options.profile.text_or("sphere") != "sphere") {
    options.profile.refuse("must be sphere or heights:PATH");
  }
  if (!from_case && !options.is_measured() && !options.radius1.has_two()) {
    require_given({&options.radius1.radius, &options.load});
  }
  std::vector<std::string> assumed;
  const auto [material1, material2] = options.materials.read(from_case, units.stress, assumed);
  result.notes = note_of(assumed);
  const double modulus = elasticity::contact_modulus(material1, material2);
  const double load = read({{options.load, units.force}})[0];
  const Solids bodies = bodies_of(options, from_case, modulus, load, units);
  const point_contact::Problem problem{bodies.profile, modulus, grid_of(options, bodies, units),
                                       options.element.text() == "uniform"
                                           ? point_contact::Element::uniform
                                           : point_contact::Element::pyramid};
  const bool is_variational = options.method.text() == "variational";
  const double tolerance =
      options.tolerance.positive("1").value_or(point_contact::default_tolerance);

  const command_line::Stopwatch stopwatch;
  const point_contact::Solution s =
      is_variational ? point_contact::solve_by_variational_method(problem, load, tolerance)
                     : point_contact::solve_for_load(problem, load, tolerance);
  const double seconds = stopwatch.seconds();
  result.quantities = quantities_of(bodies, s, load, units);
  result.digits = earned_digits(contact::relative_error(s.resolution()), result.digits);
  result.is_hertz = bodies.hertz.has_value();
  result.details = details_of(options, s, seconds);
  result.warnings = half_space_warnings(result.quantities[0].value, bodies.least_radius);
  const std::string coarse = contact::resolution_warning(s.resolution());
  if (!coarse.empty()) result.warnings.push_back(coarse);
  add_notes(result.notes, options, s, units);
  if (options.field.is_given())
    sys::write_file_atomically(options.field.text(), csv_of(nodes_of(s)));
  if (options.output.format() == "csv") result.table = nodes_of(s);
  options.output.print(result, [&] { return picture_of(bodies, s, units); });
}

}  // namespace

void add_point_contact_command(CLI::App& program) {
  add_command<PointContactOptions>(
      program, "point-contact",
      "Hertz point contact: two spheres or ellipsoids pressed together at a point, or a rough "
      "surface",
      R"(Pressure and gap on a plane of nodes are compared with Hertz's closed form; a
surface may also be a measured height map.

Examples:
  A steel ball of radius 10 mm on a steel plane, 100 N:
    halfspace point-contact --radius1 10 --load 100
  A steel ball in an aluminium groove, plotted to a file:
    halfspace point-contact --radius1 8 --radius2x plane --radius2y=-9 \
      --young2 70GPa --poisson2 0.33 --load 50 --plot pressure.pdf
  A measured surface with points 5 um apart under a flat, pressures in a file:
    halfspace point-contact --profile heights:map.csv --spacing 5um --load 2 \
      --field pressure.csv)",
      run);
}

}  // namespace app
