// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/unit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "config/units.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

struct Sign {
  std::string_view name;   ///< in UDUNITS-2
  std::string_view plain;  ///< as printed
  std::string_view latex;
};

constexpr auto signs = std::to_array<Sign>({
    {"degC", "°C", "{}^{\\circ}\\mathrm{C}"},
    {"degF", "°F", "{}^{\\circ}\\mathrm{F}"},
    {"degree", "°", "^{\\circ}"},
    {"percent", "%", "\\%"},
    {"'", "′", "^{\\prime}"},
    {"\"", "″", "^{\\prime\\prime}"},
});

/// Letters in names that need a command in math mode.
constexpr auto letters = std::to_array<Sign>({
    {"ohm", "Ω", "\\Omega "},
    {"Ω", "Ω", "\\Omega "},
    {"µ", "µ", "\\mbox{\\textmu}"},  // micro sign
    {"μ", "µ", "\\mbox{\\textmu}"},  // mu
    {"Å", "Å", "\\mbox{\\AA}"},
});

/// Units in which a leading «u» means micro. In others it is part of the name, such as «unit».
constexpr std::array<std::string_view, 12> after_micro{"m", "s", "g", "N",   "Pa", "A",
                                                       "V", "W", "J", "rad", "K",  "L"};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// The name of a unit and its power, «s-1».
struct Factor {
  std::string name;
  std::string power;  ///< empty for 1
  bool is_divided = false;

  std::string plain() const {
    static constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴",
                                                             "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = name;
    for (const Sign& sign : signs) {
      if (name == sign.name) text = sign.plain;
    }
    for (const Sign& letter : letters) replace_all(text, letter.name, letter.plain);
    for (const char c : power) {
      text += c == '-'           ? "⁻"
              : sys::is_digit(c) ? raised[static_cast<std::size_t>(c - '0')]
                                 : std::string_view(&c, 1);
    }
    return text;
  }

  std::string latex() const {
    const std::string raised = power.empty() ? "" : fmt::format("^{{{}}}", power);
    for (const Sign& sign : signs) {
      if (name == sign.name || name == sign.plain) return std::string(sign.latex) + raised;
    }
    std::string text = name;
    replace_all(text, "_", "\\_");
    for (const Sign& letter : letters) replace_all(text, letter.name, letter.latex);
    return fmt::format("\\mathrm{{{}}}{}", text, raised);
  }
};

/// Splits a unit that UDUNITS-2 has accepted into its factors.
class Reader {
 public:
  explicit Reader(std::string_view unit) : rest_(unit) {}

  std::vector<Factor> product() {
    std::vector<Factor> factors;
    bool is_divided = false;
    while (!rest_.empty() && rest_.front() != ')') {
      if (takes("/") || takes("per ") || takes("PER ")) {
        is_divided = true;
      } else if (takes("(")) {
        for (Factor& factor : product()) {
          factor.is_divided = factor.is_divided != is_divided;
          factors.push_back(factor);
        }
        takes(")");
        is_divided = false;
      } else if (!takes(" ") && !takes(".") && !takes("*") && !takes("·") && !takes("-")) {
        Factor one = factor(is_divided);
        const bool is_one = one.name == "1" && one.power.empty();
        if (!is_one) factors.push_back(std::move(one));
        is_divided = false;
      }
    }
    return factors;
  }

 private:
  bool takes(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  Factor factor(bool is_divided) {
    constexpr std::string_view separators = " .*/^()-";
    std::size_t size = 1;
    while (size < rest_.size() && separators.find(rest_[size]) == separators.npos &&
           !starts_with_sign(rest_.substr(size)) && !ends_in_power(size)) {
      ++size;
    }
    Factor factor{std::string(rest_.substr(0, size)), "", is_divided};
    rest_.remove_prefix(size);
    if (factor.name.size() > 1 && factor.name.front() == 'u') {
      for (const std::string_view unit : after_micro) {
        if (factor.name == "u" + std::string(unit)) factor.name.replace(0, 1, "µ");
      }
    }
    if (!takes("**")) takes("^");
    factor.power = power();
    return factor;
  }

  /// Whether the rest of the name is only its power, as in m2.
  bool ends_in_power(std::size_t at) const {
    while (at < rest_.size() && sys::is_digit(rest_[at])) {
      ++at;
      if (at == rest_.size() || !sys::is_letter(rest_[at])) return true;
    }
    return false;
  }

  static bool starts_with_sign(std::string_view text) {
    return text.starts_with("·") || text.starts_with("²") || text.starts_with("³");
  }

  std::string power() {
    if (takes("²")) return "2";
    if (takes("³")) return "3";
    std::size_t size = rest_.starts_with('-') || rest_.starts_with('+') ? 1 : 0;
    const std::size_t n_signs = size;
    while (size < rest_.size() && sys::is_digit(rest_[size])) ++size;
    if (size == n_signs) return {};
    std::string digits(rest_.substr(rest_.starts_with('+') ? 1 : 0, size));
    rest_.remove_prefix(size);
    return digits == "1" ? "" : digits;
  }

  std::string_view rest_;
};

std::vector<Factor> factors_of(std::string_view unit) {
  const std::string_view text = sys::stripped(unit);
  if (text.empty() || text == "1") return {};
  if (config::is_unit(std::string(text))) {
    std::vector<Factor> factors = Reader(text).product();
    const auto is_number = [](const Factor& one) { return sys::is_digit(one.name.front()); };
    if (std::ranges::none_of(factors, is_number)) return factors;
  }
  throw std::invalid_argument(
      fmt::format("'{}' is not a unit that UDUNITS-2 knows; units are spelt as lbf/in, m s-1, "
                  "W/(m2.K), um, degC or %",
                  unit));
}

/// Joins factors with a sign; those that divide follow a slash.
template <typename Print>
std::string print_of(const std::vector<Factor>& factors, std::string_view times, Print&& print) {
  std::string above, below;
  int n_below = 0;
  for (const Factor& factor : factors) {
    std::string& text = factor.is_divided ? below : above;
    if (!text.empty()) text += times;
    text += print(factor);
    n_below += factor.is_divided ? 1 : 0;
  }
  if (below.empty()) return above;
  return fmt::format(fmt::runtime(n_below > 1 ? "{}/({})" : "{}/{}"), above.empty() ? "1" : above,
                     below);
}

}  // namespace

std::string plain_unit(std::string_view unit) {
  return print_of(factors_of(unit), " ", [](const Factor& factor) { return factor.plain(); });
}

std::string latex_unit(std::string_view unit) {
  return print_of(factors_of(unit), "\\,", [](const Factor& factor) { return factor.latex(); });
}

bool is_attached(std::string_view unit) {
  const std::string plain = plain_unit(unit);
  return plain == "°" || plain == "′" || plain == "″";
}

}  // namespace literate
