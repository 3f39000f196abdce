// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/load_choices.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/csv_files.hpp"
#include "elasticity/concentrated_load.hpp"
#include "system/require.hpp"

namespace app {
namespace {

template <class Shape>
LoadShape peaked(std::string name, std::string source) {
  return {.name = std::move(name),
          .parameter = "",
          .numbers = {"peak-pressure", "half-width"},
          .source = std::move(source),
          .make = [](const LoadNumbers& given) -> KnownLoad {
            const Shape load(given.peak_pressure.value(), given.half_width.value());
            return {load, closed_surface_of(load)};
          }};
}

KnownLoad known_linear_fall(const LoadNumbers& given) {
  const elasticity::LinearFall load(given.peak_pressure.value(), given.parameter.value(),
                                    given.half_width.value());
  return {load, closed_surface_of(load)};
}

KnownLoad known_concentrated(const LoadNumbers& given) {
  const elasticity::ConcentratedLoad load(given.line_load.value());
  return {load, closed_surface_of(load)};
}

std::string flag_of(const LoadNumber& number) {
  return "--" + number.name;
}

bool has(const LoadShape& shape, const LoadNumber& number) {
  return std::ranges::find(shape.numbers, number.name) != shape.numbers.end();
}

const LoadNumber& number_named(const std::string& name) {
  return *std::ranges::find(load_numbers(), name, &LoadNumber::name);
}

double needed(const LoadNumbers& numbers, const LoadNumber& number) {
  if (const auto& given = numbers.*number.number) return *given;
  throw sys::InputError(flag_of(number) + " is missing: give it, or a --case that has it");
}

ChoiceFlag choice_flag(const LoadNumber& number) {
  return {flag_of(number), number.meaning};
}

LoadChoice choice_of(const LoadShape& shape) {
  LoadChoice choice{{shape.name, shape.parameter}, shape.source, nullptr};
  for (const LoadNumber& number : load_numbers()) {
    if (has(shape, number)) choice.flags.push_back(choice_flag(number));
  }
  choice.make = [&shape](const ChoiceOption& given, LoadNumbers numbers) {
    for (const std::string& name : shape.numbers) needed(numbers, number_named(name));
    if (!shape.parameter.empty()) {
      numbers.parameter = parse_number(shape.name + ":" + shape.parameter, given.argument());
    }
    return shape.make(numbers);
  };
  return choice;
}

// Linear between the points, by quadrature.
KnownLoad load_of_file(const ChoiceOption& given, const LoadNumbers& /*numbers*/) {
  const CsvColumns points = read_curve(given.argument(), "x", "pressure", 2);
  std::vector<numerics::Piece> pieces;
  for (std::size_t i = 0; i + 1 < points.first.size(); ++i) {
    const double x1 = points.first[i], x2 = points.first[i + 1];
    const double p1 = points.second[i], p2 = points.second[i + 1];
    pieces.push_back({x1, x2, [=](double x) { return std::lerp(p1, p2, (x - x1) / (x2 - x1)); }});
  }
  return {elasticity::Load{numerics::PiecewiseFunction(pieces), {}, {}}};
}

// Quadrature only: nothing is known of the formula but its values.
KnownLoad load_of_formula(const ChoiceOption& given, const LoadNumbers& numbers) {
  const double a = sys::require_positive("half-width", needed(numbers, number_named("half-width")));
  std::map<std::string, double> constants{{"a", a}};
  if (numbers.peak_pressure) constants["p0"] = *numbers.peak_pressure;
  const auto pressure = parse_expression("expression", given.argument(), constants);

  std::vector<double> breakpoints{-a, 0, a};
  const std::string& kinks = given.text_of("--kinks");
  for (const double kink :
       kinks.empty() ? std::vector<double>() : parse_numbers("--kinks", kinks)) {
    if (!(std::abs(kink) < a)) {
      throw sys::InputError(fmt::format("--kinks: {} does not lie under the load, |x| < {}",
                                        shortest(kink), shortest(a)));
    }
    breakpoints.push_back(kink);
  }
  std::sort(breakpoints.begin(), breakpoints.end());
  breakpoints.erase(std::unique(breakpoints.begin(), breakpoints.end()), breakpoints.end());
  return {elasticity::distributed_load(pressure, nullptr, breakpoints)};
}

std::vector<LoadChoice> make_load_choices() {
  std::vector<LoadChoice> choices;
  for (const LoadShape& shape : load_shapes()) choices.push_back(choice_of(shape));
  choices.push_back({{"file", "PATH"}, "", load_of_file});
  choices.push_back({{"expression",
                      "FORMULA",
                      {choice_flag(number_named("peak-pressure")),
                       choice_flag(number_named("half-width")),
                       {"--kinks", "Expression: where it has kinks, besides x = 0", "LIST"}}},
                     "",
                     load_of_formula});
  return choices;
}

}  // namespace

const std::vector<LoadNumber>& load_numbers() {
  static const std::vector<LoadNumber> numbers = {
      {"peak-pressure", "p0, the greatest pressure", &LoadNumbers::peak_pressure},
      {"half-width", "a: the load acts on |x| <= a", &LoadNumbers::half_width},
      {"line-load", "P of a concentrated load", &LoadNumbers::line_load}};
  return numbers;
}

const std::vector<LoadShape>& load_shapes() {
  const std::vector<std::string> peak_and_width = {"peak-pressure", "half-width"};
  static const std::vector<LoadShape> shapes = {
      peaked<elasticity::TriangularLoad>("triangular", "eq. (3) and its derivative"),
      peaked<elasticity::UniformLoad>("uniform", "Johnson, section 2.5"),
      {"linear", "EDGE_FRACTION", peak_and_width, "eq. (3) and Johnson, section 2.5",
       known_linear_fall},
      {"concentrated", "", {"line-load"}, "Flamant, Johnson 2.19", known_concentrated}};
  return shapes;
}

const std::vector<LoadChoice>& load_choices() {
  static const std::vector<LoadChoice> choices = make_load_choices();
  return choices;
}

const std::vector<LoadChoice>& wide_load_choices() {
  static const std::vector<LoadChoice> choices = [] {
    std::vector<LoadChoice> wide;
    for (const LoadShape& shape : load_shapes()) {
      if (!has(shape, number_named("half-width"))) continue;
      wide.push_back(choice_of(shape));
      wide.back().flags.clear();
    }
    return wide;
  }();
  return choices;
}

LoadNumbers numbers_of(const elasticity::TriangularLoad& load) {
  return {.peak_pressure = load.peak_pressure(),
          .half_width = load.half_width(),
          .line_load = load.line_load(),
          .parameter = {}};
}

LoadNumbers numbers_of(const ChoiceOption& given, LoadNumbers from_case) {
  for (const LoadNumber& number : load_numbers()) {
    if (const auto own = given.given(flag_of(number))) from_case.*number.number = own;
  }
  return from_case;
}

}  // namespace app
