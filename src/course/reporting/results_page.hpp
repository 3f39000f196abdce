// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"
#include "course/reporting/mistakes.hpp"
#include "course/reporting/statistics.hpp"

namespace course {

/// A page for the instructor, one file: who is missing, the marks' histogram, the statistics of
/// each check, and the mistakes that were met. It holds names of students and of hidden checks.
std::string results_html(const Assignment& assignment, const ClassMarks& marks,
                         const ClassStatistics& statistics, const std::vector<Met>& met);

}  // namespace course
