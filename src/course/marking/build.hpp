// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "course/assignment/assignment.hpp"
#include "course/marking/compiler.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// A submission, compiled.
struct Built {
  std::filesystem::path program;  ///< of all files that compile
  /// By exercise the program of its own file, those that it builds on, and stubs in place of all
  /// others, so that what the others do when they start or end costs nothing here. An exercise is
  /// not there if its file needs another one to be linked.
  std::map<std::string, std::filesystem::path> alone;
  /// The compiler's message by exercise, for each exercise whose file was not taken or does
  /// not compile and is replaced by its stub.
  std::map<std::string, std::string> compile_errors;
  std::string link_error;  ///< empty if there is a program
  double seconds = 0;      ///< that it took, as JobEnd::seconds

  const std::filesystem::path& program_of(const Exercise& exercise) const {
    const auto own = alone.find(exercise.id);
    return own == alone.end() ? program : own->second;
  }
};

/// Lets every user run a program that a job wrote.
void make_executable(const std::filesystem::path& program);

/// Compiles the exercises' files into the folder `scratch`; `toolkit` is the folder of the
/// toolkit. Throws ToolError if the compiler or the sandbox cannot be started or the other main
/// does not compile, never because of what was submitted.
Built build(const Assignment& assignment, const std::filesystem::path& toolkit, const Files& files,
            const std::filesystem::path& scratch, Isolation isolation,
            const std::optional<OtherMain>& other = std::nullopt);

}  // namespace course
