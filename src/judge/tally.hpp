// SPDX-License-Identifier: GPL-3.0-or-later
// What checks are written with: they ask the student's program and count how much holds. This
// header is part of the handout, so it uses the standard library only.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "judge/check.hpp"

namespace judge {

/// The answer to a task: exactly `count` numbers, at least one of which is finite and not zero
/// (zeros have every symmetry there is). Throws NoAnswer for anything else.
///
/// A NaN or an infinity among other numbers is returned as NaN, for which no comparison holds: it
/// is wrong at its place and nowhere else.
Numbers answer_of(const Program& program, const std::string& task, const Numbers& inputs,
                  std::size_t count);

/// Counts how many parts of a check hold. All parts count the same.
class Tally {
 public:
  /// `property` is a sentence that holds if the numbers are right: "the slope at −x is minus that
  /// at x".
  explicit Tally(std::string property) : property_(std::move(property)) {}

  void part(bool holds, const std::string& where);

  /// The share of the parts that hold, and where the first of the others are.
  Outcome outcome() const;

 private:
  std::string property_;
  std::size_t n_parts_ = 0;
  std::vector<std::string> failed_;
};

/// "name = number" with up to six digits: where a part failed.
std::string at(const std::string& name, double number);

/// Whether |a − b| ≤ tolerance; false for a NaN or an infinity.
bool near(double a, double b, double tolerance);

/// The greatest magnitude among the finite numbers; 0 if there is none.
double greatest(const Numbers& numbers);

/// Each number times the factor.
Numbers times(double factor, Numbers numbers);

/// The second list appended to the first.
Numbers joined(Numbers first, const Numbers& second);

}  // namespace judge
