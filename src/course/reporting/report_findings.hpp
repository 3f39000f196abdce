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

/// What a marker should look at, «report/report.tex:line:column: what», in this order: bytes that
/// are no UTF-8; what LaTeX says, with the nearest name for an unknown command; commands of
/// numbers.tex that the report defines anew; typed numbers, by the engine's lint; numbers that were
/// handed in and differ from those computed. The line stands alone where the log tells no column.
/// Texts of any bytes are taken.
std::vector<std::string> report_findings(const ReportTexts& texts);

}  // namespace course
