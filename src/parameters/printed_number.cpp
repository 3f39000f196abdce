// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/printed_number.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "system/decimal.hpp"

namespace parameters {
namespace {

// Formats a number, correctly rounded to `n_digits` significant digits, with an exponent.
std::string rounded(double number, int n_digits) {
  return fmt::format("{:.{}e}", number, n_digits - 1);
}

}  // namespace

PrintedNumber::PrintedNumber(std::string text) : text_(std::move(text)) {
  const auto decimal = sys::parse_decimal(text_);
  if (!decimal || text_.starts_with('+') || text_.find('.') == (text_.starts_with('-') ? 1U : 0U)) {
    throw std::invalid_argument(fmt::format("\"{}\" is not a decimal number", text_));
  }
  const auto value = sys::parsed<double>(text_);
  if (!value) {
    throw std::invalid_argument(fmt::format("\"{}\" is beyond the range of a double", text_));
  }
  value_ = *value;
  place_ = decimal->place;
  n_digits_ = static_cast<int>(decimal->digits.size());
}

double PrintedNumber::last_place() const {
  return std::pow(10.0, place_);
}

bool PrintedNumber::agrees_with(double number) const {
  return rounded(number, n_digits_) == rounded(value_, n_digits_);
}

PrintedNumber printed_number(const config::Table& table, const std::string& key) {
  try {
    return PrintedNumber(table.text(key));
  } catch (const std::invalid_argument& e) {
    table.fail(key, e.what());
  }
}

std::vector<PrintedNumber> printed_numbers(const config::Table& table, const std::string& key) {
  std::vector<PrintedNumber> numbers;
  try {
    for (const std::string& text : table.texts(key)) numbers.emplace_back(text);
  } catch (const std::invalid_argument& e) {
    table.fail(key, e.what());
  }
  return numbers;
}

}  // namespace parameters
