#pragma once

#include "judge/judge.hpp"

namespace toy {

using judge::Outcome;
using judge::Program;

inline Outcome holds(bool it_does, const std::string& message) {
  return it_does ? Outcome{1, ""} : Outcome{0, message};
}

// Asks for one number at a time, so that each is a separate question.
inline Outcome square_is_even(const Program& program, const std::string&) {
  judge::Tally tally("the square of −x is that of x");
  for (const double x : {1.5, 2.}) {
    const double right = judge::answer_of(program, "square", {x}, 1)[0];
    tally.part(judge::near(judge::answer_of(program, "square", {-x}, 1)[0], right, 0),
               judge::at("x", x));
  }
  return tally.outcome();
}

inline Outcome sum_commutes(const Program& program, const std::string&) {
  const double one = judge::answer_of(program, "sum", {1, 2}, 1)[0];
  return holds(judge::answer_of(program, "sum", {2, 1}, 1)[0] == one, "a + b is not b + a");
}

inline Outcome cube_agrees(const Program& program, const std::string&) {
  const double right = 3 * judge::answer_of(program, "square", {3}, 1)[0];
  return holds(judge::answer_of(program, "cube", {3}, 1)[0] == right,
               "the cube is not x times your square");
}

inline std::vector<judge::Exercise> exercises() {
  return {{"square", {{"square-even", square_is_even}}, {}},
          {"sum", {{"sum-commutes", sum_commutes}}, {}},
          {"cube", {{"cube-agrees", cube_agrees}}, {}}};
}

inline std::string numbers(const std::string& student) {
  return "young1 " + std::to_string(student.size()) + " Pa\n";
}

}  // namespace toy
