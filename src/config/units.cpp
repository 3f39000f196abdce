// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <udunits2.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

Unit parse(const std::string& name) {
  Unit unit(ut_parse(database(), spelt_for_udunits(name).c_str(), UT_UTF8));
  if (!unit) throw UnitError(fmt::format("unknown unit \"{}\"", name));
  return unit;
}

/// A unit as a multiple of powers of its system's base units. Here the radian is one of them,
/// although UDUNITS-2 converts it into 1.
struct Product {
  double scale = 1;
  std::map<std::string, int> powers = {};

  int power(const std::string& unit) const {
    const auto found = powers.find(unit);
    return found == powers.end() ? 0 : found->second;
  }
};

std::string symbol_of(const ut_unit* unit) {
  const char* const symbol = ut_get_symbol(unit, UT_UTF8);
  return symbol == nullptr ? "" : symbol;
}

Product product_of(const ut_unit* unit) {
  static const ut_visitor visitor = {
      .visit_basic =
          [](const ut_unit* basic, void* product) {
            ++static_cast<Product*>(product)->powers[symbol_of(basic)];
            return UT_SUCCESS;
          },
      .visit_product =
          [](const ut_unit*, int count, const ut_unit* const* basic, const int* powers,
             void* product) {
            for (int i = 0; i < count; ++i) {
              static_cast<Product*>(product)->powers[symbol_of(basic[i])] += powers[i];
            }
            return UT_SUCCESS;
          },
      .visit_galilean =
          [](const ut_unit*, double scale, const ut_unit* of, double, void* product) {
            static_cast<Product*>(product)->scale *= scale;
            return ut_accept_visitor(of, &visitor, product);
          },
      .visit_timestamp = [](const ut_unit*, const ut_unit* time, double,
                            void* product) { return ut_accept_visitor(time, &visitor, product); },
      .visit_logarithmic =
          [](const ut_unit*, double, const ut_unit* reference, void* product) {
            return ut_accept_visitor(reference, &visitor, product);
          }};
  Product product;
  ut_accept_visitor(unit, &visitor, &product);
  return product;
}

/// Whether a name is that of a unit but for a prefix and the plural: MeV and slugs, but not us,
/// which ends as the plural of u does.
bool is_multiple_by_prefix(const std::string& name, const std::string& unit) {
  if (name == unit) return true;
  if (!name.ends_with(unit) && !name.ends_with(unit + "s")) return false;
  const Unit parsed(ut_parse(database(), name.c_str(), UT_UTF8));
  if (!parsed) return false;
  const Product one = product_of(parsed.get()), other = product_of(parse(unit).get());
  const double power = std::log10(one.scale / other.scale);
  return one.powers == other.powers && std::abs(power - std::round(power)) < 1e-9;
}

/// The unit in a text that UDUNITS-2 knows by a rounded or outdated number, as 3.785412 litres for
/// a gallon and the charge of the electron before 2019; empty if there is none.
std::string without_exact_factor(const std::string& text) {
  static const std::vector<std::string> names = [] {
    std::istringstream all(
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
        "stathenry statmho statohm statvolt ");
    return std::vector<std::string>(std::istream_iterator<std::string>(all), {});
  }();
  static const std::regex word("[A-Za-z_][A-Za-z_]*([0-9]+C)?");
  for (std::sregex_iterator found(text.begin(), text.end(), word), end; found != end; ++found) {
    const auto at = static_cast<std::size_t>(found->position());
    if (at > 0 && sys::is_digit(text[at - 1])) continue;  // the exponent of 1e-3
    const std::string name = found->str();
    const auto is_it = [&](const std::string& unit) { return is_multiple_by_prefix(name, unit); };
    if (std::ranges::any_of(names, is_it)) return name;
  }
  return "";
}

/// The name in a text that stands for several units, of which UDUNITS-2 takes one without a word:
/// the calorie of steam tables, the short ton, the tropical year, a nanomile, lengths by the survey
/// foot.
std::string of_several_units(const std::string& text) {
  static const std::regex name(
      "(^|[^A-Za-z_])([kM]?cal|(kilo|mega)?calories?|years?|months?|nmi|k?tons?|acres?|rods?|"
      "fathoms?|furlongs?)(?![A-Za-z_])");
  std::smatch found;
  return std::regex_search(text, found, name) ? found.str(2) : "";
}

void require_known_factor(const std::string& from, const std::string& to) {
  const auto in_one = [&](auto name_in) {
    const std::string in_from = name_in(from), in_to = name_in(to);
    if (in_from.empty() == in_to.empty()) return std::string();
    return in_from.empty() ? in_to : in_from;
  };
  const auto refuse = [&](const std::string& reason) {
    throw UnitError(fmt::format("\"{}\" cannot be converted into \"{}\": {}", from, to, reason));
  };
  if (const std::string name = in_one(without_exact_factor); !name.empty()) {
    refuse(fmt::format(
        "UDUNITS-2 knows \"{}\" by a rounded or outdated number, so give the result itself", name));
  }
  if (const std::string name = in_one(of_several_units); !name.empty()) {
    refuse(
        fmt::format("\"{}\" means several units, so name one, as Julian_year, IT_calorie or "
                    "nautical_mile do, or give the result itself",
                    name));
  }
}

void require_same_angles(const std::string& from, const std::string& to) {
  const auto angles = [](const std::string& unit) {
    return product_of(parse(unit).get()).power("rad");
  };
  if (angles(from) == angles(to)) return;
  throw UnitError(fmt::format(
      "\"{}\" cannot be converted into \"{}\": an angle is not converted into a number without one",
      from, to));
}

// UDUNITS converts by way of SI units, so that one inch becomes 0.99999999999999989 inches. If a
// factor differs from a number of twelve digits by no more than such rounding, that number is
// meant.
double without_rounding(double factor) {
  const double short_factor = *sys::parsed<double>(fmt::format("{:.12g}", factor));
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * factor;
  return std::abs(short_factor - factor) <= rounding ? short_factor : factor;
}

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

Rational power(const Rational& number, int exponent) {
  const auto n = static_cast<unsigned>(std::abs(exponent));
  const Integer above = boost::multiprecision::pow(numerator(number), n);
  const Integer below = boost::multiprecision::pow(denominator(number), n);
  return exponent < 0 ? Rational(below, above) : Rational(above, below);
}

Rational rational(const sys::Decimal& decimal) {
  return Integer(decimal.digits) * power(10, decimal.place);
}

/// The shortest decimal number that reads back as `number`, without zeros at its end.
sys::Decimal shortest(double number) {
  sys::Decimal decimal = sys::parse_decimal(fmt::format("{}", number)).value();
  for (; decimal.digits.size() > 1 && decimal.digits.back() == '0'; ++decimal.place) {
    decimal.digits.pop_back();
  }
  return decimal;
}

/// The number > 0 rounded to so many digits.
sys::Decimal rounded(const Rational& number, int n_digits) {
  const auto size = [](const Integer& integer) { return static_cast<int>(integer.str().size()); };
  int place = size(numerator(number)) - size(denominator(number)) - n_digits + 1;
  if (number < power(10, place + n_digits - 1)) --place;
  const Rational digits = number * power(10, -place) + Rational(1, 2);
  return {.digits = Integer(numerator(digits) / denominator(digits)).str(), .place = place};
}

/// A factor as it is defined: a number times a power of π.
struct Factor {
  Rational number = 1;
  int power_of_pi = 0;
};

/// The factor of a name, of which UDUNITS-2 knows the double: π/180 for a degree, 1852/3600 for a
/// knot. A number of twelve digits or its reciprocal is meant, perhaps over a number by which
/// knots, survey feet, inches of mercury or psi are defined; or else a number of up to 15 digits.
std::optional<Factor> defined_factor(double factor) {
  constexpr std::size_t few = 12, most = 15;
  static const std::vector<Rational> divisors = {1, 9, Rational(1, 9801), Rational(10, 254),
                                                 Rational(64516, 980665000)};
  for (const int power_of_pi : {0, 1, -1}) {
    for (const Rational& divisor : divisors) {
      const double number =
          factor * divisor.convert_to<double>() / std::pow(std::numbers::pi, power_of_pi);
      const sys::Decimal decimal = shortest(without_rounding(number));
      if (decimal.digits.size() <= few) return Factor{rational(decimal) / divisor, power_of_pi};
      const sys::Decimal reciprocal = shortest(without_rounding(1 / number));
      if (reciprocal.digits.size() <= few) {
        return Factor{1 / (rational(reciprocal) * divisor), power_of_pi};
      }
    }
  }
  const sys::Decimal decimal = shortest(factor);
  if (decimal.digits.size() > most) return std::nullopt;
  return Factor{rational(decimal)};
}

/// The factor of a unit by those of its names, which are the base units of a system of their own,
/// so that UDUNITS-2 multiplies nothing.
std::optional<Factor> defined_factor(const std::string& unit) {
  std::string spelt = spelt_for_udunits(unit);
  for (const char* const times : {"·", "⋅", "×", " "}) boost::replace_all(spelt, times, " ");
  static const std::regex name("[^0-9 .*/^()+-]+([0-9]+[A-Za-z_]+)*");
  const System system(ut_new_system());
  std::map<std::string, Unit> names;
  for (std::sregex_iterator found(spelt.begin(), spelt.end(), name), end; found != end; ++found) {
    Unit& base = names[found->str()];
    if (base) continue;
    base.reset(ut_new_base_unit(system.get()));
    ut_map_symbol_to_unit(found->str().c_str(), UT_UTF8, base.get());
    ut_map_unit_to_symbol(base.get(), found->str().c_str(), UT_UTF8);
  }
  const Unit parsed(ut_parse(system.get(), spelt.c_str(), UT_UTF8));
  if (!parsed) return std::nullopt;
  const Product product = product_of(parsed.get());
  Factor factor{rational(shortest(product.scale))};
  for (const auto& [symbol, exponent] : product.powers) {
    const auto of_name = defined_factor(product_of(parse(symbol).get()).scale);
    if (!of_name) return std::nullopt;
    factor.number *= power(of_name->number, exponent);
    factor.power_of_pi += exponent * of_name->power_of_pi;
  }
  return factor;
}

/// A number in another unit.
struct Conversion {
  Rational number;
  bool is_exact = false;
};

Conversion conversion(double number, const std::string& from, const std::string& to) {
  const double factor = conversion_factor(from, to);
  const Rational given = rational(shortest(std::abs(number)));
  if (from == to || given == 0) return {given, true};
  const std::lock_guard lock(udunits);
  const auto above = defined_factor(from), below = defined_factor(to);
  if (above && below) {
    static const Rational pi(Integer("31415926535897932384626433832795028841972"),
                             power(10, 40).convert_to<Integer>());
    const int power_of_pi = above->power_of_pi - below->power_of_pi;
    const Rational defined = above->number / below->number * power(pi, power_of_pi);
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    if (std::abs(defined.convert_to<double>() / factor - 1) < rounding) {
      return {given * defined, power_of_pi == 0};
    }
  }
  return {rational(rounded(given * rational(shortest(factor)), 15)), false};
}

/// A double that prints only digits which the number ≥ 0 has: the nearest, unless its last digits
/// are due to its being a double.
double printable(const Rational& number) {
  if (number == 0) return 0;
  double rounded_number = 0;
  for (const int n_digits : {17, 16, 15}) {
    rounded_number = sys::number_of(rounded(number, n_digits));
    if (!std::isfinite(rounded_number)) break;
    const sys::Decimal printed = shortest(rounded_number);
    if (abs(rational(printed) - number) * 2 <= power(10, printed.place)) break;
  }
  return rounded_number;
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
  const std::lock_guard lock(udunits);
  require_known_factor(from, to);
  const Unit from_unit = parse(from);
  const Unit to_unit = parse(to);
  if (!ut_are_convertible(from_unit.get(), to_unit.get())) {
    throw UnitError(fmt::format("\"{}\" cannot be converted into \"{}\"", from, to));
  }
  require_same_angles(from, to);
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
  if (!std::isfinite(number)) return number * conversion_factor(from, to);
  return std::copysign(printable(conversion(number, from, to).number), number);
}

bool converts_exactly(double number, const std::string& from, const std::string& to) {
  const Conversion meant = conversion(number, from, to);
  const double printed = printable(meant.number);
  return meant.is_exact && std::isfinite(printed) && rational(shortest(printed)) == meant.number;
}

}  // namespace config
