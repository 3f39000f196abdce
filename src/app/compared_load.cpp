// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compared_load.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/csv_columns.hpp"
#include "app/expression.hpp"
#include "command_line/number_text.hpp"
#include "elasticity/concentrated_load.hpp"
#include "elasticity/elliptic_load.hpp"
#include "elasticity/parabolic_load.hpp"
#include "elasticity/piecewise_linear_load.hpp"
#include "elasticity/triangular_load.hpp"
#include "elasticity/uniform_load.hpp"
#include "system/require.hpp"

namespace app {
namespace {

constexpr std::string_view load_file_prefix = "file:";
constexpr std::string_view expression_prefix = "expression:";

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

template <class Closed>
ComparedLoad with_closed_forms(const Closed& load, const elasticity::Material& material,
                               double datum, std::string source) {
  ComparedLoad compared;
  compared.n_evaluations = std::make_shared<long>(0);
  compared.load = counted(load, compared.n_evaluations);
  compared.normal_gradient = [=](double x) { return normal_gradient(material, load, x); };
  compared.normal_displacement = [=](double x) {
    return normal_displacement(material, load, x, datum);
  };
  if constexpr (requires { tangential_displacement(material, load, 0.0); }) {
    compared.tangential_gradient = [=](double x) { return tangential_gradient(material, load, x); };
    compared.tangential_displacement = [=](double x) {
      return tangential_displacement(material, load, x);
    };
  }
  compared.normal_source = std::move(source);
  compared.key_points = key_points_of(compared.load);
  return compared;
}

double given(const std::optional<double>& number, const char* flag) {
  if (number) return *number;
  throw sys::InputError(std::string(flag) + " is missing: give it, or a --case that has it");
}

elasticity::PiecewiseLinearLoad read_load(const std::string& file) {
  const CsvColumns points = read_columns(file, "x", "pressure");
  const std::vector<double>& x = points.first;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[i - 1]) continue;
    throw sys::InputError(fmt::format("{}:{}: x = {}: must be greater than the one before, {}",
                                      file, points.lines[i], command_line::shortest(x[i]),
                                      command_line::shortest(x[i - 1])));
  }
  if (x.size() < 2) {
    throw sys::InputError(fmt::format("{}: holds {} points, 2 or more are needed", file, x.size()));
  }
  return {x, points.second};
}

// Quadrature only: nothing is known of the formula but its values.
ComparedLoad expression_load(const LoadChoice& choice, const std::string& formula) {
  const double a = sys::require_positive("half-width", given(choice.half_width, "--half-width"));
  std::map<std::string, double> constants{{"a", a}};
  if (choice.peak_pressure) constants["p0"] = *choice.peak_pressure;
  const auto pressure = parse_expression("--shape expression", formula, constants);

  std::vector<double> breakpoints{-a, 0, a};
  for (const double kink : choice.kinks) {
    if (!(std::abs(kink) < a)) {
      throw sys::InputError(fmt::format("--kinks: {} does not lie under the load, |x| < {}",
                                        command_line::shortest(kink), command_line::shortest(a)));
    }
    breakpoints.push_back(kink);
  }
  std::sort(breakpoints.begin(), breakpoints.end());
  breakpoints.erase(std::unique(breakpoints.begin(), breakpoints.end()), breakpoints.end());

  ComparedLoad compared;
  compared.n_evaluations = std::make_shared<long>(0);
  compared.load =
      counted(elasticity::distributed_load(pressure, nullptr, breakpoints), compared.n_evaluations);
  compared.key_points = key_points_of(compared.load);
  return compared;
}

bool is_expression(const std::string& shape) {
  return shape.starts_with(expression_prefix);
}

bool is_load_file(const std::string& shape) {
  return shape.starts_with(load_file_prefix);
}

}  // namespace

LoadFlags flags_of(const std::string& shape) {
  const bool is_concentrated = shape == "concentrated";
  const bool has_width = !is_concentrated && !is_load_file(shape);
  return {.peak_pressure = has_width,
          .half_width = has_width,
          .line_load = is_concentrated,
          .kinks = is_expression(shape)};
}

ComparedLoad compared_load(const LoadChoice& choice, const elasticity::Material& material,
                           double datum) {
  const auto peak = [&] { return given(choice.peak_pressure, "--peak-pressure"); };
  const auto width = [&] { return given(choice.half_width, "--half-width"); };
  const std::string& shape = choice.shape;
  if (shape == "triangular") {
    return with_closed_forms(elasticity::TriangularLoad(peak(), width()), material, datum,
                             "eq. (3) and its derivative");
  }
  if (shape == "uniform") {
    return with_closed_forms(elasticity::UniformLoad(peak(), width()), material, datum,
                             "Johnson, section 2.5");
  }
  if (shape == "elliptic") {
    return with_closed_forms(elasticity::EllipticLoad(peak(), width()), material, datum,
                             "Hertz, Johnson 4.47, 4.48");
  }
  if (shape == "parabolic") {
    return with_closed_forms(elasticity::ParabolicLoad(peak(), width()), material, datum,
                             "the integral of eq. (2) in logarithms");
  }
  if (shape == "concentrated") {
    return with_closed_forms(elasticity::ConcentratedLoad(given(choice.line_load, "--line-load")),
                             material, datum, "Flamant, Johnson 2.19");
  }
  if (is_load_file(shape)) {
    return with_closed_forms(read_load(shape.substr(load_file_prefix.size())), material, datum,
                             "a sum of eq. (3) over unequal triangles");
  }
  if (is_expression(shape)) {
    return expression_load(choice, shape.substr(expression_prefix.size()));
  }
  throw sys::InputError(
      fmt::format("--shape: \"{}\" must be triangular, uniform, elliptic, parabolic, concentrated, "
                  "file:PATH or expression:FORMULA",
                  shape));
}

DisplacementRow compare_at(const ComparedLoad& compared,
                           const elasticity::SurfaceQuadrature& surface, Component component,
                           double x) {
  const auto closed = [x](const std::function<double(double)>& form) -> std::optional<double> {
    if (!form) return std::nullopt;
    return form(x);
  };
  *compared.n_evaluations = 0;
  DisplacementRow row{.x = x};
  if (component == Component::normal) {
    row.gradient_quadrature = surface.normal_gradient(x);
    row.displacement_quadrature = surface.normal_displacement(x);
    row.gradient_closed_form = closed(compared.normal_gradient);
    row.displacement_closed_form = closed(compared.normal_displacement);
  } else {
    row.gradient_quadrature = surface.tangential_gradient(x);
    row.displacement_quadrature = surface.tangential_displacement(x);
    row.gradient_closed_form = closed(compared.tangential_gradient);
    row.displacement_closed_form = closed(compared.tangential_displacement);
  }
  row.n_evaluations = *compared.n_evaluations;
  return row;
}

}  // namespace app
