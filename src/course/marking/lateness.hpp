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
  int days = 0;             ///< days begun since the deadline
  double percent = 0;       ///< percentage of the points reached that is deducted
  bool is_refused = false;  ///< later than the policy allows: nothing counts
};

/// A time of RFC 3339 such as 2027-01-15T23:59:00+01:00; fractions of a second are dropped. Throws
/// sys::SourceError for anything else.
Time parse_time(const std::string& text);

/// The lateness of a submission; one without a time is on time.
Lateness lateness(const Assignment& assignment, const std::optional<Time>& submitted);

}  // namespace course
