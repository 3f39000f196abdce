// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// What LaTeX made of a report.
struct Typeset {
  std::string pdf;      ///< empty if there is none
  std::string log;      ///< as LaTeX wrote it; not for anybody's eyes before shown()
  std::string problem;  ///< what the log cannot tell: a limit that was exceeded; empty if none was
  bool has_errors = false;  ///< whether LaTeX met any, whatever the log tells
};

/// Runs gnuplot and pdfLaTeX on folders of reports, in the sandbox and within
/// Limits::report_seconds, memory_mb, processes and submission_mb. They see the system's TeX and
/// fonts and the report's folder, write nothing but their product; what LaTeX starts, to make a
/// font for instance, is in the sandbox too.
class ReportTypesetting {
 public:
  /// `work` is a folder for its own files. Tries both programs, and throws ToolError with what they
  /// say if one does not work on this machine.
  ReportTypesetting(const Assignment& assignment, const std::filesystem::path& work,
                    Isolation isolation);

  /// Draws generated/`name`.pdf by the script `name`.gp of a folder that everybody can read.
  /// It may take `seconds_left`, of which what it takes is subtracted. Returns a line that says
  /// what failed; empty if nothing did.
  std::string draw(const std::filesystem::path& folder, const std::string& name,
                   double& seconds_left) const;

  /// Typesets report.tex of such a folder, which is not written to, in two passes, as the handout
  /// does. The PDF is of the assignment's deadline.
  Typeset typeset(const std::filesystem::path& folder) const;

 private:
  struct Product;
  Product run(const std::filesystem::path& folder, const std::string& script,
              const std::vector<std::string>& arguments, int seconds) const;
  Product latex(const std::filesystem::path& folder) const;
  void require_tools() const;

  Assignment assignment_;
  std::filesystem::path work_;
  Sandbox sandbox_;
};

}  // namespace course
