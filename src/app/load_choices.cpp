// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/load_choices.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/csv_files.hpp"
#include "elasticity/piecewise_linear_load.hpp"
#include "system/require.hpp"

namespace app {
namespace {

using elasticity::KnownLoad;
using elasticity::LoadNumber;
using elasticity::LoadNumbers;
using elasticity::LoadShape;

std::string flag_of(const LoadNumber& number) {
  return "--" + number.name;
}

bool has(const LoadShape& shape, const LoadNumber& number) {
  return std::ranges::find(shape.numbers, number.name) != shape.numbers.end();
}

const LoadNumber& number_named(const std::string& name) {
  return *std::ranges::find(elasticity::load_numbers(), name, &LoadNumber::name);
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
  for (const LoadNumber& number : elasticity::load_numbers()) {
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

KnownLoad load_of_file(const ChoiceOption& given, const LoadNumbers& /*numbers*/) {
  const CsvColumns points = read_curve(given.argument(), "x", "pressure", 2);
  const elasticity::PiecewiseLinearLoad load(points.first, points.second);
  return {load, elasticity::closed_surface_of(load)};
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
  for (const LoadShape& shape : elasticity::load_shapes()) choices.push_back(choice_of(shape));
  choices.push_back({{"file", "PATH"}, "a sum of eq. (3) over unequal triangles", load_of_file});
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

const std::vector<LoadChoice>& load_choices() {
  static const std::vector<LoadChoice> choices = make_load_choices();
  return choices;
}

const std::vector<LoadChoice>& wide_load_choices() {
  static const std::vector<LoadChoice> choices = [] {
    std::vector<LoadChoice> wide;
    for (const LoadShape& shape : elasticity::load_shapes()) {
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
  for (const LoadNumber& number : elasticity::load_numbers()) {
    if (const auto own = given.given(flag_of(number))) from_case.*number.number = own;
  }
  return from_case;
}

}  // namespace app
