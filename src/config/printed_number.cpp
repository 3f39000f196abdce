// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/printed_number.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace config {
namespace {

/// Rounds a number correctly to `n_digits` significant digits, as text with an exponent.
std::string rounded(double number, int n_digits) {
  return fmt::format("{:.{}e}", number, n_digits - 1);
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

PrintedNumber::PrintedNumber(std::string text) : text_(std::move(text)) {
  // from_chars reads as much as it understands, so check that nothing is left over.
  const char* end = text_.data() + text_.size();
  const auto [stop, error] = std::from_chars(text_.data(), end, value_);
  const bool is_decimal = text_.find_first_not_of("+-.0123456789eE") == std::string::npos;
  if (error != std::errc() || stop != end || !is_decimal ||
      !is_digit(text_.front() == '-' ? text_[1] : text_[0])) {
    throw std::invalid_argument(fmt::format("\"{}\" is not a decimal number", text_));
  }
  const std::size_t e = std::min(text_.find_first_of("eE"), text_.size());
  const std::size_t point = std::min(text_.find('.'), e);
  const long n_decimals = std::count_if(text_.begin() + static_cast<long>(point),
                                        text_.begin() + static_cast<long>(e), is_digit);
  int exponent = 0;
  if (e != text_.size()) {
    const char* digits = text_.data() + e + (text_[e + 1] == '+' ? 2 : 1);
    if (std::from_chars(digits, end, exponent).ec != std::errc()) {
      throw std::invalid_argument(fmt::format("\"{}\" is beyond the range of a double", text_));
    }
  }
  place_ = exponent - static_cast<int>(n_decimals);
  const std::size_t first = text_.find_first_of("123456789");
  n_digits_ = first >= e
                  ? 1
                  : static_cast<int>(std::count_if(text_.begin() + static_cast<long>(first),
                                                   text_.begin() + static_cast<long>(e), is_digit));
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

}  // namespace config
