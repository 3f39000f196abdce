// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "course/marking/mark.hpp"

namespace course {

/// Gradescope's results.json: a test a check, hidden ones without their message.
std::string gradescope_json(const Assignment& assignment, const Graded& graded);

/// The same as JUnit's XML.
std::string junit_xml(const Assignment& assignment, const Graded& graded);

}  // namespace course
