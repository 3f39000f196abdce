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

/// What a student's functions give for the report.
struct ReportNumbers {
  Files files;                        ///< by name, such as "numbers.tex"
  std::vector<std::string> problems;  ///< a line each: what does not compile, run or come out
};

/// Compiles the handout's report/figures.cpp with the student's numbers and files, and runs it in
/// the sandbox, as `make figures` of the handout does; a second run must give the same. Of the
/// files that it leaves numbers.tex and NAME.dat are taken. `toolkit` is the toolkit's folder,
/// `scratch` an empty one. The program may take `seconds_left`, of which what it takes is
/// subtracted. Nothing is computed if the handout has no such program. Throws ToolError
/// if compiler or sandbox cannot work, never because of what was submitted.
ReportNumbers report_numbers(const Assignment& assignment, const std::filesystem::path& toolkit,
                             const Files& exercises, const Variant& variant,
                             const std::filesystem::path& scratch, Isolation isolation,
                             double& seconds_left);

/// The texts of a report that are held against each other.
struct ReportTexts {
  std::string report;    ///< report.tex
  std::string computed;  ///< numbers.tex that the student's functions give; empty if there is none
  std::string log;       ///< what LaTeX said of report.tex
};

// What a marker should look at, «report/report.tex:line:column: what». Texts of any bytes are
// taken.

/// In this order: bytes that are no UTF-8; what LaTeX says; definitions of commands that
/// numbers.tex has or that show what is computed, and of those whose name is not written there;
/// commands that an ordinary report does not need, and by which one could hide something from the
/// other findings.
std::vector<std::string> findings_of_commands(const ReportTexts& texts);

/// Typed numbers, by the engine's lint.
std::vector<std::string> findings_of_numbers(const ReportTexts& texts);

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
