// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/loads.hpp"
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
             "The x at which u_z = 0, which plane strain leaves open [ten times the load's "
             "half-width, or the case's]"};
  Flag component{command, "--component", "normal|tangential", "Points",
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

// A function of x by quadrature, in closed form if one is known, and where it is infinite.
struct Function {
  std::string key, symbol, unit;
  std::function<Estimate(double)> quadrature;
  std::function<double(double)> closed_form;
  std::function<double(double)> infinite = [](double) { return 0; };  // ±infinity, or 0 for finite
};

// Its numbers at all points.
struct Numbers {
  std::vector<double> quadrature, abs_error, closed_form;
};

Numbers numbers_of(const Function& function, const std::vector<double>& points) {
  Numbers numbers;
  for (const double x : points) {
    const double infinite = function.infinite(x);
    const bool is_finite = infinite == 0;
    const Estimate estimate = is_finite ? function.quadrature(x) : Estimate{infinite, 0};
    if (is_finite)
      require_finite(fmt::format("{}_quadrature at x = {}", function.key, x), estimate.value);
    numbers.quadrature.push_back(estimate.value + 0.0);
    numbers.abs_error.push_back(estimate.abs_error);
    if (!function.closed_form) continue;
    numbers.closed_form.push_back((is_finite ? function.closed_form(x) : infinite) + 0.0);
  }
  return numbers;
}

// Whether quadrature and closed form agree within the error and four roundings.
bool agrees(const Numbers& numbers, std::size_t i) {
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  const double closed = numbers.closed_form[i];
  return numbers.quadrature[i] == closed || std::abs(numbers.quadrature[i] - closed) <=
                                                numbers.abs_error[i] + roundings * std::abs(closed);
}

void add_columns(Table& table, const Function& function, const Numbers& numbers) {
  constexpr int most = 9, of_error = 2;
  const double largest = greatest(numbers.quadrature), error = greatest(numbers.abs_error);
  const int digits = earned_digits(error / largest, most);
  const auto add = [&](const char* name, const char* head, const std::vector<double>& column) {
    table.push_back(aligned_column(function.key + name, {function.symbol, head}, function.unit,
                                   column, largest, digits));
    table.back().may_be_infinite = true;
  };
  add("_quadrature", "quadrature", numbers.quadrature);
  table.push_back(aligned_column(function.key + "_abs_error", {"error", ""}, function.unit,
                                 numbers.abs_error, error, of_error));
  if (!function.closed_form) return;
  table.back().heads.clear();  // people read the closed form in its place
  add("_closed_form", "closed form", numbers.closed_form);
}

void add_notes(Result& result, const ChosenLoad& load, const Numbers& gradient,
               const Numbers& displacement, const std::string& length) {
  result.notes.push_back(fmt::format("errors of the quadrature: at most {:.1e} and {:.1e} {}",
                                     greatest(gradient.abs_error), greatest(displacement.abs_error),
                                     length));
  if (gradient.closed_form.empty()) {
    result.notes.emplace_back("no closed form is known");
    return;
  }
  const std::size_t n = gradient.closed_form.size();
  std::size_t n_agreeing = 0;
  for (std::size_t i = 0; i < n; ++i) n_agreeing += agrees(gradient, i) && agrees(displacement, i);
  result.notes.push_back("closed form: " + load.source);
  result.notes.push_back(fmt::format("{} of {} points agree within their errors", n_agreeing, n));
}

ExitCode run(const DisplacementOptions& options) {
  const Given given = options.output.given();
  const config::UnitSystem& units = given.units;
  HalfSpace from_case;
  if (given.file) from_case = given.file->half_space();
  Result result{.table_in_json = InJson::rows};
  const Material material =
      read_material(options.material, of_case(from_case, &parameters::HalfSpaceCase::material),
                    units.stress, result.notes);
  const ChosenLoad load =
      options.load.read(of_case(from_case, &parameters::HalfSpaceCase::load), units);
  const bool is_tangential =
      options.component.choice_or(false, {{"normal", false}, {"tangential", true}});
  if (is_tangential && !load.load.forces.empty()) {
    options.component.refuse("has no meaning for " + options.load.name());
  }
  const std::vector<double> points = points_of(options, from_case, load, units);
  const double datum = datum_of(options, from_case, load, units);

  const elasticity::SurfaceQuadrature quadrature(material, load.load, datum);
  const ClosedForms closed = load.closed_forms ? load.closed_forms(material, datum) : ClosedForms();
  const auto infinite_gradient = [&](double x) {
    const double jump = load.jump_at(x);
    return jump == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), jump);
  };
  const auto infinite_displacement = [&](double x) {
    return std::isinf(load.jump_at(x)) ? load.jump_at(x) : 0;
  };
  Function gradient{"gradient",
                    "du_z/dx",
                    "1",
                    [&](double x) { return quadrature.normal_gradient(x); },
                    closed.normal_gradient,
                    infinite_gradient};
  Function displacement{"displacement",
                        "u_z",
                        units.length,
                        [&](double x) { return quadrature.normal_displacement(x); },
                        closed.normal_displacement,
                        infinite_displacement};
  if (is_tangential) {
    gradient = {"gradient", "du_x/dx", "1",
                [&](double x) { return quadrature.tangential_gradient(x); },
                closed.tangential_gradient};
    displacement = {"displacement", "u_x", units.length,
                    [&](double x) { return quadrature.tangential_displacement(x); },
                    closed.tangential_displacement};
  }
  const Numbers gradients = numbers_of(gradient, points);
  const Numbers displacements = numbers_of(displacement, points);
  result.table.push_back(column_of_places("x", units.length, points));
  add_columns(result.table, gradient, gradients);
  add_columns(result.table, displacement, displacements);
  result.units = {{"x", units.length}, {"gradient", "1"}, {"displacement", units.length}};
  if (!is_tangential) {
    result.notes.push_back(fmt::format("u_z = 0 at x = {} {}", rounded(datum), units.length));
  }
  add_notes(result, load, gradients, displacements, units.length);
  return options.output.print(result, [&] {
    const auto [low, high] = std::ranges::minmax(points);
    const auto curve = [&](double x) {
      if (displacement.infinite(x) != 0) return std::nan("");
      return closed.normal_gradient ? displacement.closed_form(x)
                                    : displacement.quadrature(x).value;
    };
    return Picture{fmt::format("x ({})", units.length),
                   fmt::format("{} ({})", displacement.symbol, units.length),
                   {line(closed.normal_gradient ? "closed form" : "quadrature", low, high, curve),
                    {"quadrature at the points", false, points, displacements.quadrature}}};
  });
}

}  // namespace

void add_displacement_command(CLI::App& program, ExitCode& exit_code) {
  add_command<DisplacementOptions>(
      program,
      {"displacement",
       "Surface displacement u_z of a half-space under a strip load, a triangular load or any "
       "other "
       "pressure, and its gradient. Both come by numerical quadrature (eq. 2 of Ruggiero 2001), "
       "beside their closed forms where these are known. At the edge of a strip the displacement "
       "is "
       "finite and the gradient infinite.",
       {{"A strip load of 100 MPa on |x| <= 1 mm of steel:",
         "halfspace displacement --shape uniform --peak-pressure 100 --half-width 1"},
        {"A triangular load on aluminium, at points of your own, drawn in the terminal:",
         "halfspace displacement --peak-pressure 63MPa --half-width 0.4mm \\\n"
         "      --young 70GPa --poisson 0.33 --x 0:2:0.1 --datum 50 --plot -"},
        {"Your own pressure as a formula, with all digits as CSV:",
         "halfspace displacement --shape 'expression:p0*(1-(x/a)^4)' \\\n"
         "      --peak-pressure 100 --half-width 1 --format csv"}}},
      exit_code, run);
}

}  // namespace app
