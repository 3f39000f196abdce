// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace course {

/// The texts of a report that are held against each other.
struct ReportTexts {
  std::string report;    ///< report.tex
  std::string computed;  ///< numbers.tex that the student's functions give; empty if there is none
  std::string log;       ///< what LaTeX said of report.tex
};

// What a marker should look at, «report/report.tex:line:column: what». Texts of any bytes are
// taken.

/// In this order: bytes that are no UTF-8; what LaTeX says; commands of numbers.tex that the report
/// defines anew; commands that an ordinary report does not need, and by which one could hide
/// something from the other findings.
std::vector<std::string> findings_of_commands(const ReportTexts& texts);

/// Typed numbers, by the engine's lint.
std::vector<std::string> findings_of_numbers(const ReportTexts& texts);

}  // namespace course
