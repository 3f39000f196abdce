// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace course {

/// The texts of a report that are held against each other.
struct ReportTexts {
  std::string report;     ///< report.tex
  std::string handed_in;  ///< the numbers.tex that was handed in; empty if there is none
  std::string computed;   ///< the one that the student's functions give; empty if there is none
  std::string log;        ///< what LaTeX said of report.tex
};

// What a marker should look at, «report/report.tex:line:column: what». Texts of any bytes are
// taken.

/// In this order: bytes that are no UTF-8; what LaTeX says, with the nearest name for an unknown
/// command, the line alone where the log tells no column; commands of numbers.tex that the report
/// defines anew; commands that an ordinary report does not need, and by which one could hide
/// something from the other findings.
std::vector<std::string> findings_of_commands(const ReportTexts& texts);

/// Typed numbers, by the engine's lint; and numbers that were handed in and differ from those
/// computed.
std::vector<std::string> findings_of_numbers(const ReportTexts& texts);

}  // namespace course
