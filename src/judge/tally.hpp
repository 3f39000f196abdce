// SPDX-License-Identifier: GPL-3.0-or-later
// Functions for checks: they ask the student's program and count how many properties hold. This
// header is part of the handout, so it uses the standard library only.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "judge/check.hpp"

namespace judge {

/// Returns the answer to a task: exactly `count` numbers, of which at least one is finite and not
/// zero, since zeros have every symmetry. Throws NoAnswer for anything else.
///
/// Returns infinities as NaN. No comparison with a NaN holds, so it is wrong at its own place but
/// not elsewhere.
Numbers answer_of(const Program& program, const std::string& task, const Numbers& inputs,
                  std::size_t count);

/// Counts how many parts of a check hold. All parts have the same weight.
class Tally {
 public:
  /// `property` is a statement about correct numbers: "the slope at −x is minus that at x".
  explicit Tally(std::string property) : property_(std::move(property)) {}

  void part(bool holds, const std::string& where);

  /// Returns the fraction of the parts that hold, and the places of the first failures.
  Outcome outcome() const;

 private:
  std::string property_;
  std::size_t n_parts_ = 0;
  std::vector<std::string> failed_;
};

/// Returns "name = number" with up to six digits, the place of a failure.
std::string at(const std::string& name, double number);

/// Whether |a − b| ≤ tolerance; false for a NaN or an infinity.
bool near(double a, double b, double tolerance);

/// Returns the greatest magnitude of the finite numbers; 0 if there are none.
double greatest(const Numbers& numbers);

/// Multiplies each number by the factor.
Numbers times(double factor, Numbers numbers);

/// Appends the second list to the first.
Numbers joined(Numbers first, const Numbers& second);

}  // namespace judge
