// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/unit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
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

/// Spellings of UDUNITS-2 that are read as simpler ones.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> spellings{
    {{"·", "."}, {"²", "2"}, {"³", "3"}, {"**", "^"}, {" per ", "/"}}};

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

/// Reads one name with its power, such as «m2», «s-1» or «in^4»; none if it is a number.
std::optional<Factor> factor_of(std::string_view word, bool is_divided) {
  const std::size_t end = word.find_last_not_of("0123456789+-^") + 1;
  Factor factor{std::string(word.substr(0, end)), std::string(word.substr(end)), is_divided};
  if (end == 0 || sys::is_digit(word.front()) || factor.name.find_first_of("+-^") != word.npos) {
    return std::nullopt;
  }
  if (factor.name.front() == 'u' &&
      std::ranges::find(after_micro, factor.name.substr(1)) != after_micro.end()) {
    factor.name.replace(0, 1, "µ");
  }
  std::erase_if(factor.power, [](char c) { return c == '^' || c == '+'; });
  if (factor.power == "1") factor.power.clear();
  return factor;
}

std::vector<Factor> factors_of(std::string_view unit) {
  const auto refuse = [unit] {
    throw std::invalid_argument(
        fmt::format("'{}' is not a unit that UDUNITS-2 knows; units are spelt as lbf/in, m s-1, "
                    "W/(m2.K), um, degC or %",
                    unit));
  };
  std::string text(sys::stripped(unit));
  if (text.empty() || text == "1") return {};
  if (!config::is_unit(text)) refuse();
  for (const auto& [from, to] : spellings) replace_all(text, from, to);

  std::vector<Factor> factors;
  bool is_divided = false, is_group_divided = false;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t size = std::min(rest.find_first_of(" .*/()"), rest.size());
    const std::string_view word = rest.substr(0, std::max<std::size_t>(size, 1));
    rest.remove_prefix(word.size());
    if (word == "/") is_divided = true;
    if (word == "(") is_group_divided = std::exchange(is_divided, false);
    if (word == ")") is_group_divided = false;
    if (size == 0) continue;
    if (word != "1") {
      const auto factor = factor_of(word, is_divided != is_group_divided);
      if (!factor) refuse();
      factors.push_back(*factor);
    }
    is_divided = false;
  }
  return factors;
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

}  // namespace literate
