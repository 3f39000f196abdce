// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "course/assignment.hpp"
#include "course/check.hpp"
#include "course/grading.hpp"
#include "course/sandbox.hpp"

namespace course {

/// The numbers that a program printed, separated by white space, of which nothing is believed.
/// Throws ProgramFailure for anything but finite decimal numbers; the message repeats none of it.
Numbers parse_answer(std::string_view text);

/// A built submission as the checks see it. A request is one run in the sandbox; the same request
/// again has the same answer, and a task that took too long once is not asked again.
class ProgramRun {
 public:
  /// Its files go beside the program.
  ProgramRun(const Limits& limits, const Built& built, Isolation isolation);

  /// Throws ProgramFailure if there is no answer, ToolError if the sandbox cannot be started.
  Numbers answer(const std::string& task, const Numbers& inputs);

 private:
  struct Answer {
    Numbers numbers;
    std::string failure;
  };
  Answer ask(const std::string& task, const Numbers& inputs);
  std::string failure_of(const JobEnd& end) const;

  Limits limits_;
  std::filesystem::path program_;
  Sandbox sandbox_;
  std::map<std::pair<std::string, Numbers>, Answer> answers_;
  std::map<std::string, std::string> given_up_;  ///< tasks that took too long, and the message
};

}  // namespace course
