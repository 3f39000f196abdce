// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "course/assignment/check.hpp"
#include "course/marking/build.hpp"

namespace course {

/// The numbers that a program printed, separated by white space; an infinity is a NaN, with which
/// no comparison holds. Throws ProgramFailure for anything else; the message repeats nothing of
/// what the program printed, not even how much it was.
Numbers parse_answer(std::string_view text);

/// Whether two answers to one question are the same but for the order in which threads added up:
/// relatively to 1e-10, or to 1e-13 of the largest of the numbers, which are of one kind but for
/// the first `n_single` (Assignment::single_numbers).
bool is_same_answer(const Numbers& first, const Numbers& second, std::size_t n_single);

/// What went wrong with a program, such as «took longer than 5 s» by Limits::run_seconds; empty if
/// nothing did. Neither its status nor its signal is told, by which it could report what it knows.
std::string failure_of(const Limits& limits, const JobEnd& end);

/// Runs a program in the sandbox on a text, within the limits. Input, output and errors are files
/// beside it, `input`, `output` and `errors`.
JobEnd run_on_text(const Sandbox& sandbox, const Limits& limits,
                   const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   const std::string& text, int seconds);

/// A built submission as the checks see it. Each question is asked in two runs in the sandbox,
/// which must agree but for roundings, since threads add up in any order. If both are quick, the
/// second run computes the task's last question first, of which a function must not remember
/// anything. The same question again gets the same answer. A task that took too long is not asked
/// again. No question is asked once compiling and all runs together took
/// Limits::submission_seconds, nor one of an exercise whose own program took its share of them, so
/// that a slow exercise leaves the others their time.
class ProgramRun {
 public:
  /// Writes its files beside the program.
  ProgramRun(const Assignment& assignment, const Built& built, Isolation isolation);

  /// From now on this program answers, beside the first one.
  void use(const std::filesystem::path& program) { program_ = std::filesystem::absolute(program); }

  /// Throws ProgramFailure if there is no answer, ToolError if the sandbox cannot be started.
  Numbers answer(const std::string& task, const Numbers& inputs);

  /// Of compiling and all runs so far, as JobEnd::seconds.
  double seconds() const { return seconds_; }

  /// Whether any question of this task was asked.
  bool was_asked(const std::string& task) const;

 private:
  struct Answer {
    Numbers numbers;
    std::string failure;
    double seconds = 0;
  };
  Answer ask(const std::string& task, const Numbers& inputs);
  Answer ask_once(const std::string& task, const Numbers& inputs, const Numbers& before);
  JobEnd run(const std::string& task, const Numbers& inputs, const Numbers& before);
  std::string failure_of(const JobEnd& end) const;
  std::string excess() const;
  std::string with_errors(const std::string& failure) const;

  Limits limits_;
  std::map<std::string, std::size_t> single_numbers_;
  int exercise_seconds_;
  std::filesystem::path common_, program_;
  bool tells_errors_;
  Sandbox sandbox_;
  std::map<std::tuple<std::filesystem::path, std::string, Numbers>, Answer> answers_;
  /// The last quick question of a program's task.
  std::map<std::pair<std::filesystem::path, std::string>, Numbers> last_;
  std::map<std::string, std::string> given_up_;  ///< tasks that took too long, and the message
  double seconds_;
  std::map<std::filesystem::path, double> seconds_of_;  ///< by program
};

}  // namespace course
