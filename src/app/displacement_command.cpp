// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/displacement_table.hpp"
#include "app/load_choices.hpp"
#include "command_line/stage.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/triangular_load.hpp"
#include "system/require.hpp"

namespace app {
namespace {

struct DisplacementOptions {
  explicit DisplacementOptions(CLI::App& command)
      : material(command, ""),
        datum(command, "--datum", "The x at which the displacement u_z is zero"),
        shape(command, "--shape", "triangular",
              "Shape of the load; file: a CSV file with the columns x,pressure, linear between; "
              "expression: pressure on |x| <= a as a formula of x, a, p0, as p0*(1-(x/a)^4)",
              choices_of(load_choices())) {
    add_text(command, "--x", x, "LIST", "Points on the surface, as a list 0,0.005,0.01");
    add_text(command, "--x-file", x_file, "FILE",
             "File of points, one a line; - reads standard input");
    add_text(command, "--case", case_file, "FILE", "Case file; flags override what it says");
    add_choice(command, "--component", component, {"normal", "tangential"},
               "normal: u_z; tangential: u_x");
    output.add_to(command);
  }

  MaterialOption material;
  NumberOption datum;
  ChoiceOption shape;
  std::string x, x_file, case_file;
  std::string component = "normal";
  Output output;
};

using OptionalCase = std::optional<parameters::Case>;

// The ends of all pieces, the points midway between them, and one outside each end.
std::vector<double> key_points_of(const elasticity::Load& load) {
  const auto& pieces = load.normal.pieces();
  if (pieces.empty()) return {};
  const double width = pieces.back().end - pieces.front().begin;
  std::vector<double> points{pieces.front().begin - width / 2, pieces.back().end + width / 2};
  for (const numerics::Piece& piece : pieces) {
    points.insert(points.end(), {piece.begin, (piece.begin + piece.end) / 2, piece.end});
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// The same load, whose pressure is counted each time that it is asked for.
elasticity::Load counted(elasticity::Load load, const std::shared_ptr<long>& n_evaluations) {
  std::vector<numerics::Piece> pieces = load.normal.pieces();
  for (numerics::Piece& piece : pieces) {
    piece.value = [value = piece.value, n_evaluations](double s) {
      ++*n_evaluations;
      return value(s);
    };
  }
  load.normal = numerics::PiecewiseFunction(pieces);
  *n_evaluations = 0;
  return load;
}

// The points given, or else the case's, or else those of the load itself: nothing is known where
// they lie in a file or under an expression.
std::vector<double> points_of(const DisplacementOptions& options, const OptionalCase& from_file,
                              const elasticity::Load& load) {
  refuse_if(!options.x.empty() && !options.x_file.empty(), "--x and --x-file: give one of them");
  if (!options.x.empty()) return parse_numbers("--x", options.x);
  if (!options.x_file.empty()) return read_numbers(options.x_file);
  if (from_file) return from_file->half_space.points;
  const bool is_users_own = !options.shape.argument().empty();
  if (is_users_own) return key_points_of(load);
  throw sys::InputError("no points: give --x, --x-file, or a --case that has them");
}

// A function of x on the surface, by quadrature and in closed form.
struct SurfaceFunction {
  std::function<numerics::Estimate(double)> quadrature;
  std::function<double(double)> closed_form;  // empty if there is none

  BothWays at(double x) const {
    return {quadrature(x), closed_form ? std::optional(closed_form(x)) : std::nullopt};
  }
};

// The displacement at the points, and between them in closed form, or else by quadrature.
literate::Figure displacement_figure(const SurfaceFunction& displacement, bool has_force,
                                     const std::vector<DisplacementRow>& rows,
                                     const std::string& component,
                                     const config::UnitSystem& units) {
  std::vector<double> x, u;
  for (const DisplacementRow& row : rows) {
    x.push_back(row.x);
    u.push_back(row.displacement.quadrature.value);
  }
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const auto value = [&](double at) {
    if (at == 0 && has_force) return literate::gap;  // infinite there
    return displacement.closed_form ? displacement.closed_form(at)
                                    : displacement.quadrature(at).value;
  };
  return {.width_cm = 14,
          .height_cm = 9,
          .data = {{"points", {{"x", x}, {"u", u}}},
                   {"curve", curve("x", "u", 401, *low, *high, value)}},
          .texts = {{"unit", units.length},
                    {"component", component},
                    {"line", displacement.closed_form ? "closed form" : "quadrature"}}};
}

ExitCode run(const DisplacementOptions& options) {
  const OptionalCase from_file = case_of(options.case_file);
  const config::UnitSystem units = options.output.units(from_file);
  options.shape.refuse_flags_of_others();
  const elasticity::Material material = options.material.or_else(
      from_file ? std::optional(from_file->half_space.material) : std::nullopt);
  std::optional<double> datum;
  if (from_file) datum = from_file->half_space.datum;
  const double zero_at = sys::require_positive("datum", options.datum.number_or(datum));
  const LoadChoice& choice = load_choices()[options.shape.row()];
  const KnownLoad known = choice.make(
      options.shape, numbers_of(options.shape, from_file ? numbers_of(from_file->half_space.load)
                                                         : LoadNumbers()));
  const bool has_force = !known.load.forces.empty();
  const bool is_tangential = options.component == "tangential";
  refuse_if(is_tangential && has_force,
            "--component tangential: not with --shape " + options.shape.text());
  const std::vector<double> points = points_of(options, from_file, known.load);

  const Stopwatch stopwatch;
  const auto n_evaluations = std::make_shared<long>(0);
  const elasticity::SurfaceQuadrature quadrature(material, counted(known.load, n_evaluations),
                                                 zero_at);
  const ClosedSurface closed =
      known.surface ? known.surface(material, zero_at) : ClosedSurface();
  SurfaceFunction gradient{[&](double x) { return quadrature.normal_gradient(x); },
                           closed.normal_gradient};
  SurfaceFunction displacement{[&](double x) { return quadrature.normal_displacement(x); },
                               closed.normal_displacement};
  if (is_tangential) {
    gradient = {[&](double x) { return quadrature.tangential_gradient(x); },
                closed.tangential_gradient};
    displacement = {[&](double x) { return quadrature.tangential_displacement(x); },
                    closed.tangential_displacement};
  }
  std::vector<DisplacementRow> rows;
  for (const double x : points) {
    *n_evaluations = 0;
    rows.push_back({.x = x,
                    .gradient = gradient.at(x),
                    .displacement = displacement.at(x),
                    .n_evaluations = *n_evaluations});
  }
  Result result = displacement_result(
      rows, units,
      {.closed_form =
           is_tangential ? "Johnson 2.24a, 2.25a with the load's own integral" : choice.source,
       .seconds = stopwatch.seconds()});
  if (!rows.empty()) {
    result.figure = [&] {
      return displacement_figure(displacement, has_force, rows, is_tangential ? "u_x" : "u_z",
                                 units);
    };
  }
  return options.output.print(result);
}

}  // namespace

void add_displacement_command(CLI::App& program, ExitCode& exit_code) {
  add_command<DisplacementOptions>(program, "displacement",
                                   "Surface gradient and displacement of a half-space: eq. (2) by "
                                   "quadrature, beside it eq. (3) or another closed form",
                                   exit_code, run);
}

}  // namespace app
