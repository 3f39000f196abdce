// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "course/assignment/check.hpp"

namespace course {

/// A curve for the feedback page, which the student's own program computed. It holds no answer.
struct Curve {
  std::string title;
  std::string x_label;
  std::string y_label;
  Numbers x;
  Numbers y;  ///< as many as x
};

/// Computes the curves of a submission by calling its program; a curve that fails is left out.
using Curves = std::function<std::vector<Curve>(const Program&, const Variant&)>;

/// A picture as an SVG element, drawn by gnuplot; empty if gnuplot cannot draw these numbers.
/// Throws ToolError if gnuplot is missing.
std::string svg_of(const Curve& curve);

}  // namespace course
