// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/proof.hpp"

#include <fmt/core.h>

#include "course/marking/own_tests.hpp"
#include "course/marking/toolkit.hpp"
#include "course/marking/try_checks.hpp"
#include "course/release/leaks.hpp"
#include "course/release/secret_numbers.hpp"
#include "course/release/wrong_solutions.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// Tries the claims one after the other.
class Prover {
 public:
  explicit Prover(const ProofInput& input)
      : input_(input),
        checks_(all_checks(input.assignment, input.visible, expected_.listening(input.hidden))),
        solution_(texts(input.project, Edition::solution)),
        wrong_(read_wrong_solutions(input.assignment, solution_)) {
    open_toolkit(input.assignment, input.toolkit);  // reports a wrong folder before the work begins
  }

  ProvedClaim variant() const;
  ProvedClaim student_build() const;
  ProvedClaim floor() const;
  ProvedClaim full_points() const;
  ProvedClaim wrong_solutions() const;
  ProvedClaim no_leaks() const;

 private:
  SolutionTrial trial_of(const Files& files, const Checks& checks, const Variant& variant) const {
    return try_solution(input_.assignment, input_.toolkit, submission(input_.assignment, files),
                        checks, variant, isolation_of(input_.n_jobs));
  }
  /// The same with the tests among the files; each wrong program that they miss is a loss.
  SolutionTrial trial_with_tests(const Files& files) const {
    const ScratchFolder scratch;
    std::vector<std::string> missed;
    const Checks checks = with_own_tests(checks_,
                                         {.assignment = input_.assignment,
                                          .toolkit = input_.toolkit,
                                          .files = files,
                                          .scratch = scratch.path() / "own tests",
                                          .isolation = isolation_of(input_.n_jobs)},
                                         missed);
    SolutionTrial trial = trial_of(files, checks, input_.variant);
    trial.losses.insert(trial.losses.end(), missed.begin(), missed.end());
    return trial;
  }

  const ProofInput& input_;
  ExpectedValues expected_;
  Checks checks_;
  Files solution_;
  std::vector<WrongSolution> wrong_;
};

ProvedClaim Prover::variant() const {
  ProvedClaim claim{.says = "the handout is of this variant", .faults = {}};
  const fs::path header = input_.handout / variant_file;
  if (sys::read_file(header) != variant_header(input_.assignment, input_.variant)) {
    claim.faults.push_back(fmt::format("{} has other numbers", header.string()));
  }
  return claim;
}

ProvedClaim Prover::student_build() const {
  return {.says = "it compiles without a warning, and its checks run",
          .faults = faults_of_student_build(input_.assignment, input_.handout, input_.n_jobs)};
}

ProvedClaim Prover::floor() const {
  Files files;
  for (const Exercise& exercise : input_.assignment.exercises) {
    for (const std::string& file : {exercise.file, exercise.tests}) {
      if (!file.empty()) files[file] = sys::read_file(input_.handout / file);
    }
  }
  const double points = trial_with_tests(files).points;
  ProvedClaim claim{.says = fmt::format("as it is, it scores {} of {} points",
                                        input_.assignment.floor, input_.assignment.points),
                    .faults = {}};
  if (!are_same_points(points, input_.assignment.floor)) {
    claim.faults.push_back(fmt::format("the untouched handout scores {}", points));
  }
  return claim;
}

ProvedClaim Prover::full_points() const {
  return {.says = fmt::format("the solution scores all {} points", input_.assignment.points),
          .faults = trial_with_tests(solution_).losses};
}

ProvedClaim Prover::wrong_solutions() const {
  std::vector<double> points(wrong_.size());
  // These checks do not record, because the answers of wrong programs are no expected values. Tests
  // try the same programs whatever else is handed in, so here they count nothing.
  const Checks checks = without_own_tests(
      all_checks(input_.assignment, input_.visible, input_.hidden), input_.assignment, 0);
  const Variant nominal = nominal_variant(input_.assignment);
  sys::for_each_parallel(wrong_.size(), input_.n_jobs, [&](std::size_t i) {
    points[i] = trial_of(with_mistake(solution_, wrong_[i]), checks, nominal).points;
  });
  ProvedClaim claim{
      .says = fmt::format("each of {} wrong solutions scores what the list says", wrong_.size()),
      .faults = {}};
  if (input_.updates_points) {
    const fs::path list = input_.assignment.folder / "wrong_solutions.toml";
    sys::write_file_atomically(list, with_points(sys::read_file(list), points));
    claim.says = fmt::format("{} has what the {} wrong solutions score; review it", list.string(),
                             wrong_.size());
    return claim;
  }
  for (std::size_t i = 0; i < wrong_.size(); ++i) {
    if (are_same_points(points[i], wrong_[i].points)) continue;
    claim.faults.push_back(fmt::format("wrong solution {} ({}) scores {}, the list says {}",
                                       wrong_[i].id, wrong_[i].says, points[i], wrong_[i].points));
  }
  return claim;
}

ProvedClaim Prover::no_leaks() const {
  const auto values = expected_.values();
  const Secrets secrets =
      secrets_of(input_.assignment, input_.project, input_.secret_files, values);
  ProvedClaim claim{
      .says = fmt::format("none of {} solution lines, {} names and {} values is in it",
                          secrets.lines.size(), secrets.words.size(), values.size()),
      .faults = published_solutions(input_.project)};
  const auto add = [&](const std::vector<std::string>& faults) {
    claim.faults.insert(claim.faults.end(), faults.begin(), faults.end());
  };
  add(published_references(input_.assignment, input_.source, input_.secret_files));
  add(leaks(secrets, input_.handout));
  if (input_.zip.empty()) return claim;
  add(leaks(secrets, input_.zip));
  add(differences_of_zip(input_.zip, input_.handout));
  return claim;
}

}  // namespace

bool prove(const ProofInput& input, const std::function<void(const ProvedClaim&)>& tell) {
  const Prover prover(input);
  bool all_hold = true;
  // The search for leaks comes last, since it needs the answers of the solution.
  for (const auto claim : {&Prover::variant, &Prover::student_build, &Prover::floor,
                           &Prover::full_points, &Prover::wrong_solutions, &Prover::no_leaks}) {
    const ProvedClaim proved = (prover.*claim)();
    tell(proved);
    all_hold = all_hold && proved.faults.empty();
  }
  return all_hold;
}

}  // namespace course
