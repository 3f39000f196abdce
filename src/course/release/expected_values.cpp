// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/expected_values.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace course {
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
