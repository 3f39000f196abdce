// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <udunits2.h>

#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <regex>
#include <string>
#include <string_view>
#include <utility>

#include "system/ascii.hpp"
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

/// UDUNITS reads units in memory that all threads share.
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

/// UDUNITS reads m² but not m⁻² or m⁴, and m^0.5 as five times m⁰, without a word.
std::string spelt_for_udunits(std::string name) {
  static const std::regex broken_power(R"((\^|\*\*)[+-]?\d+\.\d)");
  if (std::regex_search(name, broken_power)) {
    throw UnitError(fmt::format("unit \"{}\" has a power that is no whole number", name));
  }
  constexpr std::pair<const char*, const char*> raised[] = {
      {"⁻", "-"}, {"⁺", "+"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"},
      {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};
  for (const auto& [sign, digit] : raised) boost::replace_all(name, sign, digit);
  return name;
}

/// The unit in a text that UDUNITS-2 knows by a rounded or outdated number, as 3.785412 litres for
/// a gallon and the charge of the electron before 2019; empty if there is none.
std::string without_exact_factor(const std::string& text) {
  constexpr std::string_view names =
      " "
      "electronvolt electron_volt eV keV MeV GeV TeV unified_atomic_mass_unit "
      "atomic_mass_unit atomicmassunit amu u astronomical_unit_BIPM_2006 ua light_year parsec "
      "chain printers_point acre_foot board_foot circular_mil darcy assay_ton "
      "avoirdupois_ounce troy_ounce apothecary_ounce troy_pound apothecary_pound pennyweight "
      "long_hundredweight short_hundredweight slug denier perm_0C perm_23C bushel bu "
      "register_ton US_dry_gallon US_dry_quart US_dry_pint dry_quart dry_pint "
      "US_liquid_gallon liquid_gallon gallon barrel bbl firkin US_liquid_quart liquid_quart "
      "quart US_liquid_pint liquid_pint pint pt US_liquid_cup liquid_cup cup US_liquid_gill "
      "liquid_gill gill US_fluid_ounce US_liquid_ounce fluid_ounce liquid_ounce oz floz "
      "tablespoon Tbl Tbsp tbsp Tblsp teaspoon tsp poundal force_ounce ounce_force ozf torr "
      "footcandle footlambert boiler_horsepower shaft_horsepower horsepower hp "
      "metric_horsepower water_horsepower UK_horsepower gilbert oersted Oe unit_pole e "
      "faraday chemical_faraday physical_faraday C12_faraday statampere statcoulomb statfarad "
      "stathenry statmho statohm statvolt ";
  static const std::regex word("[A-Za-z_][A-Za-z_]*([0-9]+C)?");
  for (std::sregex_iterator found(text.begin(), text.end(), word), end; found != end; ++found) {
    const auto at = static_cast<std::size_t>(found->position());
    if (at > 0 && sys::is_digit(text[at - 1])) continue;  // the exponent of 1e-3
    const std::string name = found->str();
    const std::string_view singular =
        std::string_view(name).substr(0, name.size() - (name.ends_with('s') ? 1 : 0));
    for (const std::string_view one : {std::string_view(name), singular}) {
      if (names.find(fmt::format(" {} ", one)) != std::string_view::npos) return name;
    }
  }
  return "";
}

void require_known_factor(const std::string& from, const std::string& to) {
  const std::string in_from = without_exact_factor(from), in_to = without_exact_factor(to);
  if (in_from.empty() == in_to.empty()) return;
  throw UnitError(fmt::format(
      "\"{}\" cannot be converted into \"{}\": UDUNITS-2 knows \"{}\" by a rounded or outdated "
      "number, so give the result itself",
      from, to, in_from.empty() ? in_to : in_from));
}

Unit parse(const std::string& name) {
  Unit unit(ut_parse(database(), spelt_for_udunits(name).c_str(), UT_UTF8));
  if (!unit) throw UnitError(fmt::format("unknown unit \"{}\"", name));
  return unit;
}

// UDUNITS converts by way of SI units, so that one inch becomes 0.99999999999999989 inches. If a
// factor differs from a number of twelve digits by no more than such rounding, that number is
// meant.
double without_rounding(double factor) {
  const double short_factor = *sys::parsed<double>(fmt::format("{:.12g}", factor));
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * factor;
  return std::abs(short_factor - factor) <= rounding ? short_factor : factor;
}

/// digits · 10^exponent. A product of two doubles' digits, 34 at most, fits in.
struct Decimal {
  __extension__ using Digits = unsigned __int128;
  Digits digits = 0;
  int exponent = 0;
};

/// The shortest decimal number that reads back as `number` ≥ 0.
Decimal shortest(double number) {
  const sys::Decimal written = sys::parse_decimal(fmt::format("{}", number)).value();
  Decimal decimal{0, written.place};
  for (const char digit : written.digits) {
    decimal.digits = 10 * decimal.digits + static_cast<unsigned>(digit - '0');
  }
  return decimal;
}

bool is_short(const Decimal& factor) {
  constexpr Decimal::Digits first_of_16_digits = 1'000'000'000'000'000;
  return factor.digits < first_of_16_digits;
}

double nearest(const Decimal& decimal) {
  std::string text;
  for (Decimal::Digits rest = decimal.digits; rest > 0; rest /= 10) {
    text.insert(text.begin(), static_cast<char>('0' + static_cast<int>(rest % 10)));
  }
  return sys::number_of({.digits = text.empty() ? "0" : text, .place = decimal.exponent});
}

Decimal product(const Decimal& a, const Decimal& b) {
  return {a.digits * b.digits, a.exponent + b.exponent};
}

/// A number in another unit, which its digits may only begin.
struct Conversion {
  Decimal number;
  bool is_exact = false;
};

/// The quotient to 19 digits or more; a last digit 1 stands for all that follow, so that it is
/// rounded to the right side.
Conversion quotient(Decimal a, const Decimal& b) {
  constexpr Decimal::Digits most = ~Decimal::Digits{0} / 10;
  for (; a.digits > 0 && a.digits <= most; a.digits *= 10) --a.exponent;
  const Decimal::Digits digits = a.digits / b.digits;
  const bool is_exact = a.digits % b.digits == 0;
  return {{is_exact ? digits : digits / 10 * 10 + 1, a.exponent - b.exponent}, is_exact};
}

/// A factor or its reciprocal that is short by definition has fewer digits than the other, which
/// may end by chance: a km/h is 1/1.609344 mi/h, and not 0.621371192237334.
Conversion conversion(double number, const std::string& from, const std::string& to) {
  const Decimal factor = shortest(conversion_factor(from, to));
  const Decimal reciprocal = shortest(conversion_factor(to, from));
  const Decimal given = shortest(std::abs(number));
  if (reciprocal.digits < factor.digits && is_short(reciprocal)) return quotient(given, reciprocal);
  return {product(given, factor), is_short(factor)};
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
  return Unit(ut_parse(database(), spelt_for_udunits(name).c_str(), UT_UTF8)) != nullptr;
}

double conversion_factor(const std::string& from, const std::string& to) {
  if (from == to) return 1;
  require_known_factor(from, to);
  const std::lock_guard lock(udunits);
  const Unit from_unit = parse(from);
  const Unit to_unit = parse(to);
  if (!ut_are_convertible(from_unit.get(), to_unit.get())) {
    throw UnitError(fmt::format("\"{}\" cannot be converted into \"{}\"", from, to));
  }
  const Converter converter(ut_get_converter(from_unit.get(), to_unit.get()));
  const double factor = cv_convert_double(converter.get(), 1);
  // An offset ("in from 3", "degC") or a logarithm ("lg(re 1 mm)") cannot be a factor.
  const bool is_factor = cv_convert_double(converter.get(), 0) == 0 &&
                         std::abs(cv_convert_double(converter.get(), 2) - 2 * factor) <=
                             4 * std::numeric_limits<double>::epsilon() * std::abs(factor);
  if (cv_convert_double(converter.get(), 2) == factor / 2) {
    throw UnitError(fmt::format(
        "\"{}\" is the reciprocal of \"{}\", and only a factor converts units", from, to));
  }
  if (!is_factor) {
    throw UnitError(fmt::format(
        "\"{}\" and \"{}\" count from different zeros, and only a factor converts units: give the "
        "number in \"{}\"",
        from, to, to));
  }
  if (!(factor > 0 && std::isfinite(factor))) {
    throw UnitError(fmt::format("\"{}\" is {} times \"{}\": the factor must be positive and finite",
                                from, factor, to));
  }
  return without_rounding(factor);
}

double converted(double number, const std::string& from, const std::string& to) {
  return std::copysign(nearest(conversion(number, from, to).number), number);
}

bool converts_exactly(double number, const std::string& from, const std::string& to) {
  const auto without_zeros = [](Decimal decimal) {
    for (; decimal.digits > 0 && decimal.digits % 10 == 0; decimal.digits /= 10) ++decimal.exponent;
    return decimal;
  };
  const auto [in_unit, is_exact] = conversion(number, from, to);
  const Decimal printed = without_zeros(shortest(nearest(in_unit)));
  const Decimal meant = without_zeros(in_unit);
  return is_exact && printed.digits == meant.digits &&
         (meant.digits == 0 || printed.exponent == meant.exponent);
}

}  // namespace config
