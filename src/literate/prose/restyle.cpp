// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/restyle.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "config/units.hpp"
#include "literate/prose/document_files.hpp"
#include "literate/prose/tex_commands.hpp"
#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "system/decimal.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

using Options = std::map<std::string, std::string>;

constexpr int digits_of_double = 17;  // of a double

/// Splits «digits=3, unit={lbf/in}» at its commas.
Options options_in(std::string_view text) {
  Options options;
  while (!text.empty()) {
    std::size_t end = 0;
    for (int depth = 0; end < text.size() && (depth > 0 || text[end] != ','); ++end) {
      depth += (text[end] == '{' ? 1 : 0) - (text[end] == '}' ? 1 : 0);
    }
    const std::string_view option = sys::stripped(text.substr(0, end));
    text.remove_prefix(std::min(text.size(), end + 1));
    const auto equals = option.find('=');
    if (equals == option.npos) {
      throw std::invalid_argument(fmt::format(
          "option '{}' has no value, as digits=3, format=percent and unit=mm have", option));
    }
    const std::string name(sys::stripped(option.substr(0, equals)));
    std::string_view value = sys::stripped(option.substr(equals + 1));
    if (value.starts_with('{') && value.ends_with('}')) value = value.substr(1, value.size() - 2);
    if (!options.emplace(name, value).second) {
      throw std::invalid_argument(fmt::format("option '{}' is given twice", name));
    }
  }
  return options;
}

void require_known(const Options& options, const std::set<std::string>& known, const char* listed) {
  for (const auto& [name, value] : options) {
    if (known.contains(name)) continue;
    throw std::invalid_argument(
        fmt::format("unknown option '{}': must be one of {}", name, listed));
  }
}

std::optional<int> count_of(const Options& options, const std::string& name, int least) {
  const auto option = options.find(name);
  if (option == options.end()) return std::nullopt;
  const auto count = sys::parsed<int>(option->second);
  if (!count || *count < least || *count > digits_of_double) {
    throw std::invalid_argument(fmt::format("{} = {}: must be a whole number from {} to {}", name,
                                            option->second, least, digits_of_double));
  }
  return count;
}

/// A number in another unit.
double in_unit(double number, const std::string& from, const std::string& to) {
  const auto known = [](const std::string& unit) { return unit.empty() ? std::string("1") : unit; };
  try {
    return config::converted(number, known(from), known(to));
  } catch (const config::UnitError& error) {
    throw std::invalid_argument(fmt::format("unit = {}: {}", to, error.what()));
  }
}

/// The error of a number in another unit. The rounding of the conversion belongs to it where the
/// error has digits as small; elsewhere it would only lift an error of 1 above 1, and cost a digit,
/// although the rounding to the printed digits is ten thousand times greater.
double converted_error(double abs_error, const std::string& from, const std::string& unit,
                       double rounding) {
  constexpr double least_share = 1e-6;
  const double error = in_unit(abs_error, from, unit);
  return rounding < least_share * error ? error : error + rounding;
}

/// The number in another unit. One that was exact has the rounding of the conversion, unless its
/// digits end there: 0.01 in are 0.254 mm.
StoredNumber converted(StoredNumber stored, const std::string& unit) {
  const bool is_ratio = stored.is_percentage || stored.unit.empty();
  if (is_ratio && (unit == "percent" || unit == "1")) {
    stored.is_percentage = unit == "percent";
    return stored;
  }
  require_unit(unit);
  const std::string from = stored.is_percentage ? "1" : stored.unit;
  const double factor = in_unit(1, from, unit);
  stored.is_percentage = false;
  if (unit == stored.unit) return stored;
  stored.unit = unit == "1" ? "" : unit;
  if (factor == 1) return stored;
  const double before = stored.number;
  stored.number = in_unit(before, from, unit);
  const bool is_exact = config::converts_exactly(before, from, unit);
  const double rounding =
      (is_exact ? 2 : 5) * std::numeric_limits<double>::epsilon() * std::abs(stored.number);
  if (stored.is_exact) {
    if (is_exact) return stored;
    stored.is_exact = false;
    stored.uncertainty = Uncertainty(rounding);
  } else if (stored.uncertainty) {
    Uncertainty& uncertainty = *stored.uncertainty;
    uncertainty.bound = converted_error(uncertainty.bound, from, unit, rounding);
    if (uncertainty.sides) {
      for (double* side : {&uncertainty.sides->first, &uncertainty.sides->second}) {
        *side = converted_error(*side, from, unit, rounding);
      }
    }
    uncertainty.standard *= std::abs(factor);
    uncertainty.neglected *= std::abs(factor);
    for (auto& [kind, standard] : uncertainty.kinds) standard *= std::abs(factor);
  }
  stored.conversion = factor;
  return stored;
}

/// How many significant digits the value has at most in another style: those that its format names,
/// where an error tells which of them are earned, and otherwise those that it is printed with. An
/// exact one has those before its point, and three at least, so that 5 km/h are 3.11 mi/h.
int n_digits_of(const StoredNumber& stored) {
  const bool names_digits = stored.notation == Notation::significant ||
                            stored.notation == Notation::scientific ||
                            stored.notation == Notation::supported;
  if (names_digits && stored.uncertainty && !stored.is_exact) {
    return std::clamp(stored.digits, 1, digits_of_double);
  }
  constexpr int fewest_of_exact = 3;
  const int last = stored.is_exact ? std::min(stored.last_place, 0) : stored.last_place;
  const Decimal printed = rounded_to_place(stored.number, last);
  const int fewest = stored.is_exact ? fewest_of_exact : 1;
  return std::clamp(leading_place(printed) - last + 1, fewest, digits_of_double);
}

struct Wish {
  std::optional<std::string> format;
  std::optional<int> digits, decimals, max_digits;

  bool names_place() const { return digits || decimals; }
};

/// The digits behind the point that the stored number is printed with, in per cent if it is.
int decimals_of(const StoredNumber& stored) {
  return std::clamp(-stored.last_place - (stored.is_percentage ? 2 : 0), 0, digits_of_double);
}

/// How many digits `maxdigits` leaves: those that are known, where no error tells which are earned.
int at_most(const StoredNumber& stored, std::optional<int> most, int n_digits) {
  if (!most) return n_digits;
  if (stored.is_exact)
    return std::min(*most, static_cast<int>(shortest(stored.number).digits.size()));
  return stored.uncertainty ? *most : std::min(*most, n_digits);
}

Format with_digits(const StoredNumber& stored, const Wish& wish, int n_digits, bool is_scientific) {
  if (wish.decimals) {
    throw std::invalid_argument("decimals go with format=fixed and percent: say digits");
  }
  const int n = wish.digits.value_or(at_most(stored, wish.max_digits, n_digits));
  const bool keeps_supported =
      stored.notation == Notation::supported && stored.uncertainty && !wish.format && !wish.digits;
  const Format format = is_scientific     ? scientific(n)
                        : keeps_supported ? supported(n)
                                          : significant(n);
  return stored.is_percentage ? format.in_percent() : format;
}

Format with_decimals(const StoredNumber& stored, const Wish& wish) {
  const Format format = fixed(wish.decimals.value_or(decimals_of(stored)));
  return stored.is_percentage ? format.in_percent() : format;
}

Format uncertain_like(const StoredNumber& stored) {
  const Format format = stored.tells_kinds ? uncertain().by_kind() : uncertain();
  return stored.is_percentage ? format.in_percent() : format;
}

/// The format that the options ask for; `n_digits` are those of the print so far.
Format format_of(const StoredNumber& stored, const Wish& wish, int n_digits) {
  if (wish.digits && wish.decimals) {
    throw std::invalid_argument("digits and decimals cannot both be given");
  }
  if (wish.max_digits &&
      (wish.names_place() || wish.format == "fixed" || wish.format == "uncertain")) {
    throw std::invalid_argument(
        "maxdigits goes with format=significant, scientific and percent alone");
  }
  const bool was_scientific = stored.notation == Notation::scientific;
  if (!wish.format) {
    if (stored.notation == Notation::uncertain && stored.uncertainty && !wish.names_place() &&
        !wish.max_digits) {
      return uncertain_like(stored);
    }
    if (wish.decimals) return with_decimals(stored, wish);
    return with_digits(stored, wish, n_digits, was_scientific);
  }
  const std::string& name = *wish.format;
  if (name == "fixed") {
    if (wish.digits) throw std::invalid_argument("format=fixed takes decimals, not digits");
    return with_decimals(stored, wish);
  }
  if (name == "significant") return with_digits(stored, wish, n_digits, false);
  if (name == "scientific") return with_digits(stored, wish, n_digits, true);
  if (name == "uncertain") {
    if (wish.names_place()) {
      throw std::invalid_argument("format=uncertain has the digits that the error gives it");
    }
    return uncertain_like(stored);
  }
  if (name == "percent") {
    if (!stored.unit.empty()) {
      throw std::invalid_argument(
          fmt::format("format = percent: the value has the unit {}", stored.unit));
    }
    StoredNumber ratio = stored;
    ratio.is_percentage = true;
    return wish.digits || wish.max_digits ? with_digits(ratio, wish, n_digits, false)
                                          : with_decimals(ratio, wish);
  }
  throw std::invalid_argument(fmt::format(
      "format = {}: must be one of fixed, significant, scientific, percent, uncertain", name));
}

/// The number in a style, without its error.
Value bare(const StoredNumber& stored, const Format& format) {
  return {stored.number, format, format.is_percentage() ? "" : stored.unit};
}

/// Whether a style prints digits that were never printed of a number without an error.
bool prints_unknown_digits(const StoredNumber& stored, const Format& format) {
  const double last = std::pow(10.0, stored.last_place) * stored.conversion;
  return !stored.uncertainty && !stored.is_exact &&
         std::pow(10.0, bare(stored, format).last_place()) < last * (1 - 1e-9);
}

/// Throws for digits that the error of the stored number does not support, or that were never
/// printed if it has none.
void require_earned_digits(const StoredNumber& stored, const Format& format) {
  const Value value = bare(stored, format);
  if (stored.uncertainty) {
    require_earned(stored.number, value.last_place(), stored.uncertainty->error(), value.printed());
  } else if (prints_unknown_digits(stored, format)) {
    throw std::invalid_argument(fmt::format(
        "'{}' has more digits than the value, which has no error bound, is printed with",
        value.printed()));
  }
}

}  // namespace

Value restyled(const StoredNumber& original, std::string_view text) {
  const Options options = options_in(text);
  require_known(options, {"digits", "decimals", "maxdigits", "format", "unit"},
                "digits, decimals, maxdigits, format, unit");
  const auto text_of = [&](const char* name) -> std::optional<std::string> {
    const auto option = options.find(name);
    return option == options.end() ? std::nullopt : std::optional(option->second);
  };
  const Wish wish{text_of("format"), count_of(options, "digits", 1),
                  count_of(options, "decimals", 0), count_of(options, "maxdigits", 1)};
  const std::optional<std::string> unit = text_of("unit");
  const StoredNumber stored = unit ? converted(original, *unit) : original;

  if (stored.is_exact && !wish.format && !wish.names_place() && !wish.max_digits) {
    const Format format = stored.is_percentage ? exact().in_percent() : exact();
    return {stored.number, format, stored.unit};
  }
  // Without digits named, as many are printed as are known.
  int n_digits = n_digits_of(original);
  Format format = format_of(stored, wish, n_digits);
  while (!wish.names_place() && n_digits > 1 && prints_unknown_digits(stored, format)) {
    format = format_of(stored, wish, --n_digits);
  }
  if (original.rounds_up) format = format.rounded_up();
  const std::string unit_of_print = format.is_percentage() ? "" : stored.unit;
  if (format.notation() == Notation::uncertain) {
    if (!stored.uncertainty) throw std::invalid_argument("format=uncertain needs an error");
    return {stored.number, *stored.uncertainty, format, unit_of_print};
  }
  if (stored.is_exact) return {numerics::Estimate{stored.number, 0}, format, unit_of_print};
  if (wish.names_place() || !stored.uncertainty) require_earned_digits(stored, format);
  return {stored.number, stored.uncertainty.value_or(0), format, unit_of_print};
}

double restyled_number(const StoredNumber& stored, std::string_view text) {
  const Options options = options_in(text);
  require_known(options, {"unit"}, "unit, since \\rawval gives the unrounded number");
  const auto unit = options.find("unit");
  if (unit == options.end()) return stored.number;
  const StoredNumber restyled = converted(stored, unit->second);
  return restyled.is_percentage ? in_unit(restyled.number, "1", "percent") : restyled.number;
}

Restyled restyled_values(const std::filesystem::path& source_dir, const Names& names) {
  Restyled result;
  std::set<std::string> lines;
  const OwnCommands own = own_commands_of(source_dir);
  for (const DocumentFile& file : read_document(source_dir)) {
    for (const TexCommand& use : commands_in(file.text, {"val", "rawval"}, own)) {
      if (use.options.empty() || !names.values.contains(use.argument)) continue;
      const auto stored = names.numbers.find(use.argument);
      try {
        if (stored == names.numbers.end()) {
          throw std::invalid_argument("the value is a text, which has no other style");
        }
        if (use.name == "rawval") {
          lines.insert(fmt::format("\\LiterateRestyledRaw{{{}}}{{[{}]}}{{{}}}\n", use.argument,
                                   use.options,
                                   bare_digits(restyled_number(stored->second, use.options))));
        } else {
          const Value value = restyled(stored->second, use.options);
          lines.insert(fmt::format("\\LiterateRestyled{{{}}}{{[{}]}}{{{}}}{{{}}}\n", use.argument,
                                   use.options, value.latex(), escape_bookmark(value.printed())));
        }
      } catch (const std::invalid_argument& error) {
        result.errors.push_back(fmt::format("{}: \\{}[{}]{{{}}}: {}", file.at(use.line, use.column),
                                            use.name, use.options, use.argument, error.what()));
      }
    }
  }
  for (const std::string& line : lines) result.latex += line;
  return result;
}

}  // namespace literate
