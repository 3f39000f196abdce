// SPDX-License-Identifier: GPL-3.0-or-later
// program TASK: questions on standard input, the last one's answer on the channel for answers.
#include <iostream>
#include <string_view>
#include <vector>

#include "course/assignment/answer_channel.hpp"
#include "toy.hpp"

int main(int argc, char** argv) {
  const std::string_view task = argc == 2 ? argv[1] : "";
  std::vector<double> answer;
  for (const std::vector<double>& inputs : course::read_questions(std::cin)) {
    answer.clear();
    if (task == "square") {
      for (const double x : inputs) answer.push_back(square(x));
    } else if (task == "sum") {
      answer.push_back(sum(inputs));
    } else {
      return 2;
    }
  }
  return course::write_answer(answer) ? 0 : 2;
}
