// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/check_list.hpp"

#include <fmt/core.h>

#include "config/table.hpp"

namespace course {
namespace {

void add(Checks& checks, const CheckEntry& entry, const Checks& visible, const Checks& hidden) {
  const bool is_visible = entry.visibility == Visibility::visible;
  const Checks& code = is_visible ? visible : hidden;
  const auto found = code.find(entry.id);
  if (found == code.end()) {
    throw config::Error(
        fmt::format("{}: exercise.check.id: no {} check of the code has the id "
                    "\"{}\"",
                    entry.place, is_visible ? "public" : "hidden", entry.id));
  }
  checks.insert(*found);
}

}  // namespace

Checks all_checks(const Assignment& assignment, const Checks& visible, const Checks& hidden) {
  Checks checks;
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) {
      if (entry.visibility != Visibility::tests) add(checks, entry, visible, hidden);
    }
  }
  for (const Checks* code : {&visible, &hidden}) {
    for (const auto& [id, check] : *code) {
      if (checks.contains(id)) continue;
      throw config::Error(
          fmt::format("{}: no [[exercise.check]] has the id \"{}\", which the code decides",
                      (assignment.folder / "assignment.toml").string(), id));
    }
  }
  return checks;
}

}  // namespace course
