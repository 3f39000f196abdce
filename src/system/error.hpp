// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace sys {

/// The exit status of a program.
enum class ExitCode : int {
  success = 0,
  failed = 1,       ///< a check or a claim did not hold, or a computation failed
  bad_input = 2,    ///< a flag, a file or a folder that the user gave is wrong
  tool_failed = 3,  ///< gnuplot or a different outside tool is missing or failed
};

/// An error that the user can do something about. what() is the message for standard error, without
/// the program's name; exit_code() is the program's exit status if nothing handles the error.
class Error : public std::runtime_error {
 public:
  Error(ExitCode exit_code, const std::string& message)
      : std::runtime_error(message), exit_code_(exit_code) {}

  ExitCode exit_code() const { return exit_code_; }

 private:
  ExitCode exit_code_;
};

/// Something that the user gave is wrong.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::bad_input, message) {}
};

/// A file or folder cannot be read or written; what() names it.
class OutputError : public InputError {
 public:
  using InputError::InputError;
};

/// A different program, such as gnuplot, is missing or failed.
class ToolError : public Error {
 public:
  explicit ToolError(const std::string& message) : Error(ExitCode::tool_failed, message) {}
};

/// A computation did not reach its result although its input was allowed.
class ComputationError : public Error {
 public:
  explicit ComputationError(const std::string& reason)
      : Error(ExitCode::failed, "the computation failed: " + reason) {}
};

}  // namespace sys
