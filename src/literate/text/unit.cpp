// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/unit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "config/units.hpp"
#include "literate/text/characters.hpp"
#include "system/decimal.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

using SignAndLatex = std::pair<std::string_view, std::string_view>;

/// The longer of two signs with the same beginning comes first, and the sign that is printed before
/// its twins.
constexpr auto unit_signs = std::to_array<SignAndLatex>({
    {" ", "\\ "},  // of what stands in braces, and before the blanks of the other commands
    {"°C", "\\degreeCelsius "},
    {"°", "\\degree "},
    {"µ", "\\micro "},  // micro sign
    {"μ", "\\micro "},  // mu
    {"Ω", "\\ohm "},    // Omega
    {"\u2126", "\\ohm "},
    {"Å", "\\LiterateAngstrom "},
    {"\u212B", "\\LiterateAngstrom "},
    {"′", "\\arcminute "},
    {"″", "\\arcsecond "},
    {"%", "\\percent "},
    {"‰", "\\text{\\textperthousand}"},
    {"€", "\\text{\\texteuro}"},
    {"ℓ", "\\ensuremath{\\ell}"},
    {"_", "\\text{\\textunderscore}"},
    {"₂", "_{2}"},
});

/// What one name of a unit prints as: UDUNITS takes a «u» for micro, and names for signs.
std::string sign_of_unit(std::string_view word) {
  static const std::set<std::string_view> after_micro = {
      "m", "s",   "g",   "N",  "Pa", "A", "V",  "W",   "J",  "K",   "F",  "H",  "C",  "L",
      "l", "mol", "rad", "Hz", "T",  "S", "Wb", "bar", "eV", "ohm", "Sv", "Gy", "Bq", "atm"};
  static const std::map<std::string_view, std::string_view> names = {
      {"deg", "°"},      {"degree", "°"},  {"degrees", "°"}, {"degC", "°C"}, {"degF", "°F"},
      {"angstrom", "Å"}, {"micron", "µm"}, {"percent", "%"}, {"'", "′"},     {"\"", "″"}};
  if (const auto name = names.find(word); name != names.end()) return std::string(name->second);
  if (word.starts_with('u') && after_micro.contains(word.substr(1))) {
    return "µ" + sign_of_unit(word.substr(1));
  }
  if (word == "ohm" || word == "kohm" || word == "Mohm" || word == "mohm") {
    return std::string(word.substr(0, word.size() - 3)) + "Ω";
  }
  std::string sign(word);
  boost::replace_all(sign, "H2O", "H₂O");
  boost::replace_all(sign, "CO2", "CO₂");
  return sign;
}

constexpr std::array<std::string_view, 10> superscripts = {"⁰", "¹", "²", "³", "⁴",
                                                           "⁵", "⁶", "⁷", "⁸", "⁹"};

struct Factor {
  std::string sign;
  int power = 1;
  std::string broken_power;  ///< «0.5» or «1/2», which stands for `power` if there is one
  bool is_divided = false;

  std::string power_text() const {
    if (!broken_power.empty()) return broken_power;
    return power == 1 ? "" : fmt::format("{}", power);
  }
};
using Factors = std::vector<Factor>;

class Reader {
 public:
  /// Names that UDUNITS does not know are refused if `refuses_unknown`.
  Reader(std::string_view unit, bool refuses_unknown)
      : unit_(unit), rest_(unit), refuses_unknown_(refuses_unknown) {}

  Factors all() {
    skip_blanks();
    Factors factors = product();
    if (!rest_.empty()) refuse(fmt::format("'{}' has no place there", next()));
    return factors;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw std::invalid_argument(fmt::format(
        "unit '{}': {}; a unit is spelt as m s-1, m.s^-1, m/s2, W/(m2.K), um, degC or %", unit_,
        why));
  }

  std::string_view next() const { return sys::first_character(rest_).bytes; }
  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }
  void skip_blanks() {
    while (take(" ") || take("\u00A0")) {
    }
  }
  bool digit_follows(std::size_t from = 0) const {
    return rest_.size() > from && sys::is_digit(rest_[from]);
  }

  bool takes_quotient() {
    for (const std::string_view word : {"per", "PER"}) {
      const bool is_at_end = rest_ == word;
      if (is_at_end || rest_.starts_with(std::string(word) + " ")) return take(word);
    }
    return take("/");
  }
  bool takes_product() {
    for (const std::string_view sign : {".", "·", "⋅", "*", "-", "×"}) {
      if (take(sign)) return true;
    }
    return false;
  }

  // A blank alone is a product, too.
  Factors product() {
    Factors factors = power();
    while (true) {
      skip_blanks();
      if (rest_.empty() || rest_.starts_with(')')) return factors;
      const bool is_quotient = takes_quotient();
      if (!is_quotient) takes_product();
      skip_blanks();
      for (Factor factor : power()) {
        factor.is_divided = factor.is_divided != is_quotient;
        factors.push_back(std::move(factor));
      }
    }
  }

  Factors power() {
    Factors factors = basic();
    const auto [whole, broken] = exponent();
    const bool is_group = factors.size() != 1;
    for (Factor& factor : factors) {
      if ((!broken.empty() && is_group) || (whole != 1 && !factor.broken_power.empty())) {
        refuse("a power of several names is a whole number");
      }
      factor.power *= whole;
      if (!broken.empty()) factor.broken_power = broken;
    }
    return factors;
  }

  Factors basic() {
    if (take("(")) {
      Factors factors = product();
      if (!take(")")) refuse("a parenthesis is not closed");
      return factors;
    }
    if (rest_.starts_with('1')) {
      static const sys::Pattern longer("1([0-9.]|[eE][-+]?[0-9])");
      if (longer.find_at_begin_of(rest_)) refuse("a number stands there for a name");
      rest_.remove_prefix(1);
      return {};
    }
    if (take("{")) return {{annotation(), 1, "", false}};
    const std::string_view word = name();
    if (refuses_unknown_ && !is_known(word)) {
      refuse(fmt::format(
          "UDUNITS-2 does not know '{}'; what it does not know stands in braces, {{{}}}", word,
          word));
    }
    return {{sign_of_unit(word), 1, "", false}};
  }

  static bool is_known(std::string_view word) {
    constexpr std::string_view unknown_to_udunits[] = {"€", "ℓ", "₂", "CO2"};
    for (const std::string_view sign : unknown_to_udunits) {
      if (word.find(sign) != word.npos) return true;
    }
    return sign_of_unit(word) != word || config::is_unit(std::string(word));
  }

  /// What is no unit of UDUNITS stands as it is, {vehicles}: letters, blanks and signs of units.
  std::string annotation() {
    const auto end = rest_.find('}');
    if (end == rest_.npos) refuse("a brace is not closed");
    const std::string_view text = taken(end);
    take("}");
    for (std::string_view left = text; !left.empty();) {
      const std::string_view character = sys::first_character(left).bytes;
      if (!is_part_of_name(character) && character != " ") {
        refuse(
            fmt::format("'{}' has no place in braces, which hold letters, blanks, _, % and signs "
                        "such as µ",
                        character));
      }
      left.remove_prefix(character.size());
    }
    if (text.empty()) refuse("nothing stands in braces");
    return std::string(text);
  }

  /// A name has letters and signs, and digits only in H2O and CO2.
  std::string_view name() {
    if (rest_.starts_with('\'') || rest_.starts_with('"')) return taken(1);
    std::size_t size = 0;
    while (size < rest_.size()) {
      const std::string_view left = rest_.substr(size);
      const std::string_view character = sys::first_character(left).bytes;
      if (left.starts_with("H2O") || left.starts_with("CO2")) {
        size += 3;
      } else if (is_part_of_name(character)) {
        size += character.size();
      } else {
        break;
      }
    }
    if (size == 0) refuse_beginning();
    const auto digits_end = rest_.find_first_not_of("0123456789", size);
    if (digit_follows(size) && digits_end != rest_.npos && is_letter(rest_[digits_end])) {
      const auto end =
          std::ranges::find_if_not(rest_.begin() + static_cast<std::ptrdiff_t>(size), rest_.end(),
                                   [](char c) { return is_letter(c) || sys::is_digit(c); });
      refuse(fmt::format("the name '{}' has a digit in it", std::string(rest_.begin(), end)));
    }
    return taken(size);
  }

  [[noreturn]] void refuse_beginning() const {
    if (rest_.empty()) refuse("a name is missing at its end");
    if (digit_follows()) refuse("a number stands there for a name");
    refuse(fmt::format("'{}' has no place there", next()));
  }

  std::string_view taken(std::size_t size) {
    const std::string_view text = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return text;
  }

  static bool is_part_of_name(std::string_view character) {
    if (character.size() == 1)
      return is_letter(character.front()) || character == "%" || character == "_";
    // What UDUNITS reads as a product or a power is no part of a name, and the rest must print.
    if (std::ranges::find(superscripts, character) != superscripts.end()) return false;
    for (const std::string_view sign : {"·", "⋅", "×", "⁻", "⁺", "\u00A0"}) {
      if (character == sign) return false;
    }
    return std::ranges::any_of(unit_signs,
                               [&](const SignAndLatex& s) { return s.first == character; });
  }

  /// The power behind a name, 1 if there is none, or one that is no whole number.
  std::pair<int, std::string> exponent() {
    if (const auto raised = superscript()) return {*raised, ""};
    if (!take("^") && !take("**")) return {digit_follows(sign_size()) ? whole() : 1, ""};
    if (take("(")) {
      const std::string broken = broken_number("+-0123456789./");
      if (!take(")")) refuse("a parenthesis is not closed");
      return with_broken(broken);
    }
    return with_broken(broken_number("+-0123456789."));
  }

  std::size_t sign_size() const { return rest_.starts_with('-') || rest_.starts_with('+') ? 1 : 0; }

  int whole() {
    const bool is_negative = rest_.starts_with('-');
    rest_.remove_prefix(sign_size());
    return (is_negative ? -1 : 1) *
           number(taken(std::min(rest_.find_first_not_of("0123456789"), rest_.size())));
  }

  std::string broken_number(const char* characters) {
    const auto end = std::min(rest_.find_first_not_of(characters), rest_.size());
    std::string text(taken(end));
    // The point of «m^2.s» is a product.
    while (!text.empty() && !sys::is_digit(text.back())) {
      rest_ = unit_.substr(unit_.size() - rest_.size() - 1);
      text.pop_back();
    }
    return text;
  }

  std::pair<int, std::string> with_broken(std::string text) {
    if (text.starts_with('+')) text.erase(0, 1);
    static const sys::Pattern broken(R"(-?\d+[./]\d+)");
    if (broken.is_all_of(text)) return {1, text};
    const bool is_negative = text.starts_with('-');
    return {(is_negative ? -1 : 1) * number(std::string_view(text).substr(is_negative ? 1 : 0)),
            ""};
  }

  int number(std::string_view digits) const {
    const auto parsed = sys::parsed<int>(digits);
    constexpr int most = 99;
    if (!parsed || *parsed > most) refuse("a power is a whole number");
    return *parsed;
  }

  std::optional<int> superscript() {
    std::string digits;
    const bool is_negative = take("⁻");
    if (!is_negative) take("⁺");
    for (bool found = true; found;) {
      found = false;
      for (std::size_t digit = 0; digit < superscripts.size(); ++digit) {
        if (!take(superscripts[digit])) continue;
        digits += static_cast<char>('0' + digit);
        found = true;
      }
    }
    if (digits.empty() && !is_negative) return std::nullopt;
    return (is_negative ? -1 : 1) * number(digits);
  }

  std::string_view unit_, rest_;
  bool refuses_unknown_;
};

Factors factors_of(std::string_view unit, bool refuses_unknown = true) {
  if (unit.empty()) return {};
  Factors factors = Reader(unit, refuses_unknown).all();
  std::erase_if(factors, [](const Factor& factor) {
    return factor.power == 0 && factor.broken_power.empty();
  });
  // «1/s» is printed as s⁻¹.
  if (std::ranges::all_of(factors, &Factor::is_divided)) {
    for (Factor& factor : factors) {
      factor.is_divided = false;
      if (factor.broken_power.empty()) {
        factor.power = -factor.power;
      } else {
        factor.broken_power = factor.broken_power.starts_with('-') ? factor.broken_power.substr(1)
                                                                   : "-" + factor.broken_power;
      }
    }
  }
  return factors;
}

/// Writes what is multiplied, a slash, and what divides it.
template <class Power>
std::string written(const Factors& factors, std::string_view times, const Power& with_power) {
  std::string above, below;
  int n_below = 0;
  for (const Factor& factor : factors) {
    std::string& text = factor.is_divided ? below : above;
    text += (text.empty() ? "" : std::string(times)) + with_power(factor);
    n_below += factor.is_divided ? 1 : 0;
  }
  if (n_below == 0) return above;
  return above + "/" + (n_below == 1 ? below : "(" + below + ")");
}

std::string plain_of(const Factors& factors) {
  return written(factors, " ", [](const Factor& factor) {
    std::string text = factor.sign;
    if (!factor.broken_power.empty()) return text + "^(" + factor.broken_power + ")";
    for (const char c : factor.power_text()) {
      text += c == '-' ? "⁻" : superscripts[static_cast<std::size_t>(c - '0')];
    }
    return text;
  });
}

}  // namespace

void require_unit(std::string_view unit) {
  factors_of(unit);
}

std::string plain_unit(std::string_view unit) {
  return plain_of(factors_of(unit));
}

std::string latex_unit(std::string_view unit) {
  return written(factors_of(unit), ".", [](const Factor& factor) {
    std::string text = factor.sign;
    for (const auto& [sign, latex] : unit_signs) boost::replace_all(text, sign, latex);
    const std::string power = factor.power_text();
    return power.empty() ? text : text + "^{" + power + "}";
  });
}

std::string unit_of_latex(std::string_view latex) {
  std::string text(latex);
  for (const auto& [sign, command] : unit_signs) {
    boost::replace_all(text, command, sign);
    if (command.ends_with(' ') && text.ends_with(command.substr(0, command.size() - 1))) {
      text.replace(text.size() - command.size() + 1, text.npos, sign);
    }
  }
  std::erase_if(text, [](char c) { return c == '{' || c == '}'; });
  try {
    return plain_of(factors_of(text, false));
  } catch (const std::invalid_argument&) {
    return std::string(latex);
  }
}

}  // namespace literate
