// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/assignment/variant.hpp"

namespace course {

/// What goes into a task of the student's program, and what comes out of it.
using Numbers = std::vector<double>;

/// The student's program: gives a task its inputs and returns its answer. Throws ProgramFailure if
/// there is none.
using Program = std::function<Numbers(const std::string& task, const Numbers& inputs)>;

/// The student's program gave no answer: it crashed, took too long, or printed no numbers. what()
/// is for the student.
class ProgramFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How much of a check holds, from 0 to 1, and what to tell the student where that is less than 1.
struct Outcome {
  double share = 0;
  std::string message;
};

/// Tries one property of the student's numbers. Part of the handout where it is public, so only the
/// standard library is used.
using Check = std::function<Outcome(const Program& program, const Variant& variant)>;

using Checks = std::map<std::string, Check>;  ///< by id

}  // namespace course
