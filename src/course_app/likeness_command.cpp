// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "course/marking/submission.hpp"
#include "course/release/handout.hpp"
#include "course/release/wrong_solutions.hpp"
#include "course/reporting/likeness.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "course_app/commands.hpp"
#include "system/files.hpp"
#include "system/staging.hpp"

namespace course_app {
namespace fs = std::filesystem;
namespace {

void export_to(const fs::path& folder, const course::Files& files) {
  for (const auto& [file, text] : files) sys::write_file_atomically(folder / file, text);
}

ExitCode likeness(const CourseOptions& options, int percent) {
  const course::Assignment assignment = read_assignment(options);
  const course::Project project = course::read_project(assignment, options.source);
  const course::Files base =
      course::submission(assignment, course::texts(project, course::Edition::handout));
  const course::Files solution = course::texts(project, course::Edition::solution);
  std::vector<course::Files> expected = {base, solution};
  for (const auto& wrong : course::read_wrong_solutions(assignment, solution)) {
    expected.push_back(course::with_mistake(solution, wrong));
  }

  constexpr auto isolation = course::Isolation::sandbox;
  const course::Listing listing =
      course::list_submissions(options.submissions, roster_of(options.roster));
  sys::Staging staging(options.output);
  export_to(staging.path() / "base", base);
  std::vector<course::Written> all;
  std::vector<std::string> problems = listing.problems;
  for (const course::Entry& entry : listing.entries) {
    const course::ScratchFolder work;
    try {
      all.push_back(
          {entry.student,
           course::take_submission(assignment, entry.path, work.path(), isolation).files});
    } catch (const sys::OutputError& error) {
      problems.emplace_back(error.what());
      continue;
    }
    export_to(staging.path() / "submissions" / entry.student, all.back().files);
  }
  const course::ScratchFolder work;
  const course::Likeness likeness = course::likeness_of(
      assignment, all, course::known_lines(expected), percent, work.path(), isolation);
  sys::write_file_atomically(staging.path() / "pairs.csv", course::pairs_csv(likeness.pairs));
  staging.replace();
  problems.insert(problems.end(), likeness.problems.begin(), likeness.problems.end());
  return answer_faults(problems);
}

}  // namespace

void add_likeness_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "likeness",
              "Compare submissions with each other, and export them for MOSS and JPlag", exit_code,
              [](CLI::App& command) {
                auto options = std::make_shared<CourseOptions>();
                add_submissions(command, *options);
                add_assignment(command, *options);
                add_source(command, *options);
                add_roster(command, *options);
                add_output(command, *options);
                auto percent = std::make_shared<NumberOption>(
                    command, "--percent", "How much of one of them a pair must have in common; 50");
                return [options, percent] {
                  return likeness(*options, static_cast<int>(number_of(*percent, 50, 100)));
                };
              });
}

}  // namespace course_app
