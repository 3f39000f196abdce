// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/variant_check.hpp"

#include <fmt/core.h>

#include <map>

#include "course/marking/build.hpp"
#include "course/marking/own_tests.hpp"
#include "course/marking/try_checks.hpp"
#include "course/release/leaks.hpp"
#include "course/release/secret_numbers.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

std::vector<Variant> variants_of(const VariantCheckInput& input) {
  std::vector<Variant> variants;
  for (const std::string& student : input.students) {
    variants.push_back(variant_of(input.assignment, student, input.seed, input.is_valid));
  }
  return variants;
}

std::vector<std::string> doubled(const std::vector<Variant>& variants) {
  std::vector<std::string> faults;
  std::map<std::map<std::string, double>, std::string> known;
  for (const Variant& variant : variants) {
    const auto [other, is_new] = known.try_emplace(variant.quantities, variant.student);
    if (is_new) continue;
    faults.push_back(fmt::format("{} has the same variant as {}", variant.student, other->second));
  }
  return faults;
}

// The same program in a folder where no other run writes.
Built in_folder(const Built& built, const fs::path& folder) {
  fs::create_directories(folder);
  Built linked = built;
  linked.program = folder / "program";
  linked.alone.clear();  // of one's own solution no file harms another
  fs::create_hard_link(built.program, linked.program);
  return linked;
}

// Compares a handout with what the student must get: the project, their numbers, and a sheet.
std::vector<std::string> differences_of_folder(const VariantCheckInput& input,
                                               const Variant& variant, const fs::path& handout) {
  Files wanted = texts(input.project, Edition::handout);
  wanted[variant_file] = variant_header(input.assignment, variant);
  std::vector<std::string> faults;
  std::size_t n_found = 0;
  for (const std::string& file : sys::files_below(handout)) {
    const auto found = wanted.find(file);
    if (found != wanted.end()) ++n_found;
    const bool is_right = found == wanted.end() ? file == "sheet.pdf"
                                                : sys::read_file(handout / file) == found->second;
    if (!is_right) faults.push_back(file + " is not what it must be");
  }
  if (n_found < wanted.size()) {
    faults.push_back(fmt::format("{} files are missing", wanted.size() - n_found));
  }
  return faults;
}

std::vector<std::string> faults_of_handout(const VariantCheckInput& input, const Variant& variant,
                                           const std::vector<double>& expected_values) {
  const fs::path handout = input.handouts / variant.student;
  const fs::path zip = handout.string() + ".zip";
  if (!fs::is_directory(handout) || !fs::is_regular_file(zip)) {
    return {fmt::format("'{}' or its zip is missing", handout.string())};
  }
  std::vector<std::string> faults = differences_of_folder(input, variant, handout);
  const Secrets secrets =
      secrets_of(input.assignment, input.project, input.secret_files, expected_values);
  for (const auto& found : {leaks(secrets, handout), differences_of_zip(zip, handout)}) {
    faults.insert(faults.end(), found.begin(), found.end());
  }
  return faults;
}

// Everything that is wrong with one student's variant and, if there are handouts, with theirs.
std::vector<std::string> faults_of(const VariantCheckInput& input, const Variant& variant,
                                   const Built& built) {
  ExpectedValues expected;
  // The solution's tests have been tried by the proof; they know nothing of variants.
  const Checks checks = without_own_tests(
      all_checks(input.assignment, input.visible, expected.listening(input.hidden)),
      input.assignment, 1);
  std::vector<std::string> faults =
      try_solution(input.assignment, built, checks, variant, isolation_of(input.n_jobs)).losses;
  if (input.handouts.empty()) return faults;
  const auto found = faults_of_handout(input, variant, expected.values());
  faults.insert(faults.end(), found.begin(), found.end());
  return faults;
}

}  // namespace

std::vector<std::string> invented_students(std::size_t count) {
  std::vector<std::string> students;
  for (std::size_t i = 1; i <= count; ++i) students.push_back(fmt::format("student-{}", i));
  return students;
}

std::vector<std::string> faults_of_variants(const VariantCheckInput& input) {
  const std::vector<Variant> variants = variants_of(input);
  std::vector<std::string> faults = doubled(variants);

  const ScratchFolder scratch;
  const Files solution = submission(input.assignment, texts(input.project, Edition::solution));
  const Built built =
      build(input.assignment, input.toolkit, solution, scratch.path() / "build", Isolation::none);
  std::vector<std::vector<std::string>> found(variants.size());
  sys::for_each_parallel(variants.size(), input.n_jobs, [&](std::size_t i) {
    const fs::path folder = scratch.path() / "students" / variants[i].student;
    found[i] = faults_of(input, variants[i], in_folder(built, folder));
    fs::remove_all(folder);
  });
  for (std::size_t i = 0; i < variants.size(); ++i) {
    for (const std::string& fault : found[i]) {
      faults.push_back(fmt::format("{}: {}", variants[i].student, fault));
    }
  }
  return faults;
}

}  // namespace course
