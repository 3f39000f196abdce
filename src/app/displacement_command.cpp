// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bodies.hpp"
#include "app/output.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "system/error.hpp"

namespace app {
namespace {

using numerics::Estimate;
using HalfSpace = std::optional<parameters::HalfSpaceCase>;

struct DisplacementOptions {
  CLI::App& command;
  LoadFlags load{command, "--shape", Shapes::any};
  MaterialFlags material{command};
  Flag x{
      command, "--x", "LENGTH", "Points",
      "Points on the surface: a list 0,0.5,2 or a range BEGIN:END:STEP [21 points over twice the "
      "load's width, or the case's]"};
  Flag datum{command, "--datum", "LENGTH", "Points",
             "The x at which u_z = 0, arbitrary in plane strain [ten times the load's "
             "half-width, or the case's]"};
  Choice component{command,
                   "--component",
                   {"normal", "tangential"},
                   "Points",
                   "normal is u_z, into the body; tangential is u_x [normal]"};
  Output output{command, "[half_space]"};
};

std::vector<double> points_of(const DisplacementOptions& options, const HalfSpace& from_case,
                              const ChosenLoad& load, const config::UnitSystem& units) {
  if (options.x.is_given()) return options.x.quantities(units.length);
  if (from_case) return from_case->points;
  const auto& pieces = load.load.normal.pieces();
  if (pieces.empty()) throw sys::InputError("--x is missing");
  const double begin = pieces.front().begin;
  const double width = pieces.back().end - begin;
  constexpr int n = 20;
  return evenly_spaced(begin - width / 2, 2 * width / n, n + 1);
}

double datum_of(const DisplacementOptions& options, const HalfSpace& from_case,
                const ChosenLoad& load, const config::UnitSystem& units) {
  if (const auto datum = options.datum.positive(units.length)) return *datum;
  if (from_case) return from_case->datum;
  if (load.reach() == 0) throw sys::InputError("--datum, the x at which u_z = 0, is missing");
  return 10 * load.reach();
}

// A function at a point, by quadrature and in closed form, which is NaN if none is known.
struct Value {
  Estimate quadrature;
  double closed_form;
};

// The surface under a load: one component of its displacement and the gradient.
struct Surface {
  const Material& material;
  const ChosenLoad& load;
  double datum;
  bool is_tangential;
  elasticity::SurfaceQuadrature by_quadrature{material, load.load, datum};

  Value gradient(double x) const {
    if (is_tangential) {
      const double slope = elasticity::tangential_gradient(material, load.load, x);
      return {by_quadrature.tangential_gradient(x), slope};
    }
    if (const double jump = load.jump_at(x); jump != 0) return infinite(jump);
    return {by_quadrature.normal_gradient(x),
            closed_form([&](const auto& shape) { return normal_gradient(material, shape, x); })};
  }

  Value displacement(double x) const {
    if (const double jump = load.jump_at(x); std::isinf(jump)) return infinite(jump);
    const double closed = closed_form([&](const auto& shape) {
      if constexpr (requires { tangential_displacement(material, shape, x); }) {
        if (is_tangential) return tangential_displacement(material, shape, x);
      }
      return normal_displacement(material, shape, x, datum);
    });
    return {is_tangential ? by_quadrature.tangential_displacement(x)
                          : by_quadrature.normal_displacement(x),
            closed};
  }

 private:
  static Value infinite(double sign) {
    const double value = std::copysign(HUGE_VAL, sign);
    return {{value, 0}, value};
  }

  template <class OfShape>
  double closed_form(const OfShape& of_shape) const {
    return load.shape ? std::visit(of_shape, *load.shape) : std::nan("");
  }
};

// The function's values at all points.
struct Numbers {
  std::vector<double> quadrature, abs_error, closed_form;

  // Whether quadrature and closed form agree at a point within the error and four roundings.
  bool agree(std::size_t i) const {
    constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
    const double difference = std::abs(quadrature[i] - closed_form[i]);
    return std::isinf(quadrature[i]) ||
           difference <= abs_error[i] + roundings * std::abs(closed_form[i]);
  }
};

// The name of a function in CSV, in the table, and its unit.
struct Names {
  std::string key, symbol, unit;
};

// Computes the numbers and adds them to the table.
Numbers add_columns(Table& table, const Names& function, const Surface& surface,
                    Value (Surface::*value_at)(double) const, const std::vector<double>& points) {
  Numbers numbers;
  for (const double x : points) {
    const Value value = (surface.*value_at)(x);
    numbers.quadrature.push_back(value.quadrature.value);
    numbers.abs_error.push_back(value.quadrature.abs_error);
    numbers.closed_form.push_back(value.closed_form);
  }
  constexpr int most = 9, of_error = 2;
  const double largest = greatest(numbers.quadrature), error = greatest(numbers.abs_error);
  const int digits = earned_digits(error / largest, most);
  const auto add = [&](const char* name, const char* head, const std::vector<double>& column) {
    table.push_back(aligned_column(function.key + name, {function.symbol, head}, function.unit,
                                   column, largest, digits));
  };
  add("_quadrature", "quadrature", numbers.quadrature);
  table.push_back(aligned_column(function.key + "_abs_error", {"error", ""}, function.unit,
                                 numbers.abs_error, error, of_error));
  if (!surface.load.shape) return numbers;
  table.back().heads.clear();  // the text has the closed form instead
  add("_closed_form", "closed form", numbers.closed_form);
  return numbers;
}

void add_notes(std::vector<std::string>& notes, const ChosenLoad& load, const Numbers& gradient,
               const Numbers& displacement, const std::string& length) {
  notes.push_back(fmt::format("errors of the quadrature: at most {:.1e} and {:.1e} {}",
                              greatest(gradient.abs_error), greatest(displacement.abs_error),
                              length));
  notes.push_back(load.shape ? "closed form: " + load.source : "no closed form is known");
  if (!load.shape) return;
  const std::size_t n = gradient.closed_form.size();
  std::size_t n_agreeing = 0;
  for (std::size_t i = 0; i < n; ++i) n_agreeing += gradient.agree(i) && displacement.agree(i);
  notes.push_back(fmt::format("{} of {} points agree within their errors", n_agreeing, n));
}

void run(const DisplacementOptions& options) {
  const Given given = options.output.given();
  const config::UnitSystem& units = given.units;
  HalfSpace from_case;
  if (given.file) from_case = given.file->half_space();
  std::vector<std::string> assumed;
  const Material material =
      material_of({&options.material}, of_case(from_case, &parameters::HalfSpaceCase::material),
                  units.stress, assumed);
  const ChosenLoad load =
      options.load.read(of_case(from_case, &parameters::HalfSpaceCase::load), units);
  const bool is_tangential = options.component.text() == "tangential";
  if (is_tangential && !load.load.forces.empty()) {
    options.component.refuse("has no meaning for " + options.load.name());
  }
  const std::vector<double> points = points_of(options, from_case, load, units);
  const double datum = datum_of(options, from_case, load, units);

  const Surface surface{material, load, datum, is_tangential};
  const std::string symbol = is_tangential ? "u_x" : "u_z";
  Result result{.notes = note_of(assumed)};
  result.table.push_back(column_of_places("x", units.length, points));
  const Numbers gradients = add_columns(result.table, {"gradient", "d" + symbol + "/dx", "1"},
                                        surface, &Surface::gradient, points);
  const Numbers displacements = add_columns(result.table, {"displacement", symbol, units.length},
                                            surface, &Surface::displacement, points);
  result.units = {{"x", units.length}, {"gradient", "1"}, {"displacement", units.length}};
  if (!is_tangential) {
    result.notes.push_back(fmt::format("u_z = 0 at x = {} {}", rounded(datum), units.length));
  }
  add_notes(result.notes, load, gradients, displacements, units.length);
  options.output.print(result, [&] {
    const auto [low, high] = std::ranges::minmax(points);
    const auto value = [&](double x) {
      const Value at = surface.displacement(x);
      const double u = load.shape ? at.closed_form : at.quadrature.value;
      return std::isinf(u) ? std::nan("") : u;
    };
    return Picture{fmt::format("x ({})", units.length),
                   fmt::format("{} ({})", symbol, units.length),
                   {line(load.shape ? "closed form" : "quadrature", low, high, value),
                    {"quadrature at the points", false, points, displacements.quadrature}}};
  });
}

}  // namespace

void add_displacement_command(CLI::App& program) {
  add_command<DisplacementOptions>(
      program, "displacement",
      "Surface displacement of a half-space under a strip load, a triangular load or any other "
      "pressure",
      R"(The displacement and its gradient are computed by numerical quadrature (eq. 2
of Ruggiero 2001) and compared with their closed forms where these are known.
At the edge of a strip the displacement is finite and the gradient infinite.

Examples:
  A strip load of 100 MPa on |x| <= 1 mm of steel:
    halfspace displacement --shape uniform --peak-pressure 100 --half-width 1
  A triangular load on aluminium, at chosen points, plotted in the terminal:
    halfspace displacement --peak-pressure 63MPa --half-width 0.4mm \
      --young 70GPa --poisson 0.33 --x 0:2:0.1 --datum 50 --plot -
  A pressure given by a formula, with all digits as CSV:
    halfspace displacement --shape 'expression:p0*(1-(x/a)^4)' \
      --peak-pressure 100 --half-width 1 --format csv)",
      run);
}

}  // namespace app
