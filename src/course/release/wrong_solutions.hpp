// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "course/assignment/assignment.hpp"

namespace course {

/// One place of the solution that is changed.
struct Change {
  std::string file;  ///< the file of an exercise
  std::string before;
  std::string after;
};

/// The instructor's solution with one mistake, and the points that it must reach with the
/// nominal numbers; how many points a mistake costs may depend on the variant.
struct WrongSolution {
  std::string id;
  std::string says;             ///< what is wrong, such as "a sign is lost"
  std::vector<Change> changes;  ///< no file twice
  double points = 0;
};

/// Reads the [[wrong]] tables of folder/wrong_solutions.toml. A table has file, before and after,
/// or several of these in tables [[wrong.change]]. Throws config::Error «file:line:column: …», for
/// instance if `before` does not stand exactly once in the solution.
std::vector<WrongSolution> read_wrong_solutions(const Assignment& assignment,
                                                const Files& solution);

/// The text of wrong_solutions.toml with other points, one for each [[wrong]] in their order.
/// Nothing else changes.
std::string with_points(std::string_view text, const std::vector<double>& points);

/// The solution with the mistake in it, at all of its places.
Files with_mistake(Files solution, const WrongSolution& wrong);

}  // namespace course
