// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge/tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace judge {
namespace {

bool is_finite(double number) {
  return std::isfinite(number);
}

}  // namespace

Numbers answer_of(const Program& program, const std::string& task, const Numbers& inputs,
                  std::size_t count) {
  Numbers numbers = program(task, inputs);
  if (numbers.size() != count) {
    throw NoAnswer("task " + task + ": the answer must have " + std::to_string(count) + " numbers");
  }
  if (std::none_of(numbers.begin(), numbers.end(), is_finite)) {
    throw NoAnswer("task " + task + ": no number is finite");
  }
  if (greatest(numbers) == 0) throw NoAnswer("task " + task + ": all finite numbers are zero");
  // No comparison with a NaN holds, but some comparisons with an infinity do.
  std::replace_if(
      numbers.begin(), numbers.end(), [](double number) { return !is_finite(number); },
      std::numeric_limits<double>::quiet_NaN());
  return numbers;
}

void Tally::part(bool holds, const std::string& where) {
  ++n_parts_;
  if (!holds) failed_.push_back(where);
}

Outcome Tally::outcome() const {
  if (failed_.empty()) return {1, ""};
  constexpr std::size_t most_shown = 3;
  std::ostringstream message;
  message << property_ << ": does not hold in " << failed_.size() << " of " << n_parts_
          << " cases (";
  for (std::size_t i = 0; i < std::min(failed_.size(), most_shown); ++i) {
    message << (i == 0 ? "" : "; ") << failed_[i];
  }
  message << (failed_.size() > most_shown ? "; …)" : ")");
  const auto n_held = static_cast<double>(n_parts_ - failed_.size());
  return {n_held / static_cast<double>(n_parts_), message.str()};
}

std::string at(const std::string& name, double number) {
  std::ostringstream text;
  text << name << " = " << number;
  return text.str();
}

bool near(double a, double b, double tolerance) {
  return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) <= tolerance;
}

double greatest(const Numbers& numbers) {
  double found = 0;
  for (const double number : numbers) {
    if (is_finite(number)) found = std::max(found, std::abs(number));
  }
  return found;
}

Numbers times(double factor, Numbers numbers) {
  for (double& number : numbers) number *= factor;
  return numbers;
}

Numbers joined(Numbers first, const Numbers& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace judge
