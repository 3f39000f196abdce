// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"
#include "course/marking/mark.hpp"

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
/// `style` is the gnuplot file that the figures of the assignment's sheet share, which has the
/// colours and the grid; an assignment without one gets gnuplot's own. Throws ToolError if gnuplot
/// is missing.
std::string svg_of(const Curve& curve, const std::filesystem::path& style);

/// The style of an assignment's figures: figures/style.gp in its folder.
std::filesystem::path style_of(const Assignment& assignment);

/// A page for the student, one file that a phone can show, with points, compile errors,
/// messages and `pictures` (SVG elements).
std::string feedback_html(const Assignment& assignment, const Graded& graded,
                          const std::vector<std::string>& pictures);

/// The file results.json for Gradescope, with one test for each check; hidden checks have no
/// message.
std::string gradescope_json(const Assignment& assignment, const Graded& graded);

}  // namespace course
