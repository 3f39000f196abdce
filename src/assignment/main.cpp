// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of this assignment, with public and hidden checks. The judge in the handout has only
// the public checks: report/assignment/template/provided/checks.cpp.
#include "exercise_list.hpp"
#include "judge/judge.hpp"

int main(int argc, char** argv) {
  return judge::run(argc, argv, assignment::exercises(), assignment::lines_of_numbers);
}
