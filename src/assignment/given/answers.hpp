// SPDX-License-Identifier: GPL-3.0-or-later
// What all checks share: they ask the student's program and count how much holds. This header is
// part of the handout, so it uses the standard library only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "course/assignment/check.hpp"

namespace assignment {

using course::Numbers;
using course::Outcome;
using course::Program;
using course::Variant;

/// The answer of a task: exactly `count` numbers, at least one of which is finite and not zero
/// (zeros have every symmetry there is).
///
/// Throws for anything else, and guarded() turns that into share 0 and a message. A NaN or an
/// infinity among other numbers is returned as NaN, with which no comparison holds. Passes on what
/// the program itself throws (course::ProgramFailure).
Numbers nonzero_answer(const Program& program, const std::string& task, const Numbers& inputs,
                       std::size_t count);

/// The same checks, which give share 0 and a message where nonzero_answer throws.
course::Checks guarded(course::Checks checks);

/// Counts the parts of a check that hold. Each part counts the same.
class Tally {
 public:
  /// `property` completes «does not hold at …»: "g(−x) = −g(x)".
  explicit Tally(std::string property) : property_(std::move(property)) {}

  void part(bool holds, const std::string& where);

  /// The share of the parts that hold, and where the first of the others are.
  Outcome outcome() const;

 private:
  std::string property_;
  std::size_t n_parts_ = 0;
  std::vector<std::string> failed_;
};

/// «name = number» with up to six digits, to say where a part failed.
std::string at(const std::string& name, double number);

/// Whether |a − b| ≤ tolerance; false for a NaN or an infinity.
bool near(double a, double b, double tolerance);

/// The greatest magnitude among the finite numbers; 0 if there is none.
double greatest(const Numbers& numbers);

/// Allows for a few roundings and for the digits that a sum of logarithms loses near the load.
inline constexpr double roundings = 1e-9;

/// Each number times the factor.
Numbers times(double factor, Numbers numbers);

/// The second list appended to the first.
Numbers joined(Numbers first, const Numbers& second);

}  // namespace assignment
