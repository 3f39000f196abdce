// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"

namespace course {

/// The marks of a class as a table: a header and a line for each student.
std::string marks_csv(const Assignment& assignment, const ClassMarks& marks);

}  // namespace course
