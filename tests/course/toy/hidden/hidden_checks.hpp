// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "course/assignment/check.hpp"

namespace toy {

inline bool is_reference(double answer, double reference) {
  return std::abs(answer - reference) <= 1e-9 * reference;
}

inline course::Checks hidden_checks() {
  using course::Outcome;
  return {{"root-reference",
           [](const course::Program& program, const course::Variant& variant) {
             const auto roots = program("root", {variant("first"), variant("second")});
             const bool first = is_reference(roots.at(0), std::sqrt(variant("first")));
             const bool second = is_reference(roots.at(1), std::sqrt(variant("second")));
             return Outcome{0.5 * (first + second), "differs"};
           }},
          {"mean-reference", [](const course::Program& program, const course::Variant& variant) {
             const double first = variant("first"), second = variant("second");
             const auto mean = program("mean", {first, second, 2.3857142});
             const double reference = (first + second + 2.3857142) / 3;
             return Outcome{is_reference(mean.at(0), reference) ? 1.0 : 0.0, "differs"};
           }}};
}

}  // namespace toy
