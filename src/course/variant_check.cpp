// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/variant_check.hpp"

#include <fmt/core.h>

#include <map>

#include "course/check_list.hpp"
#include "course/grading.hpp"
#include "course/score.hpp"
#include "course/scratch_folder.hpp"
#include "course/variants.hpp"
#include "literate/parallel.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

std::vector<Variant> variants_of(const VariantCheckInput& input) {
  std::vector<Variant> variants;
  for (std::size_t i = 1; i <= input.count; ++i) {
    variants.push_back(
        variant_of(input.assignment, fmt::format("student-{}", i), input.seed, input.is_valid));
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

// The program again, in a folder where no other run writes.
Built in_folder(const Built& built, const fs::path& folder) {
  fs::create_directories(folder);
  Built linked = built;
  linked.program = folder / "program";
  fs::create_hard_link(built.program, linked.program);
  return linked;
}

}  // namespace

std::vector<std::string> faults_of_variants(const VariantCheckInput& input) {
  const Checks checks = all_checks(input.assignment, input.visible, input.hidden);
  const std::vector<Variant> variants = variants_of(input);
  std::vector<std::string> faults = doubled(variants);

  const Isolation isolation = isolation_of(input.n_jobs);
  const ScratchFolder scratch;
  const Files solution = submission(input.assignment, texts(input.project, Edition::solution));
  const Built built =
      build(input.assignment, input.toolkit, solution, scratch.path() / "build", Isolation::none);
  std::vector<std::vector<std::string>> losses(variants.size());
  literate::for_each_parallel(variants.size(), input.n_jobs, [&](std::size_t i) {
    const fs::path folder = scratch.path() / variants[i].student;
    losses[i] =
        score_of(input.assignment, in_folder(built, folder), checks, variants[i], isolation).losses;
    fs::remove_all(folder);
  });
  for (std::size_t i = 0; i < variants.size(); ++i) {
    for (const std::string& loss : losses[i]) {
      faults.push_back(fmt::format("{}: {}", variants[i].student, loss));
    }
  }
  return faults;
}

}  // namespace course
