// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/toolkit.hpp"

#include <fmt/core.h>

#include "system/error.hpp"

namespace course {
namespace fs = std::filesystem;

fs::path Toolkit::stub_of(const std::string& file) const {
  return folder / "stubs" / (file + ".o");
}

fs::path Toolkit::programs_of(const std::string& exercise) const {
  fs::path all = fs::weakly_canonical(folder);
  all += "-programs";
  return all / exercise;
}

std::vector<std::string> compile_flags(const std::string& project) {
  return {"-std=c++20",
          "-O2",
          "-w",
          "-D__TIMESTAMP__=\"\"",  // the time when the grader wrote the file
          "-I",
          project + "/provided",
          "-I",
          project + "/src",
          "-isystem",
          "/usr/include/eigen3"};
}

std::vector<std::string> link_flags() {
  return {"-Wl,--as-needed", "-lgsl", "-lgslcblas", "-lfmt", "-lm"};
}

Toolkit open_toolkit(const Assignment& assignment, const fs::path& folder) {
  Toolkit toolkit{fs::absolute(folder)};
  if (!fs::exists(toolkit.header())) {
    throw sys::OutputError(
        fmt::format("'{}' is no toolkit; `halfspace-course toolkit` makes one", folder.string()));
  }
  for (const Exercise& exercise : assignment.exercises) {
    if (!fs::exists(toolkit.stub_of(exercise.file))) {
      throw sys::OutputError(
          fmt::format("the toolkit '{}' is of another assignment: it has no stub of {}",
                      folder.string(), exercise.file));
    }
    std::error_code error;  // another user may have made it
    if (!exercise.tests.empty() && !fs::exists(toolkit.programs_of(exercise.id) / "right", error)) {
      throw sys::OutputError(
          fmt::format("the toolkit '{}' has no programs for {}", folder.string(), exercise.tests));
    }
  }
  return toolkit;
}

}  // namespace course
