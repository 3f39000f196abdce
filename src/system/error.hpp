// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace sys {

/// The exit status of a program.
enum class ExitCode : int {
  success = 0,
  failed = 1,       ///< a check or a claim does not hold, or a computation failed
  bad_input = 2,    ///< a flag, a file or a folder of the user is wrong
  tool_failed = 3,  ///< an external tool such as gnuplot is missing or failed
};

/// An error that the user can act on. what() is the message for standard error, without the name of
/// the program; exit_code() is the exit code of the program if nothing handles the error.
class Error : public std::runtime_error {
 public:
  Error(ExitCode exit_code, const std::string& message)
      : std::runtime_error(message), exit_code_(exit_code) {}

  ExitCode exit_code() const { return exit_code_; }

 private:
  ExitCode exit_code_;
};

/// An input of the user is wrong.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::bad_input, message) {}
};

/// A file or folder cannot be read or written; what() names it.
class OutputError : public InputError {
 public:
  using InputError::InputError;
};

/// An external program such as gnuplot is missing or failed.
class ToolError : public Error {
 public:
  explicit ToolError(const std::string& message) : Error(ExitCode::tool_failed, message) {}
};

/// A computation failed although its input is allowed.
class ComputationError : public Error {
 public:
  explicit ComputationError(const std::string& reason)
      : Error(ExitCode::failed, "the computation failed: " + reason) {}
};

}  // namespace sys
