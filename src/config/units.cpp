// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <udunits2.h>

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "system/decimal.hpp"

namespace config {
namespace {

struct Deleter {
  void operator()(ut_system* system) const { ut_free_system(system); }
  void operator()(ut_unit* unit) const { ut_free(unit); }
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using System = std::unique_ptr<ut_system, Deleter>;
using Unit = std::unique_ptr<ut_unit, Deleter>;
using Converter = std::unique_ptr<cv_converter, Deleter>;

/// UDUNITS-2 is not thread-safe.
std::mutex udunits;

ut_system* database() {
  static const System system = [] {
    ut_set_error_message_handler(ut_ignore);
    System read(ut_read_xml(nullptr));
    if (!read) throw UnitError("the UDUNITS-2 database of units cannot be read: run `make setup`");
    return read;
  }();
  return system.get();
}

Unit parse(const std::string& name) {
  return Unit(ut_parse(database(), name.c_str(), UT_UTF8));
}

Unit known(const std::string& name) {
  Unit unit = parse(name);
  if (!unit) throw UnitError(fmt::format("unknown unit \"{}\"", name));
  return unit;
}

Converter converter(const std::string& from, const std::string& to) {
  const Unit from_unit = known(from), to_unit = known(to);
  if (ut_are_convertible(from_unit.get(), to_unit.get()) == 0) {
    throw UnitError(fmt::format("\"{}\" cannot be converted into \"{}\"", from, to));
  }
  Converter converter(ut_get_converter(from_unit.get(), to_unit.get()));
  const auto times = [&converter](double n) { return cv_convert_double(converter.get(), n); };
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const bool is_factor =
      times(0) == 0 && times(1) > 0 && std::abs(times(2) - 2 * times(1)) <= rounding * times(1);
  if (!is_factor) {
    throw UnitError(
        fmt::format("\"{}\" is not a multiple of \"{}\": give the number in \"{}\"", from, to, to));
  }
  return converter;
}

/// Removes the rounding noise of binary arithmetic. Infinity and NaN stay unchanged.
double to_15_digits(double number) {
  return sys::parsed<double>(fmt::format("{:.15g}", number)).value_or(number);
}

}  // namespace

const std::string& UnitSystem::unit(Dimension dimension) const {
  static const std::string one = "1";
  switch (dimension) {
    case Dimension::length:
      return length;
    case Dimension::force:
      return force;
    case Dimension::stress:
      return stress;
    case Dimension::line_load:
      return line_load;
    case Dimension::density:
      return density;
    case Dimension::none:
      break;
  }
  return one;
}

const std::vector<UnitSystem>& unit_systems() {
  static const std::vector<UnitSystem> systems = {
      {"in-lbf", "in", "lbf", "psi", "lbf/in", "lbf.s^2/in^4"},
      {"mm-N", "mm", "N", "MPa", "N/mm", "N.s^2/mm^4"},
      {"m-N", "m", "N", "Pa", "N/m", "kg/m^3"},
  };
  return systems;
}

const UnitSystem& unit_system(std::string_view name) {
  std::vector<std::string> names;
  for (const UnitSystem& system : unit_systems()) {
    if (system.name == name) return system;
    names.push_back(system.name);
  }
  throw UnitError(
      fmt::format("unknown unit system \"{}\": must be one of {}", name, fmt::join(names, ", ")));
}

bool is_unit(const std::string& name) {
  const std::lock_guard lock(udunits);
  return parse(name) != nullptr;
}

double converted(double number, const std::string& from, const std::string& to) {
  if (from == to) return number;
  const std::lock_guard lock(udunits);
  return to_15_digits(cv_convert_double(converter(from, to).get(), number));
}

}  // namespace config
