// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"

namespace course {

/// What the class tells about one check, of which each graded student has a share from 0 to 1.
struct ItemStatistics {
  std::string exercise;  ///< its id
  CheckEntry check;
  /// The mean share of its points, p of classical test theory: 1 for a check that everybody passes.
  double facility = 0;
  /// Pearson's correlation of its points with the sum of all other checks, the corrected item-total
  /// correlation: near 0 or below for a check that good and bad solutions pass alike. None if one
  /// of the two is the same for everybody.
  std::optional<double> discrimination;
  std::size_t n_full = 0;  ///< students who reached all of its points
  std::size_t n_none = 0;  ///< students who reached none of them
};

/// What is told about the marks of a class.
struct ClassStatistics {
  std::size_t n_graded = 0;
  double mean = 0;                ///< of the marks, as are the next four
  double standard_deviation = 0;  ///< with n − 1; 0 for a single mark
  double least = 0;
  double median = 0;
  double most = 0;
  std::vector<std::size_t>
      histogram;  ///< marks in each tenth of all points; the last has both ends
  /// Cronbach's α = k/(k − 1)·(1 − Σ var(item)/var(sum)) of the points before deductions. None for
  /// fewer than two checks or students, or if all sums are the same.
  std::optional<double> reliability;
  std::vector<ItemStatistics> items;  ///< in the assignment's order
};

/// The statistics of the students who have a mark; all zero if nobody has.
ClassStatistics statistics_of(const Assignment& assignment, const ClassMarks& marks);

/// A table with a line for each check.
std::string items_csv(const ClassStatistics& statistics);

}  // namespace course
