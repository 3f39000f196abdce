// SPDX-License-Identifier: GPL-3.0-or-later
// How a student's program is asked and answers. This header is part of the handout and is included
// by the file with main() alone.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <istream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace course {

/// Where answers are written: what was standard output when the program began.
inline int answer_descriptor = -1;

/// Keeps answers apart from what the student's functions print, which goes to standard error from
/// now on: a line that was left over from the search for an error does no harm. This runs before
/// the constructors of any static object, once for each file that includes this header.
__attribute__((constructor(101))) inline void keep_answers_apart() {
  if (answer_descriptor >= 0) return;
  answer_descriptor = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
}

/// The numbers of each question; a ';' stands between two of them. Only the last one is to be
/// answered: the others are computed before it in the same process, in which no function may
/// remember anything of them that changes its answer.
inline std::vector<std::vector<double>> read_questions(std::istream& in) {
  std::vector<std::vector<double>> questions(1);
  while (in >> std::ws && in.peek() != std::istream::traits_type::eof()) {
    if (in.peek() == ';') {
      in.get();
      questions.emplace_back();
      continue;
    }
    double number = 0;
    if (!(in >> number)) {
      throw std::invalid_argument("standard input holds something that is no number");
    }
    questions.back().push_back(number);
  }
  return questions;
}

/// Writes an answer, a number in each line, with all digits of a double. Returns whether it could
/// be written.
inline bool write_answer(const std::vector<double>& numbers) {
  bool is_written = true;
  for (const double number : numbers) {
    is_written = is_written && ::dprintf(answer_descriptor, "%.17g\n", number) > 0;
  }
  return is_written;
}

/// The numbers of a line, «inf» and «nan» among them.
inline std::vector<double> numbers_in(std::istream& words) {
  std::vector<double> numbers;
  for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}

/// Answers questions one after the other, each a line «TASK number number …», by `run`, which takes
/// a task and its inputs. Each answer is a line, which is empty if there is none. So programs are
/// asked what a student's own tests ask.
template <class Run>
void answer_lines(std::istream& in, const Run& run) {
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string task;
    words >> task;
    const std::vector<double> inputs = numbers_in(words);
    std::vector<double> answer;
    try {
      answer = run(task, inputs);
    } catch (const std::exception&) {
      answer.clear();
    }
    for (const double number : answer) ::dprintf(answer_descriptor, "%.17g ", number);
    ::dprintf(answer_descriptor, "\n");
  }
}

}  // namespace course
