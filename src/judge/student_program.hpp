// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

#include "judge/check.hpp"

namespace judge {

/// The student's program as a separate process, which is asked by lines and answers by lines.
/// Nothing else that it prints, writes or exits with counts.
///
/// A question has no answer if the program answers with anything but numbers, crashes or hangs. The
/// program is then started again, twice at most. The command that starts it is meant to limit its
/// processor time; the clock here is a far backstop, so that a busy machine costs nobody an answer.
class StudentProgram {
 public:
  /// `allowance` is how many seconds may be lost in questions without an answer: beyond that the
  /// program is not started again, and at zero it has less time for a question.
  StudentProgram(std::vector<std::string> command, double allowance);
  StudentProgram(const StudentProgram&) = delete;
  StudentProgram& operator=(const StudentProgram&) = delete;
  ~StudentProgram();

  /// The answer to a question, which is asked once only. Throws NoAnswer.
  Numbers answer(const std::string& task, const Numbers& inputs);

  double lost_seconds() const { return lost_seconds_; }  ///< in questions without an answer
  int n_answers() const { return n_answers_; }

 private:
  struct Answer {
    Numbers numbers;
    std::string failure;  ///< empty if there is an answer
  };
  Answer ask(const std::string& question);
  std::string read_line();
  std::string how_it_ended() const;
  void start();
  void stop();

  std::vector<std::string> command_;
  double allowance_;
  double lost_seconds_ = 0;
  int n_answers_ = 0;
  int n_starts_left_ = 3;
  pid_t process_ = -1;
  int channel_ = -1;
  std::map<std::string, Answer> known_;
};

/// The numbers of a line of decimal numbers with blanks between them; "nan" and "inf" are numbers.
/// Throws NoAnswer for anything else, and if there is none.
Numbers numbers_of_line(const std::string& line);

}  // namespace judge
