// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <set>
#include <vector>

#include "course/assignment/check.hpp"

namespace course {

/// Records what the checks ask the instructor's program and what it answers. These answers are
/// the values that a handout must not hold.
class ExpectedValues {
 public:
  /// The same checks, which now record in this object; it must outlive them.
  Checks listening(const Checks& checks);

  /// The answers, each once, without those that were also an input.
  std::vector<double> values() const;

 private:
  mutable std::mutex mutex_;
  std::set<double> inputs_, answers_;
};

}  // namespace course
