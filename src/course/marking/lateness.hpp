// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "course/assignment/assignment.hpp"

namespace course {

using Time = std::chrono::sys_seconds;

/// How late a submission is, and how many of its points that costs.
struct Lateness {
  int days = 0;             ///< days begun since the deadline and the minutes of grace
  int slip_days = 0;        ///< of these, days that cost nothing and are used up by it
  double percent = 0;       ///< percentage of the points reached that is deducted
  bool is_refused = false;  ///< later than the policy allows, slip days aside: nothing counts
};

/// A time of RFC 3339 such as 2027-01-15T23:59:00+01:00; fractions of a second are dropped. Throws
/// sys::SourceError for anything else.
Time parse_time(const std::string& text);

/// The lateness of a submission; one without a time is on time. `slip_days` are those that the
/// student has left; without a number they are as many as the assignment allows. None is used up by
/// a submission that is too late all the same.
Lateness lateness(const Assignment& assignment, const std::optional<Time>& submitted,
                  const std::optional<int>& slip_days = {});

}  // namespace course
