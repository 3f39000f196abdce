// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <udunits2.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
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

void require_known_factor(const std::string& from, const std::string& to) {
  const std::string in_from = without_exact_factor(from), in_to = without_exact_factor(to);
  if (in_from.empty() == in_to.empty()) return;
  throw UnitError(fmt::format(
      "\"{}\" cannot be converted into \"{}\": UDUNITS-2 knows \"{}\" by a rounded or outdated "
      "number, so give the result itself",
      from, to, in_from.empty() ? in_to : in_from));
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
