// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/limit.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

#include "system/decimal.hpp"

namespace literate {
namespace {

/// Reads a formula from the left, a function for each level of precedence.
class Reader {
 public:
  Reader(std::string_view formula, const std::map<std::string, double>& terms)
      : formula_(formula), rest_(formula), terms_(terms) {}

  double read() {
    const double number = sum();
    if (!rest_.empty()) fail(fmt::format("'{}' is not understood", rest_));
    for (const auto& [name, value] : terms_) {
      if (!used_.contains(name)) {
        fail(fmt::format("a number is given for '{}', which it does not have", name));
      }
    }
    if (!std::isfinite(number)) fail("it has no finite value");
    return number;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(fmt::format("the formula '{}': {}", formula_, what));
  }

  bool take(std::string_view sign) {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }

  bool begins_with_number() const {
    return !rest_.empty() && (sys::is_digit(rest_.front()) || rest_.front() == '.');
  }

  double sum() {
    const bool is_negative = take("−") || take("-");
    double number = product();
    if (is_negative) number = -number;
    for (;;) {
      if (take("+")) {
        number += product();
      } else if (take("−") || take("-")) {
        number -= product();
      } else {
        return number;
      }
    }
  }

  double product() {
    std::optional<double> next = power();
    if (!next) {
      std::string_view name = rest_.substr(0, rest_.find_first_of(" +-*/()[]"));
      for (const char* sign : {"−", "·", "²", "³", "⁴"}) name = name.substr(0, name.find(sign));
      if (name.empty()) fail("a number, a term or a parenthesis is missing");
      fail(fmt::format("no number is given for '{}'", name));
    }
    double number = *next;
    for (bool has_divided = false;;) {
      const bool divides = take("/");
      const bool has_sign = divides || take("·");
      // «1 000 a» is no thousand, and «1.5.2» no number.
      if (!has_sign && begins_with_number()) fail("a · is missing before a number");
      next = power();
      if (!next && has_sign) fail("a factor is missing");
      if (!next) return number;
      if (has_divided && !has_sign) fail("«a/b c» may be read in two ways: a/(b c), or a/b·c");
      has_divided = divides;
      number = divides ? number / *next : number * *next;
    }
  }

  std::optional<double> power() {
    std::optional<double> number = factor();
    if (!number) return number;
    for (const auto& [sign, exponent] : {std::pair{"²", 2}, {"³", 3}, {"⁴", 4}}) {
      if (take(sign)) return std::pow(*number, exponent);
    }
    return number;
  }

  std::optional<double> factor() {
    for (const auto& [open, close] : {std::pair{"(", ")"}, {"[", "]"}}) {
      if (!take(open)) continue;
      const double number = sum();
      if (!take(close)) fail(fmt::format("'{}' is not closed", open));
      return number;
    }
    if (take("ln")) {
      const auto number = power();
      if (!number) fail("ln of nothing");
      return std::log(*number);
    }
    return term_or_number();
  }

  std::optional<double> term_or_number() {
    const std::string* longest = nullptr;  // a name may begin with another one
    for (const auto& [name, value] : terms_) {
      if (rest_.starts_with(name) && (!longest || name.size() > longest->size())) longest = &name;
    }
    if (longest) {
      rest_.remove_prefix(longest->size());
      used_.insert(*longest);
      return terms_.at(*longest);
    }
    double number = 0;
    const auto read = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (read.ec != std::errc() || rest_.starts_with('-')) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(read.ptr - rest_.data()));
    return number;
  }

  std::string_view formula_, rest_;
  const std::map<std::string, double>& terms_;
  std::set<std::string> used_;
};

}  // namespace

double evaluated(std::string_view formula, const std::map<std::string, double>& terms) {
  return Reader(formula, terms).read();
}

}  // namespace literate
