// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"
#include "course/marking/submission.hpp"
#include "course/reporting/report_typesetting.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// A report to be made ready for a marker, and what that takes.
struct ReportTask {
  Report report;
  Files exercises;
  Variant variant;
  std::filesystem::path toolkit;
  Isolation isolation = Isolation::sandbox;
};

/// What a marker gets of a report, by name: report.tex and report.pdf as they were handed in;
/// typeset.pdf, the report with the numbers and drawings that the student's functions give, and its
/// typeset.log; these numbers, numbers.tex; and findings.txt, a line for each thing to look at,
/// empty if there is none. What cannot be made is left out, and findings.txt says why. The same
/// submission gives the same bytes. `scratch` is an empty folder. Throws ToolError if the tools
/// cannot work, never because of what was submitted.
Files marked_report(const Assignment& assignment, const ReportTypesetting& typesetting,
                    const ReportTask& task, const std::filesystem::path& scratch);

/// The names under which markers see who handed in, by student or group: 'report-' and ten
/// hexadecimal digits of SHA-256 of seed and student or group. Who does not know the seed cannot
/// tell one from the other. Throws std::logic_error if two had one name, which a class of thousands
/// never meets.
std::map<std::string, std::string> anonymous_names(const std::vector<std::string>& units,
                                                   const std::string& seed);

}  // namespace course
