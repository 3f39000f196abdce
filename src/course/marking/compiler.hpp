// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/toolkit.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// A program of the toolkit's project that takes the place of the one which answers questions.
struct OtherMain {
  std::string file;  ///< with main(), in the project
  Files files;       ///< take the place of the project's
};

/// Runs the compiler on the files of one submission. All runs together may take half of
/// Limits::submission_seconds to compile.
class Compiler {
 public:
  /// Throws ToolError if jobs cannot read the toolkit; otherwise it would look as if the submission
  /// did not compile.
  Compiler(const Assignment& assignment, const std::filesystem::path& toolkit,
           const std::filesystem::path& scratch, Isolation isolation);

  const Toolkit& toolkit() const { return toolkit_; }

  /// Writes the given project with the student's files in it, tests of their own among them.
  void write_project(const Assignment& assignment, const Files& files) const;

  /// Links with another program of the project, which is compiled here.
  void use(const OtherMain& other);
  /// Links with another main(), an object.
  void use_object(const std::filesystem::path& object) {
    other_main_ = Readable{object, "/main.o"};
  }

  /// Compiles a file of the project to `object`. Returns the compiler's message, empty if it
  /// worked.
  std::string compile(const std::string& file, const std::filesystem::path& object) const;

  /// Whether objects need nothing but each other and what is given.
  bool are_complete(const std::vector<Readable>& objects) const;

  /// Links objects with the given ones. Returns the linker's message, empty if it worked.
  std::string link(const std::vector<Readable>& objects,
                   const std::filesystem::path& program) const;

  /// What all runs took, as JobEnd::seconds.
  double seconds() const { return seconds_; }

 private:
  void require_readable_toolkit() const;
  std::string in_sandbox(const std::filesystem::path& file) const;
  void add_what_is_linked(const std::vector<Readable>& objects,
                          std::vector<std::string>& arguments) const;
  std::vector<std::string> arguments_for(const std::string& file, bool is_precompiled) const;
  JobEnd run(const std::vector<std::string>& arguments, const std::filesystem::path& product,
             const std::vector<Readable>& objects = {}) const;
  int seconds_for_all() const;
  int seconds_for_one() const;
  std::filesystem::path errors() const;
  std::string excess_of(const JobEnd& end) const;
  std::string message_of(const JobEnd& end) const;
  std::string too_large() const;

  Toolkit toolkit_;
  Limits limits_;
  std::filesystem::path scratch_;
  Sandbox sandbox_;
  Readable given_, project_;
  std::optional<Readable> other_main_;
  mutable double seconds_ = 0;
};

}  // namespace course
