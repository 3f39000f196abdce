// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/proof.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <locale>

#include "course/sandbox/scratch_folder.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

// Runs make without the flags and the job server of another make that started this program.
sys::ProcessResult run_make(const fs::path& folder, const std::vector<std::string>& targets,
                            std::size_t n_jobs) {
  return sys::run({.program = "make",
                   .arguments = targets,
                   .working_directory = folder,
                   .environment = {{"MAKEFLAGS", ""},
                                   {"MAKELEVEL", ""},
                                   {"MFLAGS", ""},
                                   {"CXXFLAGS", ""},
                                   {"LDFLAGS", ""},
                                   {"CMAKE_BUILD_PARALLEL_LEVEL", std::to_string(n_jobs)},
                                   {"LC_ALL", "C"}}});
}

std::vector<std::string> warnings_in(const std::string& output) {
  std::vector<std::string> warnings;
  for (const std::string_view line : sys::lines_of(output)) {
    if (boost::algorithm::icontains(line, "warning", std::locale::classic()))
      warnings.push_back("make: " + std::string(line));
  }
  return warnings;
}

// The first line with an error, or else the last line.
std::string error_in(const std::string& output) {
  const auto lines = sys::lines_of(output);
  const auto error = std::ranges::find_if(
      lines, [](std::string_view line) { return line.find("rror") != std::string_view::npos; });
  if (error != lines.end()) return std::string(*error);
  return lines.empty() ? "" : std::string(lines.back());
}

}  // namespace

std::vector<std::string> faults_of_student_build(const Assignment& assignment,
                                                 const fs::path& handout, std::size_t n_jobs) {
  const ScratchFolder scratch;
  const fs::path copy = scratch.path() / "my handout";
  fs::copy(handout, copy, fs::copy_options::recursive);
  const sys::ProcessResult made = run_make(copy, {}, n_jobs);
  if (made.exit_status != 0) {
    return {fmt::format("make ends with status {}: {}", made.exit_status, error_in(made.output))};
  }
  // The handout's makefile may write CMake's output to a file.
  std::string output = made.output;
  if (fs::exists(copy / "build.log")) output += sys::read_file(copy / "build.log");
  std::vector<std::string> faults = warnings_in(output);

  // The checks need not hold yet, but each must be tried.
  const sys::ProcessResult checked = run_make(copy, {"check"}, n_jobs);
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& check : exercise.checks) {
      if (check.visibility == Visibility::hidden) continue;
      if (checked.output.find(check.id) != std::string::npos) continue;
      faults.push_back(fmt::format("make check says nothing of {}; its output ends: {}", check.id,
                                   error_in(checked.output)));
    }
  }
  return faults;
}

}  // namespace course
