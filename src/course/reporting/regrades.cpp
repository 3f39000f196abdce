// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/regrades.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "config/table.hpp"
#include "course/assignment/student.hpp"
#include "system/error.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

const CheckEntry* find_check(const Assignment& assignment, const std::string& id) {
  for (const Exercise& exercise : assignment.exercises) {
    const auto check = std::ranges::find(exercise.checks, id, &CheckEntry::id);
    if (check != exercise.checks.end()) return &*check;
  }
  return nullptr;
}

std::string nonempty_text(const config::Table& table, const std::string& key) {
  std::string text = table.text(key);
  if (text.empty()) table.fail(key, "must not be empty");
  return text;
}

RegradeOutcome outcome_of(const config::Table& table) {
  const std::string outcome = table.text("outcome");
  if (outcome == "open") return RegradeOutcome::open;
  if (outcome == "granted") return RegradeOutcome::granted;
  if (outcome == "refused") return RegradeOutcome::refused;
  table.fail("outcome", fmt::format("\"{}\" is not \"open\", \"granted\" or \"refused\"", outcome));
}

/// What was decided, which an open request must not say.
void read_decision(const config::Table& table, const CheckEntry& check, Regrade& regrade) {
  if (regrade.outcome == RegradeOutcome::open) return;
  regrade.answer = nonempty_text(table, "answer");
  regrade.marker = nonempty_text(table, "marker");
  if (regrade.outcome == RegradeOutcome::refused) return;
  regrade.points = table.number("points");
  if (regrade.points < 0 || regrade.points > check.points) {
    table.fail("points", fmt::format("{} is not from 0 to {}, the points of {}", regrade.points,
                                     check.points, check.id));
  }
}

Regrade read_regrade(const Assignment& assignment, const fs::path& file) {
  const auto table = config::Table::parse_file(file);
  Regrade regrade{.student = table.text("student"),
                  .check = table.text("check"),
                  .reason = nonempty_text(table, "reason"),
                  .outcome = outcome_of(table),
                  .answer = {},
                  .marker = {},
                  .place = table.place("student")};
  try {
    require_student_id(regrade.student);
  } catch (const sys::SourceError& error) {
    table.fail("student", error.what());
  }
  const CheckEntry* check = find_check(assignment, regrade.check);
  if (check == nullptr) {
    table.fail("check", fmt::format("there is no check \"{}\"", regrade.check));
  }
  read_decision(table, *check, regrade);
  table.reject_unknown_keys();
  return regrade;
}

void give(const Regrade& regrade, Mark& mark) {
  mark.checks.at(regrade.check) = regrade.points;
  mark.add_up();
  mark.regraded.push_back(regrade.check);
}

}  // namespace

std::vector<Regrade> read_regrades(const Assignment& assignment, const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  if (error) {
    throw sys::OutputError(fmt::format("cannot list '{}': {}", folder.string(), error.message()));
  }
  std::ranges::sort(files);
  std::vector<Regrade> regrades;
  std::set<std::pair<std::string, std::string>> known;
  for (const fs::path& file : files) {
    regrades.push_back(read_regrade(assignment, file));
    const Regrade& last = regrades.back();
    if (known.emplace(last.student, last.check).second) continue;
    throw config::Error(fmt::format("{}: student: {} has asked for {} in another file already",
                                    last.place, last.student, last.check));
  }
  return regrades;
}

void apply_regrades(const std::vector<Regrade>& regrades, ClassMarks& marks) {
  for (const Regrade& regrade : regrades) {
    bool is_found = false;
    for (StudentMark& student : marks.students) {
      if (student.unit() != regrade.student || !student.mark) continue;
      is_found = true;
      if (regrade.outcome == RegradeOutcome::granted) give(regrade, *student.mark);
    }
    if (!is_found) {
      marks.problems.push_back(
          fmt::format("{}: student: {} has no mark", regrade.place, regrade.student));
    }
  }
}

std::vector<Regrade> regrades_of(const std::vector<Regrade>& regrades, const StudentMark& student) {
  std::vector<Regrade> theirs;
  std::ranges::copy_if(regrades, std::back_inserter(theirs),
                       [&](const Regrade& regrade) { return regrade.student == student.unit(); });
  return theirs;
}

}  // namespace course
