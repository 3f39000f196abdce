// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bodies.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "config/units.hpp"
#include "system/error.hpp"

namespace app {
namespace {

// The name of each shape, with a parameter behind a colon, and its help.
const std::vector<std::pair<std::string, std::string>>& all_shapes() {
  static const std::vector<std::pair<std::string, std::string>> all = {
      {"triangular", "triangular"},
      {"uniform", "uniform, a strip load"},
      {"linear:FRACTION",
       "linear:FRACTION, falling from the peak in the middle to this fraction of it at the edges"},
      {"file:PATH", "file:PATH, a CSV file with the columns x,pressure, linear between its points"},
      {"expression:FORMULA",
       "expression:FORMULA of x, a and p0, such as 'expression:p0*(1-(x/a)^4)'"},
      {"concentrated", "concentrated, a force at x = 0"}};
  return all;
}

std::string help_of(Shapes shapes) {
  std::string help = "Pressure on |x| <= a";
  for (std::size_t i = 0; i < shapes; ++i) help += (i == 0 ? ": " : "; ") + all_shapes()[i].second;
  return help + (shapes == Shapes::of_finite_width ? "" : " [triangular]");
}

ChosenLoad load_of_file(const std::string& file) {
  CurvePoints points = read_curve(file, "x,pressure", 2);
  std::vector<numerics::Piece> pieces;
  for (std::size_t i = 0; i + 1 < points.x.size(); ++i) {
    const double begin = points.x[i], end = points.x[i + 1];
    const double p = points.y[i], q = points.y[i + 1];
    // This form is exact at both ends, so neighbours agree there.
    pieces.push_back({begin, end, [=](double s) {
                        return p * ((end - s) / (end - begin)) + q * ((s - begin) / (end - begin));
                      }});
  }
  return {.load = {numerics::PiecewiseFunction(pieces)},
          .x = std::move(points.x),
          .pressure = std::move(points.y)};
}

// The parser keeps the address of x, so the two must stay together.
struct Formula {
  mu::Parser parser;
  double x = 0;
};

// Parses a function of x such as p0*(1-(x/a)^4): muParser's operators and functions (sin, sqrt,
// abs, exp, ln, min, …), pi, and these constants. The function throws sys::InputError naming x
// where the formula has no finite value.
//
// Throws sys::InputError with muParser's message for an error in the formula. The decimal sign is a
// point in every locale.
std::function<double(double)> parse_expression(const std::string& formula,
                                               const std::map<std::string, double>& constants) {
  const auto parsed = std::make_shared<Formula>();
  try {
    parsed->parser.DefineVar("x", &parsed->x);
    parsed->parser.DefineConst("pi", std::numbers::pi);
    for (const auto& [name, value] : constants) parsed->parser.DefineConst(name, value);
    parsed->parser.SetExpr(formula);
    parsed->parser.Eval();  // compiles it
  } catch (const mu::ParserError& error) {
    throw sys::InputError(fmt::format("expression \"{}\": {}", formula, error.GetMsg()));
  }
  if (parsed->parser.GetNumResults() != 1) {
    throw sys::InputError(fmt::format("expression \"{}\": {} formulas, but one is needed", formula,
                                      parsed->parser.GetNumResults()));
  }
  return [formula, parsed](double x) {
    parsed->x = x;
    const double value = parsed->parser.Eval();
    if (std::isfinite(value)) return value;
    throw sys::InputError(
        fmt::format("expression \"{}\" has no finite value at x = {:.6g}", formula, x));
  };
}

ChosenLoad load_of_formula(const std::string& formula, double a, std::optional<double> p0) {
  std::map<std::string, double> constants{{"a", a}};
  if (p0) constants["p0"] = *p0;
  if (!p0 && formula.find("p0") != std::string::npos) {
    throw sys::InputError("--peak-pressure, p0 in the formula, is missing");
  }
  const auto pressure = parse_expression(formula, constants);
  ChosenLoad chosen{.load = elasticity::distributed_load(pressure, {-a, 0, a})};
  constexpr int n = 1000;
  for (int i = -n; i <= n; ++i) {
    chosen.x.push_back(a * i / n);
    chosen.pressure.push_back(pressure(chosen.x.back()));
  }
  return chosen;
}

}  // namespace

Material material_of(const std::vector<const MaterialFlags*>& flags,
                     const std::optional<Material>& from_case, const std::string& unit,
                     std::vector<std::string>& assumed) {
  std::optional<double> e, nu;
  for (const MaterialFlags* of : flags) {
    if (!e) e = of->young.positive(unit);
    if (nu) continue;
    nu = of->poisson.quantity("1");
    if (nu && !(*nu > -1 && *nu < 0.5)) {
      of->poisson.refuse("must be between -1 and 0.5, both excluded");
    }
  }
  if (!e && from_case) e = from_case->young();
  if (!nu && from_case) nu = from_case->poisson();
  const std::string& number = flags.front()->number;
  if (!e) {
    e = config::converted(210, "GPa", unit);
    assumed.push_back(fmt::format("E{} = {} {}", number, rounded(*e), unit));
  }
  if (!nu) {
    nu = 0.3;
    assumed.push_back(fmt::format("nu{} = {}", number, *nu));
  }
  return {*e, *nu};
}

std::pair<Material, Material> PairOfMaterialFlags::read(
    const std::optional<parameters::ContactCase>& from_case, const std::string& unit,
    std::vector<std::string>& assumed) const {
  const auto of_body = [&](parameters::CylinderCase parameters::ContactCase::*body) {
    return of_case(of_case(from_case, body), &parameters::CylinderCase::material);
  };
  const Material first =
      material_of({&body1, &both}, of_body(&parameters::ContactCase::body1), unit, assumed);
  return {first,
          material_of({&body2, &both}, of_body(&parameters::ContactCase::body2), unit, assumed)};
}

std::vector<std::string> note_of(const std::vector<std::string>& assumed) {
  if (assumed.empty()) return {};
  return {fmt::format("assumed: {}", fmt::join(assumed, ", "))};
}

std::optional<line_contact::Radius> radius_of(const Flag& flag, const std::string& unit) {
  if (flag.text() == "plane") return line_contact::Radius::of_plane();
  const auto length = flag.quantity(unit);
  if (!length) return std::nullopt;
  if (*length == 0) flag.refuse("must not be 0; write 'plane' for a plane");
  return line_contact::Radius::of_cylinder("radius", *length);
}

std::vector<std::string> half_space_warnings(double half_width, double least_radius) {
  constexpr double small = 0.1;
  if (!(least_radius > 0 && half_width > small * least_radius)) return {};
  return {fmt::format(
      "the contact's half-width is {:.2g} of the least radius; half-spaces represent the bodies "
      "well below {}",
      half_width / least_radius, small)};
}

double ChosenLoad::reach() const {
  const auto& pieces = load.normal.pieces();
  if (pieces.empty()) return 0;
  return std::max(std::abs(pieces.front().begin), std::abs(pieces.back().end));
}

double ChosenLoad::jump_at(double at) const {
  for (const elasticity::LineForce& force : load.forces) {
    if (force.position == at) return std::numeric_limits<double>::infinity();
  }
  double left = 0, right = 0;
  for (const numerics::Piece& piece : load.normal.pieces()) {
    if (piece.end == at) left = piece.value(at);
    if (piece.begin == at) right = piece.value(at);
  }
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * load.normal.scale();
  return std::abs(right - left) > rounding ? right - left : 0;
}

LoadFlags::LoadFlags(CLI::App& command, const std::string& names, Shapes which)
    : shapes(which),
      shape(command, names, "SHAPE", "Load", help_of(which)),
      peak_pressure(command, "--peak-pressure", "STRESS", "Load", "Greatest pressure p0"),
      half_width(command, "--half-width", "LENGTH", "Load", "Half-width a of the load") {
  if (which != Shapes::any) return;
  line_load.emplace(command, "--line-load", "FORCE/LENGTH", "Load",
                    "Concentrated: the force per length of its line");
}

ChosenLoad LoadFlags::read(const std::optional<elasticity::TriangularLoad>& from_case,
                           const config::UnitSystem& units) const {
  const std::string given = shape.text_or("triangular");
  const std::string kind = given.substr(0, given.find(':') + (given.find(':') < given.size()));
  const std::string argument = given.substr(kind.size());
  bool is_known = false;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < shapes; ++i) {
    names.push_back(all_shapes()[i].first);
    is_known |= kind.ends_with(':') ? names[i].starts_with(kind) : names[i] == kind;
  }
  if (!is_known) shape.refuse(fmt::format("must be one of {}", fmt::join(names, ", ")));
  if (kind == "file:" || kind == "concentrated")
    refuse_given({&peak_pressure, &half_width}, name());
  if (line_load && kind != "concentrated") refuse_given({&*line_load}, name());

  const auto from = [&](double (elasticity::TriangularLoad::*member)() const) {
    return from_case ? std::optional(((*from_case).*member)()) : std::nullopt;
  };
  const auto p0_of_case = from(&elasticity::TriangularLoad::peak_pressure);
  const auto a_of_case = from(&elasticity::TriangularLoad::half_width);
  if (kind == "file:") return load_of_file(argument);
  if (kind == "concentrated") {
    const Needed force{*line_load, units.line_load, from(&elasticity::TriangularLoad::line_load)};
    const elasticity::ConcentratedLoad load(app::read({force})[0]);
    return {load, load, "Johnson, section 2.2"};
  }
  if (kind == "expression:") {
    const auto p0 = peak_pressure.positive(units.stress);
    return load_of_formula(argument, app::read({{half_width, units.length, a_of_case}})[0],
                           p0 ? p0 : p0_of_case);
  }
  const auto numbers =
      app::read({{peak_pressure, units.stress, p0_of_case}, {half_width, units.length, a_of_case}});
  const double p0 = numbers[0], a = numbers[1];
  if (kind == "uniform") {
    const elasticity::UniformLoad load(p0, a);
    return {load, load, "Johnson, section 2.5", {-a, a}, {p0, p0}};
  }
  if (kind == "linear:") {
    const double fraction = parse_number(name(), argument);
    if (!(fraction >= 0)) shape.refuse("the fraction must be 0 or greater");
    const elasticity::LinearFall load(p0, fraction, a);
    const double edge = fraction * p0;
    return {load, load, "eq. (3) and Johnson, section 2.5", {-a, 0, a}, {edge, p0, edge}};
  }
  const elasticity::TriangularLoad load(p0, a);
  return {load, load, "eq. (3)", {-a, 0, a}, {0, p0, 0}};
}

}  // namespace app
