// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/displacement_table.hpp"
#include "app/output_format.hpp"
#include "command_line/options.hpp"
#include "elasticity/concentrated_load.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/triangular_load.hpp"
#include "elasticity/uniform_load.hpp"
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
    add_choice(command, "--shape", shape, {"triangular", "uniform", "concentrated"},
               "Shape of the load");
    add_choice(command, "--component", component, {"normal", "tangential"},
               "normal: u_z; tangential: u_x, triangular load only");
    output.add_to(command);
  }

  NumberOption young, poisson, peak_pressure, half_width, line_load, datum;
  std::string x, x_file, case_file;
  std::string shape = "triangular";
  std::string component = "normal";
  OutputOptions output;
};

using OptionalCase = std::optional<parameters::Case>;

std::vector<double> points_of(const DisplacementOptions& options, const OptionalCase& from_file) {
  if (!options.x.empty() && !options.x_file.empty()) {
    throw sys::InputError("--x and --x-file: give one of them");
  }
  if (!options.x.empty()) return parse_numbers("--x", options.x);
  if (!options.x_file.empty()) return read_numbers(options.x_file);
  if (from_file) return from_file->half_space.points;
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

template <class Load>
DisplacementRow normal_row(const elasticity::Material& material, const Load& load, double datum,
                           const elasticity::SurfaceQuadrature& surface, double x) {
  return {x, surface.normal_gradient(x), normal_gradient(material, load, x),
          surface.normal_displacement(x), normal_displacement(material, load, x, datum)};
}

DisplacementRow tangential_row(const elasticity::Material& material,
                               const elasticity::TriangularLoad& load,
                               const elasticity::SurfaceQuadrature& surface, double x) {
  return {x, surface.tangential_gradient(x), tangential_gradient(material, load, x),
          surface.tangential_displacement(x), tangential_displacement(material, load, x)};
}

// Refuse a flag that the shape of the load does not use: the user made a mistake.
void require_used(const DisplacementOptions& options) {
  const bool is_concentrated = options.shape == "concentrated";
  const auto refuse = [&](const NumberOption& unused) {
    if (unused.text().empty()) return;
    throw sys::InputError(unused.flag() + ": not used with --shape " + options.shape);
  };
  if (!is_concentrated) return refuse(options.line_load);
  refuse(options.peak_pressure);
  refuse(options.half_width);
}

std::vector<DisplacementRow> rows_of(const DisplacementOptions& options,
                                     const OptionalCase& from_file) {
  const elasticity::Material material = material_of(options, from_file);
  const std::vector<double> points = points_of(options, from_file);
  std::optional<double> peak_pressure, half_width, line_load, datum;
  if (from_file) {
    peak_pressure = from_file->half_space.load.peak_pressure();
    half_width = from_file->half_space.load.half_width();
    line_load = from_file->half_space.load.line_load();
    datum = from_file->half_space.datum;
  }
  const double zero_at = sys::require_positive("datum", options.datum.number_or(datum));

  std::vector<DisplacementRow> rows;
  const auto fill = [&](const auto& load, auto&& row) {
    const elasticity::SurfaceQuadrature surface(material, load, zero_at);
    for (const double x : points) rows.push_back(row(load, surface, x));
  };
  const auto normal = [&](const auto& load, const auto& surface, double x) {
    return normal_row(material, load, zero_at, surface, x);
  };
  if (options.component == "tangential" && options.shape != "triangular") {
    throw sys::InputError("--component tangential: closed form for --shape triangular only");
  }
  if (options.shape == "concentrated") {
    fill(elasticity::ConcentratedLoad(options.line_load.number_or(line_load)), normal);
    return rows;
  }
  const double pressure = options.peak_pressure.number_or(peak_pressure);
  const double width = options.half_width.number_or(half_width);
  if (options.shape == "uniform") {
    fill(elasticity::UniformLoad(pressure, width), normal);
  } else if (options.component == "normal") {
    fill(elasticity::TriangularLoad(pressure, width), normal);
  } else {
    fill(elasticity::TriangularLoad(pressure, width),
         [&](const auto& load, const auto& surface, double x) {
           return tangential_row(material, load, surface, x);
         });
  }
  return rows;
}

ExitCode run(const DisplacementOptions& options) {
  OptionalCase from_file;
  if (!options.case_file.empty()) from_file = parameters::read_case(options.case_file);
  const config::UnitSystem units = options.output.units(from_file);
  require_used(options);
  const std::vector<DisplacementRow> rows = rows_of(options, from_file);
  switch (options.output.format()) {
    case OutputFormat::csv:
      fmt::print("{}", displacement_csv(rows));
      break;
    case OutputFormat::json:
      fmt::print("{}", displacement_json(rows));
      break;
    case OutputFormat::table:
      fmt::print("{}", displacement_text(rows, units));
      break;
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
