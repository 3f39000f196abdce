// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/secret_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>

#include "system/decimal.hpp"
#include "system/text.hpp"

namespace course {
namespace {

constexpr std::size_t least_digits = 6;
constexpr std::size_t most_digits = 8;
constexpr std::size_t telling_digits = 5;  // anybody may have written a number with fewer

using sys::is_digit;

bool continues_word(char c) {
  return sys::is_alphanumeric(c) || c == '_';
}

// The significant digits of a number, rounded to n.
std::string digits_of(double number, std::size_t n) {
  std::string digits = fmt::format("{:.{}e}", std::abs(number), n - 1);
  digits.resize(digits.find('e'));
  std::erase(digits, '.');
  return digits;
}

bool is_telling(const std::string& digits) {
  const auto last = digits.find_last_not_of('0');
  return last != std::string::npos && last + 1 >= telling_digits;
}

// The digits rounded to n of them; "99999996" becomes "10000000".
std::string rounded(const std::string& digits, std::size_t n) {
  std::string result = digits.substr(0, n);
  if (digits.size() <= n || digits[n] < '5') return result;
  for (std::size_t i = n; i-- > 0;) {
    if (result[i] != '9') {
      ++result[i];
      return result;
    }
    result[i] = '0';
  }
  return "1" + result.substr(0, n - 1);
}

// Reads a number with its point and exponent, returns its significant digits, and moves `at`
// behind it.
std::string read_digits(std::string_view text, std::size_t& at) {
  std::string digits;
  bool has_point = false;
  for (; at < text.size(); ++at) {
    if (is_digit(text[at])) {
      if (!digits.empty() || text[at] != '0') digits += text[at];
    } else if (text[at] == '.' && !has_point) {
      has_point = true;
    } else {
      break;
    }
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t end = at + 1;
    if (end < text.size() && (text[end] == '+' || text[end] == '-')) ++end;
    const std::size_t first = end;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end > first) at = end;
  }
  return digits;
}

}  // namespace

SecretNumbers::SecretNumbers(const std::vector<double>& numbers) {
  for (const double number : numbers) {
    if (!std::isfinite(number) || !is_telling(digits_of(number, least_digits))) continue;
    const std::string all = digits_of(number, 17);
    for (std::size_t n = least_digits; n <= most_digits; ++n) {
      digits_.insert(all.substr(0, n));
      digits_.insert(rounded(all, n));
    }
    patterns_.push_back(std::bit_cast<std::uint64_t>(number));
    patterns_.push_back(std::bit_cast<std::uint64_t>(-number));
  }
  std::ranges::sort(patterns_);
}

bool SecretNumbers::is_secret(const std::string& digits) const {
  if (digits.size() < least_digits) return false;
  const std::size_t n = std::min(digits.size(), most_digits);
  const std::string cut = digits.substr(0, n);
  return is_telling(cut) && (digits_.contains(cut) || digits_.contains(rounded(digits, n)));
}

std::vector<std::string> SecretNumbers::printed_in(std::string_view text) const {
  std::vector<std::string> found;
  std::size_t at = 0;
  while (at < text.size()) {
    const bool begins =
        is_digit(text[at]) || (text[at] == '.' && at + 1 < text.size() && is_digit(text[at + 1]));
    if (!begins) {
      // A digit inside a word does not begin a number.
      if (!continues_word(text[at++])) continue;
      while (at < text.size() && continues_word(text[at])) ++at;
      continue;
    }
    const std::size_t begin = at;
    const std::string digits = read_digits(text, at);
    const bool ends = at == text.size() || !continues_word(text[at]);
    if (ends && is_secret(digits)) found.emplace_back(text.substr(begin, at - begin));
    while (at < text.size() && continues_word(text[at])) ++at;
  }
  return found;
}

bool SecretNumbers::stored_in(std::string_view bytes) const {
  for (std::size_t i = 0; i + sizeof(std::uint64_t) <= bytes.size(); ++i) {
    std::uint64_t pattern = 0;
    std::memcpy(&pattern, bytes.data() + i, sizeof pattern);
    if (std::ranges::binary_search(patterns_, pattern)) return true;
  }
  return false;
}

namespace {

// The sign is dropped, since a number in a text may stand without it.
void add(const Numbers& numbers, std::set<double>& to) {
  for (const double number : numbers) {
    if (std::isfinite(number)) to.insert(std::abs(number));
  }
}

}  // namespace

Checks ExpectedValues::listening(const Checks& checks) {
  Checks listening;
  for (const auto& [id, check] : checks) {
    listening[id] = [this, check](const Program& program, const Variant& variant) {
      const Program heard = [&](const std::string& task, const Numbers& inputs) {
        const Numbers answer = program(task, inputs);
        const std::scoped_lock lock(mutex_);
        add(inputs, inputs_);
        add(answer, answers_);
        return answer;
      };
      return check(heard, variant);
    };
  }
  return listening;
}

std::vector<double> ExpectedValues::values() const {
  const std::scoped_lock lock(mutex_);
  std::vector<double> values;
  std::ranges::set_difference(answers_, inputs_, std::back_inserter(values));
  return values;
}

}  // namespace course
