#pragma once

#include <cmath>

#include "course/assignment/check.hpp"

namespace toy {

inline course::Checks public_checks() {
  using course::Outcome;
  return {{"root-square",
           [](const course::Program& program, const course::Variant& variant) {
             const double root = program("root", {variant("first")}).at(0);
             const bool holds = root > 0 && std::abs(root * root - variant("first")) < 1e-9;
             return holds ? Outcome{1, ""} : Outcome{0, "the square is another number"};
           }},
          {"mean-zeros", [](const course::Program& program, const course::Variant&) {
             const double mean = program("mean", {0, 0, 0}).at(0);
             return mean == 0 ? Outcome{1, ""} : Outcome{0, "the mean of zeros is not zero"};
           }}};
}

}  // namespace toy
