// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/printed_number.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <regex>
#include <stdexcept>
#include <utility>

namespace parameters {
namespace {

// A number rounded to that many significant digits, correctly, as text with an exponent.
std::string rounded(double number, int n_digits) {
  return fmt::format("{:.{}e}", number, n_digits - 1);
}

double number_of(const std::string& text) {
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

PrintedNumber::PrintedNumber(std::string text) : text_(std::move(text)) {
  static const std::regex decimal(R"(-?(\d+)(?:\.(\d*))?(?:[eE]([+-]?\d+))?)");
  std::smatch match;
  if (!std::regex_match(text_, match, decimal)) {
    throw std::invalid_argument(fmt::format("\"{}\" is not a decimal number", text_));
  }
  const std::string digits = match[1].str() + match[2].str();
  const std::size_t first = digits.find_first_not_of('0');
  n_digits_ = static_cast<int>(first == std::string::npos ? 1 : digits.size() - first);
  const int exponent = match[3].matched ? std::stoi(match[3]) : 0;
  place_ = exponent - static_cast<int>(match[2].length());
  value_ = number_of(text_);
}

double PrintedNumber::last_place() const {
  return std::pow(10.0, place_);
}

bool PrintedNumber::agrees_with(double number) const {
  return n_agreeing_digits(number) == n_digits_;
}

int PrintedNumber::n_agreeing_digits(double number) const {
  for (int n = n_digits_; n > 0; --n) {
    if (rounded(number, n) == rounded(value_, n)) return n;
  }
  return 0;
}

}  // namespace parameters
