// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/compared_load.hpp"
#include "app/displacement_table.hpp"
#include "app/output_format.hpp"
#include "app/picture.hpp"
#include "command_line/options.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/triangular_load.hpp"
#include "parameters/case.hpp"
#include "system/require.hpp"

namespace app {
namespace {

struct DisplacementOptions {
  explicit DisplacementOptions(CLI::App& command)
      : young(command, "--young", "Young's modulus E"),
        poisson(command, "--poisson", "Poisson's ratio, between -1 and 0.5"),
        peak_pressure(command, "--peak-pressure", "p0 of the triangle, or the uniform pressure"),
        half_width(command, "--half-width", "a: the load acts on |x| <= a"),
        line_load(command, "--line-load", "P of a concentrated load"),
        datum(command, "--datum", "The x at which the displacement u_z is zero") {
    add_text(command, "--x", x, "LIST", "Points on the surface, as a list 0,0.005,0.01");
    add_text(command, "--x-file", x_file, "FILE",
             "File of points, one a line; - reads standard input");
    add_text(command, "--case", case_file, "FILE", "Case file; flags override what it says");
    add_text(command, "--shape", shape,
             "triangular|uniform|elliptic|parabolic|concentrated|file:PATH|expression:FORMULA",
             "Shape of the load; file: a CSV file with the columns x,pressure, linear between; "
             "expression: pressure on |x| <= a as a formula of x, a, p0, as p0*(1-(x/a)^4)");
    add_text(command, "--kinks", kinks, "LIST", "Expression: where it has kinks, besides x = 0");
    add_choice(command, "--component", component, {"normal", "tangential"},
               "normal: u_z; tangential: u_x");
    output.add_to(command);
    plot.add_to(command);
  }

  NumberOption young, poisson, peak_pressure, half_width, line_load, datum;
  std::string x, x_file, case_file, kinks;
  std::string shape = "triangular";
  std::string component = "normal";
  OutputOptions output;
  PlotOption plot;
};

using OptionalCase = std::optional<parameters::Case>;

// The points given, or else the case's, or else those of the load itself: nothing is known where
// they lie in a file or under an expression.
std::vector<double> points_of(const DisplacementOptions& options, const OptionalCase& from_file,
                              const ComparedLoad& compared) {
  if (!options.x.empty() && !options.x_file.empty()) {
    throw sys::InputError("--x and --x-file: give one of them");
  }
  if (!options.x.empty()) return parse_numbers("--x", options.x);
  if (!options.x_file.empty()) return read_numbers(options.x_file);
  if (from_file) return from_file->half_space.points;
  const bool is_users_own = options.shape.find(':') != std::string::npos;
  if (is_users_own) return compared.key_points;
  throw sys::InputError("no points: give --x, --x-file, or a --case that has them");
}

elasticity::Material material_of(const DisplacementOptions& options,
                                 const OptionalCase& from_file) {
  const auto from_case = [&](auto member) -> std::optional<double> {
    if (!from_file) return std::nullopt;
    return (from_file->half_space.material.*member)();
  };
  return {options.young.number_or(from_case(&elasticity::Material::young)),
          options.poisson.number_or(from_case(&elasticity::Material::poisson))};
}

// Refuse a flag that the shape of the load does not use: the user made a mistake.
void require_used(const DisplacementOptions& options) {
  const LoadFlags flags = flags_of(options.shape);
  const auto refuse_unless = [&](bool is_used, const std::string& flag, const std::string& text) {
    if (is_used || text.empty()) return;
    throw sys::InputError(flag + ": not used with --shape " + options.shape);
  };
  for (const auto& [is_used, option] : {std::pair{flags.line_load, &options.line_load},
                                        {flags.peak_pressure, &options.peak_pressure},
                                        {flags.half_width, &options.half_width}}) {
    refuse_unless(is_used, option->flag(), option->text());
  }
  refuse_unless(flags.kinks, "--kinks", options.kinks);
}

LoadChoice choice_of(const DisplacementOptions& options, const OptionalCase& from_file) {
  const auto number = [&](const NumberOption& option,
                          double (elasticity::TriangularLoad::*of_case)() const) {
    std::optional<double> given = option.number();
    if (!given && from_file) given = (from_file->half_space.load.*of_case)();
    return given;
  };
  using elasticity::TriangularLoad;
  return {.shape = options.shape,
          .peak_pressure = number(options.peak_pressure, &TriangularLoad::peak_pressure),
          .half_width = number(options.half_width, &TriangularLoad::half_width),
          .line_load = number(options.line_load, &TriangularLoad::line_load),
          .kinks = options.kinks.empty() ? std::vector<double>()
                                         : parse_numbers("--kinks", options.kinks)};
}

struct ComparedRows {
  std::vector<DisplacementRow> rows;
  DisplacementNotes notes;
  std::vector<std::pair<double, double>> curve;  // of the displacement, if it is to be drawn
};

// The displacement from the first to the last of the points: in closed form, or else by quadrature.
std::vector<std::pair<double, double>> curve_of(const ComparedLoad& compared,
                                                const elasticity::SurfaceQuadrature& surface,
                                                Component component,
                                                const std::vector<double>& points) {
  const bool is_normal = component == Component::normal;
  const auto& closed = is_normal ? compared.normal_displacement : compared.tangential_displacement;
  const auto [low, high] = std::minmax_element(points.begin(), points.end());
  std::vector<std::pair<double, double>> curve;
  constexpr int n = 400;
  for (int i = 0; i <= n; ++i) {
    const double x = *low + (*high - *low) * i / n;
    if (x == 0 && !compared.load.forces.empty()) continue;  // infinite there
    const double u = closed      ? closed(x)
                     : is_normal ? surface.normal_displacement(x).value
                                 : surface.tangential_displacement(x).value;
    curve.emplace_back(x, u);
  }
  return curve;
}

literate::Figure displacement_figure(const ComparedRows& result, const std::string& component,
                                     const config::UnitSystem& units) {
  std::vector<double> x, u, curve_x, curve_u;
  for (const DisplacementRow& row : result.rows) {
    x.push_back(row.x);
    u.push_back(row.displacement_quadrature.value);
  }
  for (const auto& [at, displacement] : result.curve) {
    curve_x.push_back(at);
    curve_u.push_back(displacement);
  }
  const bool has_closed_form = result.rows.front().displacement_closed_form.has_value();
  return {.width_cm = 14,
          .height_cm = 9,
          .data = {{"points", {{"x", x}, {"u", u}}}, {"curve", {{"x", curve_x}, {"u", curve_u}}}},
          .texts = {{"unit", units.length},
                    {"component", component == "normal" ? "u_z" : "u_x"},
                    {"line", has_closed_form ? "closed form" : "quadrature"}}};
}

ComparedRows rows_of(const DisplacementOptions& options, const OptionalCase& from_file) {
  const elasticity::Material material = material_of(options, from_file);
  std::optional<double> datum;
  if (from_file) datum = from_file->half_space.datum;
  const double zero_at = sys::require_positive("datum", options.datum.number_or(datum));
  const bool is_tangential = options.component == "tangential";
  if (is_tangential && options.shape == "concentrated") {
    throw sys::InputError("--component tangential: not with --shape concentrated");
  }
  const ComparedLoad compared = compared_load(choice_of(options, from_file), material, zero_at);
  const std::vector<double> points = points_of(options, from_file, compared);

  const auto begin = std::chrono::steady_clock::now();
  const elasticity::SurfaceQuadrature surface(material, compared.load, zero_at);
  ComparedRows result;
  const Component component = is_tangential ? Component::tangential : Component::normal;
  for (const double x : points) {
    result.rows.push_back(compare_at(compared, surface, component, x));
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  result.notes = {.closed_form = is_tangential ? "Johnson 2.24a, 2.25a with the load's own integral"
                                               : compared.normal_source,
                  .seconds = elapsed.count()};
  if (options.plot.is_given() && !points.empty()) {
    result.curve = curve_of(compared, surface, component, points);
  }
  return result;
}

ExitCode run(const DisplacementOptions& options) {
  OptionalCase from_file;
  if (!options.case_file.empty()) from_file = parameters::read_case(options.case_file);
  const config::UnitSystem units = options.output.units(from_file);
  require_used(options);
  options.plot.require_drawable(options.output);
  const ComparedRows result = rows_of(options, from_file);
  const std::vector<DisplacementRow>& rows = result.rows;
  switch (options.output.format()) {
    case OutputFormat::csv:
      fmt::print("{}", displacement_csv(rows));
      break;
    case OutputFormat::json:
      fmt::print("{}", displacement_json(rows));
      break;
    case OutputFormat::table:
      fmt::print("{}", displacement_text(rows, units, result.notes));
      break;
  }
  if (options.plot.is_given() && !rows.empty()) {
    options.plot.draw("displacement", displacement_figure(result, options.component, units));
  }
  return ExitCode::success;
}

}  // namespace

void add_displacement_command(CLI::App& program, ExitCode& exit_code) {
  add_command(
      program, "displacement",
      "Surface gradient and displacement of a half-space, eq. (2) by quadrature beside eq. (3)",
      exit_code, [](CLI::App& command) {
        auto options = std::make_shared<DisplacementOptions>(command);
        return [options] { return run(*options); };
      });
}

}  // namespace app
