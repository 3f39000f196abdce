// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace literate {

/// An outside tool (gnuplot, latexmk, pdflatex) is missing or failed.
///
/// what() carries the tool's own message with its file and line. The program answers it with
/// exit code 3.
class ToolError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A source file is not marked as it must be; what() is «file:line: message». Exit code 2.
class SourceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or folder cannot be read or written; what() names it. Exit code 2.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace literate
