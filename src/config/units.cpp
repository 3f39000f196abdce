// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <udunits2.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/unit_definitions.hpp"
#include "system/decimal.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

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

/// UDUNITS reads m² but not m⁻² or m⁴, no deg, and m^0.5 as five times m⁰, without a word.
std::string spelt_for_udunits(std::string name) {
  static const sys::Pattern broken_power(R"((\^|\*\*)[+-]?\d+\.\d)");
  if (broken_power.is_in(name)) {
    throw UnitError(fmt::format("unit \"{}\" has a power that is no whole number", name));
  }
  constexpr std::pair<const char*, const char*> raised[] = {
      {"⁻", "-"}, {"⁺", "+"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"},
      {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};
  for (const auto& [sign, digit] : raised) boost::replace_all(name, sign, digit);
  static const sys::Pattern degree("(^|[^A-Za-z_])deg(?![A-Za-z_])");
  return degree.replaced_in(name, "$1degree");
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

void require_same_angles(const std::string& from, const std::string& to) {
  const auto angles = [](const std::string& unit) {
    return product_of(parse(unit).get()).power("rad");
  };
  if (angles(from) == angles(to)) return;
  throw UnitError(fmt::format(
      "\"{}\" cannot be converted into \"{}\": an angle is not converted into a number without one",
      from, to));
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

/// The number > 0 rounded to so many digits.
sys::Decimal rounded(const Rational& number, int n_digits) {
  const auto size = [](const Integer& integer) { return static_cast<int>(integer.str().size()); };
  int place = size(numerator(number)) - size(denominator(number)) - n_digits + 1;
  if (number < power(10, place + n_digits - 1)) --place;
  const Rational digits = number * power(10, -place) + Rational(1, 2);
  return {.digits = Integer(numerator(digits) / denominator(digits)).str(), .place = place};
}

/// The exponent of ten if the number is a power of ten, but for the rounding of doubles.
std::optional<int> power_of_ten(double number) {
  const double exponent = std::round(std::log10(number));
  if (!std::isfinite(exponent)) return std::nullopt;
  const double rounding = 64 * std::numeric_limits<double>::epsilon();
  if (std::abs(number / std::pow(10.0, exponent) - 1) > rounding) return std::nullopt;
  return static_cast<int>(exponent);
}

/// Whether a name is one of those that stand for several units, with a prefix or in the plural:
/// Mcal and tons, but neither pascal, which is another quantity, nor short_ton.
bool means_several_units(const std::string& name) {
  static const auto several = [] {
    std::vector<std::pair<std::string, Product>> all;
    for (const char* const unit : ambiguous_names)
      all.emplace_back(unit, product_of(parse(unit).get()));
    return all;
  }();
  const Product product = product_of(parse(name).get());
  return std::ranges::any_of(several, [&](const auto& entry) {
    const auto& [unit, meant] = entry;
    const bool is_plural = name.ends_with(unit + "s");
    if (!is_plural && !name.ends_with(unit)) return false;
    const std::string prefix = name.substr(0, name.size() - unit.size() - (is_plural ? 1 : 0));
    return !prefix.ends_with('_') && product.powers == meant.powers &&
           power_of_ten(product.scale / meant.scale);
  });
}

/// A unit as it is defined: a number, a power of π, SI base units, and units without an exact
/// definition.
struct Factor {
  Rational number = 1;
  int power_of_pi = 0;
  std::map<std::string, int> undefined = {};
};

/// The factor of one name, with its prefix and its plural.
Factor factor_of_name(const std::string& name) {
  const Product unit = product_of(parse(name).get());
  const bool is_one_unit = !means_several_units(name);
  if (const auto exponent = power_of_ten(unit.scale); exponent && is_one_unit) {
    return {power(10, *exponent)};
  }
  static const auto defined = [] {
    std::vector<std::pair<Product, const Definition*>> all;
    for (const Definition& definition : definitions) {
      all.emplace_back(product_of(parse(definition.name).get()), &definition);
    }
    return all;
  }();
  for (const auto& [product, definition] : defined) {
    const auto exponent = power_of_ten(unit.scale / product.scale);
    if (!exponent || unit.powers != product.powers || !is_one_unit) continue;
    return {power(10, *exponent) * rational(sys::parse_decimal(definition->number).value()) /
                rational(sys::parse_decimal(definition->over).value()),
            definition->power_of_pi};
  }
  const int magnitude = static_cast<int>(std::floor(std::log10(unit.scale)));
  std::string known_by = is_one_unit ? "" : "several ";
  known_by += fmt::format("{:.12g}", unit.scale / std::pow(10.0, magnitude));
  for (const auto& [symbol, exponent] : unit.powers) {
    known_by += fmt::format(" {}{}", symbol, exponent);
  }
  return {power(10, magnitude), 0, {{known_by, 1}}};
}

/// The names in a unit: kg, m and s in kg.m/s2.
std::vector<std::string> names_in(const std::string& spelt) {
  static const sys::Pattern name("[^0-9 .*/^()+-]+([0-9]+[A-Za-z_]+)*");
  std::vector<std::string> names;
  for (const sys::Pattern::Match& found : name.all_in(spelt)) {
    const bool is_exponent = !found.before.empty() && sys::is_digit(found.before.back()) &&
                             boost::iequals(found.parts[0], "e");
    if (!is_exponent) names.push_back(found.str());
  }
  return names;
}

/// The factor of a unit by those of its names, which are the base units of a system of their own,
/// so that UDUNITS-2 multiplies nothing. Empty if UDUNITS-2 reads names that are not found.
std::optional<Factor> factor_of(const std::string& unit) {
  std::string spelt = spelt_for_udunits(unit);
  for (const char* const times : {"·", "⋅", "×", " "}) boost::replace_all(spelt, times, " ");
  const System system(ut_new_system());
  std::map<std::string, Unit> names;
  for (const std::string& name : names_in(spelt)) {
    Unit& base = names[name];
    if (base) continue;
    base.reset(ut_new_base_unit(system.get()));
    ut_map_symbol_to_unit(name.c_str(), UT_UTF8, base.get());
    ut_map_unit_to_symbol(base.get(), name.c_str(), UT_UTF8);
  }
  const Unit parsed(ut_parse(system.get(), spelt.c_str(), UT_UTF8));
  if (!parsed) return std::nullopt;
  const Product product = product_of(parsed.get());
  Factor factor{rational(sys::shortest(product.scale))};
  for (const auto& [symbol, exponent] : product.powers) {
    const Factor of_name = factor_of_name(symbol);
    factor.number *= power(of_name.number, exponent);
    factor.power_of_pi += exponent * of_name.power_of_pi;
    for (const auto& [name, n] : of_name.undefined) factor.undefined[name] += n * exponent;
  }
  std::erase_if(factor.undefined, [](const auto& entry) { return entry.second == 0; });
  return factor;
}

void require_multiple(const std::string& from, const std::string& to) {
  const Unit from_unit = parse(from), to_unit = parse(to);
  if (!ut_are_convertible(from_unit.get(), to_unit.get())) {
    throw UnitError(fmt::format("\"{}\" cannot be converted into \"{}\"", from, to));
  }
  require_same_angles(from, to);
  const Converter converter(ut_get_converter(from_unit.get(), to_unit.get()));
  const double factor = cv_convert_double(converter.get(), 1);
  if (cv_convert_double(converter.get(), 2) == factor / 2) {
    throw UnitError(fmt::format(
        "\"{}\" is the reciprocal of \"{}\", and only a factor converts units", from, to));
  }
  // An offset ("in from 3", "degC") or a logarithm ("lg(re 1 mm)") cannot be a factor.
  const bool is_factor = cv_convert_double(converter.get(), 0) == 0 &&
                         std::abs(cv_convert_double(converter.get(), 2) - 2 * factor) <=
                             4 * std::numeric_limits<double>::epsilon() * std::abs(factor);
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
}

/// The first name in the two units that has no exact definition.
std::string undefined_name(const std::string& from, const std::string& to) {
  for (const std::string& unit : {from, to}) {
    for (const std::string& name : names_in(spelt_for_udunits(unit))) {
      const Unit parsed(ut_parse(database(), name.c_str(), UT_UTF8));
      if (parsed && !factor_of_name(name).undefined.empty()) return name;
    }
  }
  return from;
}

/// A number in another unit.
struct Conversion {
  Rational number;
  bool is_exact = false;
};

/// Converts a number ≥ 0.
Conversion conversion(double number, const std::string& from, const std::string& to) {
  const Rational given = rational(sys::shortest(number));
  if (from == to) return {given, true};
  const std::lock_guard lock(udunits);
  require_multiple(from, to);
  const auto above = factor_of(from), below = factor_of(to);
  if (!above || !below || above->undefined != below->undefined) {
    throw UnitError(fmt::format(
        "\"{}\" cannot be converted into \"{}\": no single exact definition of \"{}\" is "
        "known, so name a unit that has one, as Julian_year, short_ton, IT_calorie and "
        "nautical_mile do, or give the result itself",
        from, to, undefined_name(from, to)));
  }
  static const Rational pi(Integer("31415926535897932384626433832795028841972"),
                           power(10, 40).convert_to<Integer>());
  const int power_of_pi = above->power_of_pi - below->power_of_pi;
  return {given * above->number / below->number * power(pi, power_of_pi),
          given == 0 || power_of_pi == 0};
}

/// A double that prints only digits which the number ≥ 0 has: the nearest, unless its last digits
/// are due to its being a double.
double printable(const Rational& number) {
  if (number == 0) return 0;
  double rounded_number = 0;
  for (const int n_digits : {17, 16, 15}) {
    rounded_number = sys::number_of(rounded(number, n_digits));
    if (!std::isfinite(rounded_number)) break;
    const sys::Decimal printed = sys::shortest(rounded_number);
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

double converted(double number, const std::string& from, const std::string& to) {
  if (!std::isfinite(number)) return conversion(1, from, to), number;
  return std::copysign(printable(conversion(std::abs(number), from, to).number), number);
}

bool converts_exactly(double number, const std::string& from, const std::string& to) {
  const Conversion meant = conversion(std::abs(number), from, to);
  const double printed = printable(meant.number);
  return meant.is_exact && std::isfinite(printed) &&
         rational(sys::shortest(printed)) == meant.number;
}

}  // namespace config
