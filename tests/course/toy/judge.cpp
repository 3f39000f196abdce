// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of the toy assignment, with hidden checks.
#include "toy_checks.hpp"

namespace {

using judge::Outcome;
using judge::Program;

Outcome square_is_right(const Program& program, const std::string&) {
  judge::Tally tally("the square is right");
  const judge::Numbers x = {1.5, -2, 3, 7};
  const judge::Numbers found = judge::answer_of(program, "square", x, x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    tally.part(judge::near(found[i], x[i] * x[i], 1e-12), judge::at("x", x[i]));
  }
  return tally.outcome();
}

Outcome sum_is_right(const Program& program, const std::string&) {
  const double found = judge::answer_of(program, "sum", {0.25, 4}, 1)[0];
  return toy::holds(found == 4.25, "the sum is wrong");
}

Outcome cube_is_right(const Program& program, const std::string&) {
  const judge::Numbers found = judge::answer_of(program, "cube", {2, -3}, 2);
  return toy::holds(found == judge::Numbers{8, -27}, "the cube is wrong");
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<judge::Exercise> exercises = toy::exercises();
  exercises[0].hidden_checks = {{"square-right", square_is_right}};
  exercises[1].hidden_checks = {{"sum-right", sum_is_right}};
  exercises[2].hidden_checks = {{"cube-right", cube_is_right}};
  return judge::run(argc, argv, exercises, toy::numbers);
}
