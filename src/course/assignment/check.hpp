// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/assignment/variant.hpp"

namespace course {

/// The inputs of a task of the student's program, or its answer.
using Numbers = std::vector<double>;

/// The student's program: it takes a task and its inputs and returns the answer. Throws
/// ProgramFailure if there is none.
using Program = std::function<Numbers(const std::string& task, const Numbers& inputs)>;

/// The student's program gave no answer, because it crashed, took too long, or printed no
/// numbers. what() is for the student.
class ProgramFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The part of a check that holds, from 0 to 1, and the message for the student if it is less than
/// 1.
struct Outcome {
  double share = 0;
  std::string message;
};

/// Tries one property of the student's numbers. This header is part of the handout, so it uses
/// the standard library only.
using Check = std::function<Outcome(const Program& program, const Variant& variant)>;

using Checks = std::map<std::string, Check>;  ///< by id

}  // namespace course
