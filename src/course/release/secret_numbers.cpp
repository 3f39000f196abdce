// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/secret_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>

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

}  // namespace

SecretNumbers::SecretNumbers(const std::vector<double>& numbers) {
  for (const double number : numbers) {
    if (!std::isfinite(number) || !is_telling(digits_of(number, least_digits))) continue;
    const std::string all = digits_of(number, 17);
    for (std::size_t n = least_digits; n <= most_digits; ++n) {
      digits_.insert(all.substr(0, n));
      digits_.insert(digits_of(number, n));
    }
    patterns_.push_back(std::bit_cast<std::uint64_t>(number));
    patterns_.push_back(std::bit_cast<std::uint64_t>(-number));
  }
  std::ranges::sort(patterns_);
}

bool SecretNumbers::is_secret(const std::string& printed, double number) const {
  std::string digits = printed.substr(0, printed.find_first_of("eE"));
  std::erase(digits, '.');
  digits.erase(0, digits.find_first_not_of('0'));
  if (digits.size() < least_digits) return false;
  const std::size_t n = std::min(digits.size(), most_digits);
  const std::string cut = digits.substr(0, n);
  return is_telling(cut) && (digits_.contains(cut) || digits_.contains(digits_of(number, n)));
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
    double number = 0;
    const char* const begin = text.data() + at;
    const std::string printed(begin, std::from_chars(begin, text.data() + text.size(), number).ptr);
    at += printed.size();
    const bool ends = at == text.size() || !continues_word(text[at]);
    if (ends && is_secret(printed, number)) found.push_back(printed);
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
