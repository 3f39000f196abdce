// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "course/assignment/check.hpp"
#include "course/marking/build.hpp"

namespace course {

/// The numbers that a program printed, separated by white space, of which nothing is believed.
/// Throws ProgramFailure for anything but finite decimal numbers; the message repeats none of it.
Numbers parse_answer(std::string_view text);

/// A built submission as the checks see it. A request is two runs in the sandbox, which must agree;
/// the same request again has the same answer. A task that took too long once is not asked again,
/// and nothing is after all runs together took Limits::submission_seconds.
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
  Answer ask_once(const std::string& task, const Numbers& inputs);
  JobEnd run(const std::string& task, const Numbers& inputs);
  std::string failure_of(const JobEnd& end) const;

  Limits limits_;
  std::filesystem::path program_;
  Sandbox sandbox_;
  std::map<std::pair<std::string, Numbers>, Answer> answers_;
  std::map<std::string, std::string> given_up_;  ///< tasks that took too long, and the message
  std::chrono::duration<double> time_{};         ///< of all runs so far
};

}  // namespace course
