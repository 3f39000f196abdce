// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

#include "judge/check.hpp"

namespace judge {

/// The student's program in a separate process. Questions and answers are lines of text. Nothing
/// else that the program prints or writes has an effect, nor has its exit code.
///
/// A question gets no answer if the program crashes, hangs or writes anything but numbers. The
/// program is then restarted, at most twice. The command that starts it should limit its processor
/// time. The limits of wall-clock time here are much longer, so that a busy machine costs no
/// points.
class StudentProgram {
 public:
  /// `seconds` is the time limit for all questions. One question can use up half of it at most.
  StudentProgram(std::vector<std::string> command, double seconds);
  StudentProgram(const StudentProgram&) = delete;
  StudentProgram& operator=(const StudentProgram&) = delete;
  ~StudentProgram();

  /// Returns the answer to a question; asks a repeated question only once. Throws NoAnswer.
  Numbers answer(const std::string& task, const Numbers& inputs);

 private:
  struct Answer {
    Numbers numbers;
    std::string failure;  ///< empty if there is an answer
  };
  Answer ask(const std::string& question);
  std::string read_line();
  std::string reason_of_exit() const;
  void start();
  void stop();

  std::vector<std::string> command_;
  double patience_;      // seconds for a question
  double seconds_left_;  // for all further questions
  int n_starts_left_ = 3;
  pid_t process_ = -1;
  int channel_ = -1;
  std::map<std::string, Answer> known_;  ///< by question
};

/// Reads a line of decimal numbers separated by blanks; "nan" and "inf" are numbers. Throws
/// NoAnswer for anything else and for an empty line.
Numbers numbers_of_line(const std::string& line);

}  // namespace judge
