// SPDX-License-Identifier: GPL-3.0-or-later
// The types of checks. This header is part of the handout, so it uses the standard library only.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
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

/// Tests one property of the student's numbers.
struct Check {
  std::string id;
  std::function<Outcome(const Program& program)> outcome;
};

/// The checks of one exercise.
struct Exercise {
  std::string id;
  std::vector<Check> public_checks;  ///< students have their code
  std::vector<Check> hidden_checks;  ///< empty in the handout
};

}  // namespace judge
