// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace block {

/// A point of a line towards which the mesh becomes finer, and the size of the elements beside it.
struct GradedPoint {
  double position;
  double smallest;  ///< length of the element on either side, > 0
};

/// The element boundaries of a line that is graded geometrically towards each of `points`.
///
/// Between neighbouring points the line is halved and each half graded to its end: the element
/// beside the end is `smallest` long (or the whole half, if that is shorter) and the distance of
/// the boundaries from the end grows by at most 1/ratio, 0 < ratio < 1, from each to the next. A
/// point singularity then has the same strength, seen from any element, which lets high order
/// converge exponentially. `points` rise strictly, two or more; they are the line's ends and what
/// is between.
std::vector<double> graded_lines(const std::vector<GradedPoint>& points, double ratio);

}  // namespace block
