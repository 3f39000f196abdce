// SPDX-License-Identifier: GPL-3.0-or-later
// Checks, and functions with which they ask the student's program and count how many properties
// hold. This header is part of the handout, so it uses the standard library only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace judge {

/// The inputs of a task of the student's program, or its answer.
using Numbers = std::vector<double>;

/// The student's program as a function: returns the answer to a task with these inputs. Throws
/// NoAnswer if there is none.
using Program = std::function<Numbers(const std::string& task, const Numbers& inputs)>;

/// The student's program gave no valid answer. what() is the message for the student.
class NoAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The fraction of a check that holds, from 0 to 1, and a message for the student if it is less
/// than 1.
struct Outcome {
  double share = 0;
  std::string message;
};

/// Tests one property of the student's numbers. Its own numbers follow from a text: a student's id
/// for a public check, the salt for a hidden check; the nominal numbers from an empty text.
struct Check {
  std::string id;
  Outcome (*outcome)(const Program& program, const std::string& origin);
};

using Checks = std::vector<Check>;

/// The checks of one exercise.
struct Exercise {
  std::string id;
  Checks public_checks;  ///< students have their code
  Checks hidden_checks;  ///< empty in the handout
};

/// Returns the greatest magnitude of the finite numbers; 0 if there are none.
inline double greatest(const Numbers& numbers) {
  double found = 0;
  for (const double number : numbers) {
    if (std::isfinite(number)) found = std::max(found, std::abs(number));
  }
  return found;
}

/// Returns the answer to a task: exactly `count` numbers, of which at least one is finite and not
/// zero, since zeros have every symmetry. Throws NoAnswer for anything else.
///
/// Returns infinities as NaN. No comparison with a NaN holds, so it is wrong at its own place but
/// not elsewhere.
inline Numbers answer_of(const Program& program, const std::string& task, const Numbers& inputs,
                         std::size_t count) {
  Numbers numbers = program(task, inputs);
  if (numbers.size() != count) {
    throw NoAnswer("task " + task + ": the answer must have " + std::to_string(count) + " numbers");
  }
  if (greatest(numbers) == 0) throw NoAnswer("task " + task + ": no number is finite and not zero");
  for (double& number : numbers) {
    if (std::isinf(number)) number = std::numeric_limits<double>::quiet_NaN();
  }
  return numbers;
}

/// Whether |a − b| ≤ tolerance; false for a NaN or an infinity.
inline bool near(double a, double b, double tolerance) {
  return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) <= tolerance;
}

/// Multiplies each number by the factor.
inline Numbers times(double factor, Numbers numbers) {
  for (double& number : numbers) number *= factor;
  return numbers;
}

/// Appends the second list to the first.
inline Numbers joined(Numbers first, const Numbers& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Returns "name = number" with up to six digits, the place of a failure.
inline std::string at(const std::string& name, double number) {
  std::ostringstream text;
  text << name << " = " << number;
  return text.str();
}

/// Counts how many parts of a check hold. All parts have the same weight.
class Tally {
 public:
  /// `property` is a statement about correct numbers: "the slope at −x is minus that at x".
  explicit Tally(std::string property) : property_(std::move(property)) {}

  void part(bool holds, const std::string& where) {
    ++n_parts_;
    if (!holds) failed_.push_back(where);
  }

  /// Returns the fraction of the parts that hold, and the places of the first failures.
  Outcome outcome() const {
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

 private:
  std::string property_;
  std::size_t n_parts_ = 0;
  std::vector<std::string> failed_;
};

}  // namespace judge
