// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <set>
#include <vector>

#include "course/assignment/check.hpp"

namespace course {

/// Listens to what checks ask the instructor's program and what it answers: the values that a
/// handout must not hold.
class ExpectedValues {
 public:
  /// The same checks, listened to; they refer to this object.
  Checks listening(const Checks& checks);

  /// The answers, each once, without those that an input was too.
  std::vector<double> values() const;

 private:
  mutable std::mutex mutex_;
  std::set<double> inputs_, answers_;
};

}  // namespace course
