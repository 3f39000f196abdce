// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assignment/assignment.hpp"
#include "command_line/stage.hpp"
#include "course/marking/roster.hpp"
#include "course/release/handout.hpp"
#include "course/release/proof.hpp"
#include "course/release/variant_check.hpp"
#include "course_app/commands.hpp"
#include "system/files.hpp"

namespace course_app {
namespace fs = std::filesystem;
namespace {

struct Options : CourseOptions {
  std::string sheet, handout, zip, handouts;
};

void add_place(CLI::App& command, Options& options) {
  add_assignment(command, options);
  add_source(command, options);
}

std::size_t jobs_of(const NumberOption& option) {
  constexpr long most = 1024;
  return static_cast<std::size_t>(number_of(option, 1, most));
}

ExitCode write(const Options& options, course::Edition edition) {
  const course::Assignment assignment = read_assignment(options);
  const course::Variant variant = variant_of(options, assignment);
  const course::Project project = course::read_project(assignment, options.source);
  course::write_project(project, edition, assignment, variant, options.sheet, options.output);
  fmt::print("{}\n", options.output);
  return ExitCode::success;
}

// The sources of the hidden checks, with which the answers are compared: exercises/x_hidden.cpp and
// what they share.
std::vector<fs::path> secret_files(const std::string& source) {
  const fs::path folder = fs::path(source) / "src/assignment/exercises";
  std::vector<fs::path> files;
  for (const std::string& file : sys::files_below(folder)) {
    if (fs::path(file).stem().string().ends_with("_hidden")) files.push_back(folder / file);
  }
  return files;
}

ExitCode prove(const Options& options, std::size_t n_jobs, bool updates_points) {
  const course::Assignment assignment = read_assignment(options);
  const course::Project project = course::read_project(assignment, options.source);
  const course::ProofInput input{.assignment = assignment,
                                 .project = project,
                                 .visible = assignment::public_checks(),
                                 .hidden = assignment::hidden_checks(),
                                 .variant = variant_of(options, assignment),
                                 .handout = options.handout,
                                 .zip = options.zip,
                                 .toolkit = options.toolkit,
                                 .secret_files = secret_files(options.source),
                                 .source = options.source,
                                 .n_jobs = n_jobs,
                                 .updates_points = updates_points};
  Stage stage("prove");
  const bool all_hold = course::prove(input, [&](const course::ProvedClaim& claim) {
    stage.done(claim.faults.empty() ? claim.says : "does not hold: " + claim.says);
    answer_faults(claim.faults);
    stage = Stage("prove");
  });
  return all_hold ? ExitCode::success : ExitCode::failed;
}

std::vector<std::string> students_of(const Options& options, const NumberOption& count) {
  constexpr long class_size = 300;
  constexpr long most = 100000;
  if (options.roster.empty()) {
    if (!options.handouts.empty()) throw sys::InputError("--handouts needs --roster");
    return course::invented_students(static_cast<std::size_t>(number_of(count, class_size, most)));
  }
  if (count.integer()) throw sys::InputError("--count and --roster exclude each other");
  std::vector<std::string> students = course::units_of(course::read_roster(options.roster));
  if (students.empty()) throw sys::InputError(fmt::format("'{}' names no student", options.roster));
  return students;
}

ExitCode check_variants(const Options& options, const std::vector<std::string>& students,
                        std::size_t n_jobs) {
  const course::Assignment assignment = read_assignment(options);
  const course::Project project = course::read_project(assignment, options.source);
  Stage stage("variants");
  const auto faults = course::faults_of_variants({.assignment = assignment,
                                                  .project = project,
                                                  .visible = assignment::public_checks(),
                                                  .hidden = assignment::hidden_checks(),
                                                  .toolkit = options.toolkit,
                                                  .is_valid = assignment::is_valid,
                                                  .seed = seed_of(options),
                                                  .students = students,
                                                  .n_jobs = n_jobs,
                                                  .handouts = options.handouts,
                                                  .secret_files = secret_files(options.source)});
  const std::string good = options.handouts.empty() ? "" : ", and nothing is given away";
  const std::string found = faults.empty()
                                ? "no two are alike, the solution scores all points on each" + good
                                : fmt::format("{} faults", faults.size());
  stage.done(fmt::format("{} variants: {}", students.size(), found));
  return answer_faults(faults);
}

}  // namespace

namespace {

void add_edition(CLI::App& program, ExitCode& exit_code, const char* name, const char* says,
                 course::Edition edition) {
  add_command(program, name, says, exit_code, [edition](CLI::App& command) {
    auto options = std::make_shared<Options>();
    add_output(command, *options);
    add_student(command, *options);
    add_text(command, "--sheet", options->sheet, "FILE", "The assignment sheet, a PDF");
    add_place(command, *options);
    return [options, edition] { return write(*options, edition); };
  });
}

}  // namespace

void add_handout_command(CLI::App& program, ExitCode& exit_code) {
  add_edition(program, exit_code, "handout", "Write the project that students get",
              course::Edition::handout);
}

void add_solution_command(CLI::App& program, ExitCode& exit_code) {
  add_edition(program, exit_code, "solution",
              "Write the same project with the instructor's solution", course::Edition::solution);
}

void add_prove_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "prove",
              "Prove that a handout compiles and gives nothing away, and that the solution and "
              "wrong ones score what they must",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<Options>();
                add_required_text(command, "handout", options->handout, "HANDOUT",
                                  "Folder that `handout` wrote");
                add_toolkit(command, *options);
                add_text(command, "--zip", options->zip, "FILE", "The same handout packed");
                add_student(command, *options);
                auto jobs = std::make_shared<NumberOption>(command, "--jobs", "How many at a time");
                auto updates = std::make_shared<bool>(false);
                add_switch(command, "--update", *updates,
                           "Write what the wrong solutions score to their list, for review");
                add_place(command, *options);
                return
                    [options, jobs, updates] { return prove(*options, jobs_of(*jobs), *updates); };
              });
}

void add_check_variants_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "check-variants", "Try the instructor's solution on many variants",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<Options>();
                auto count = std::make_shared<NumberOption>(command, "--count", "How many; 300");
                add_roster(command, *options);
                add_seed(command, *options);
                add_text(command, "--handouts", options->handouts, "DIR",
                         "The students' handouts and zips, to be proved as well");
                add_toolkit(command, *options);
                auto jobs = std::make_shared<NumberOption>(command, "--jobs", "How many at a time");
                add_place(command, *options);
                return [options, count, jobs] {
                  return check_variants(*options, students_of(*options, *count), jobs_of(*jobs));
                };
              });
}

}  // namespace course_app
