// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/sheet.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace assignment {

using course::Assignment;
using course::CheckEntry;
using course::Exercise;
using course::Variant;
using course::Visibility;
using literate::Cell;
using literate::Column;
using literate::Document;
using literate::exact;
using literate::integer;
using literate::Table;
using literate::Value;

namespace {

// The symbol of a quantity of assignment.toml in the formulas, and its name.
struct Meaning {
  std::string symbol;
  std::string words;
};
const std::map<std::string, Meaning> meanings = {
    {"young1", {"$E_1$", "modulus of elasticity of body 1, and of exercises 1 to 3"}},
    {"poisson1", {"$\\nu_1$", "Poisson's ratio of body 1, and of exercises 1 to 3"}},
    {"young2", {"$E_2$", "modulus of elasticity of body 2"}},
    {"poisson2", {"$\\nu_2$", "Poisson's ratio of body 2"}},
    {"radius1", {"$R_1$", "radius of cylinder 1"}},
    {"radius2", {"$R_2$", "radius of cylinder 2"}},
    {"line_load", {"$P$", "load that presses the cylinders together"}},
    {"spacing", {"$c$", "spacing of the nodes"}},
    {"nodes", {"$n$", "number of nodes"}},
    {"peak_pressure", {"$p_0$", "peak of the triangular pressure, unit of the others"}},
    {"half_width", {"$a$", "half-width of the pressure"}},
    {"datum", {"$d$", "datum, where the displacement is zero"}},
};

// A count as a text has it: in words up to twelve.
std::string in_words(std::size_t count) {
  static const std::vector<std::string> words = {"no",   "one",    "two",   "three", "four",
                                                 "five", "six",    "seven", "eight", "nine",
                                                 "ten",  "eleven", "twelve"};
  return count < words.size() ? words[count] : fmt::format("{}", count);
}

void register_facts(Document& document, const Assignment& assignment, const Variant& variant) {
  document.value("sheet.title", Value::text(assignment.title));
  document.value("sheet.deadline", Value::text(fmt::format("{:%Y-%m-%d, %H:%M} UTC",
                                                           fmt::gmtime(assignment.deadline))));
  document.value("sheet.points", Value(assignment.points, exact()));
  document.value("sheet.exercises", Value::text(in_words(assignment.exercises.size())));
  document.value("sheet.student", Value::text(variant.student));
  document.flag("sheet.is-personal", !variant.student.empty());
  document.value("late.percent", Value(assignment.late.percent_per_day, exact()));
  document.value("late.days", Value(assignment.late.days, integer()));
  document.flag("late.has-grace", assignment.late.grace_minutes > 0);
  document.value("late.grace", Value(assignment.late.grace_minutes, integer(), "min"));
  document.flag("late.has-slip-days", assignment.late.slip_days > 0);
  document.value("late.slip-days", Value(assignment.late.slip_days, integer()));
  document.value("limit.compile", Value(assignment.limits.compile_seconds, integer(), "s"));
  document.value("limit.run", Value(assignment.limits.run_seconds, integer(), "s"));
  document.value("limit.all-runs", Value(assignment.limits.submission_seconds, integer(), "s"));
  document.value("limit.report", Value(assignment.limits.report_seconds, integer(), "s"));
  document.value("limit.processes", Value(assignment.limits.processes, integer()));
  document.value("limit.memory", Value(assignment.limits.memory_mb, integer(), "{MB}"));
  document.value("limit.output", Value(assignment.limits.output_kb, integer(), "{kB}"));
  document.value("limit.submission", Value(assignment.limits.submission_mb, integer(), "{MB}"));
  document.value("limit.file", Value(assignment.limits.file_kb, integer(), "{kB}"));
}

const char* name_of(Visibility visibility) {
  if (visibility == Visibility::tests) return "your tests";
  return visibility == Visibility::visible ? "public" : "hidden";
}

void register_exercises(Document& document, const Assignment& assignment) {
  Table exercises("exercises",
                  {Column::text("exercise"), Column::text("file"), Column::text("builds on"),
                   Column("points", exact()), Column("of them public", exact())});
  int number = 0;
  for (const Exercise& exercise : assignment.exercises) {
    Table checks("checks-" + exercise.id,
                 {Column::text("what is tried"), Column::text("check"), Column("points", exact())});
    double of_public = 0;
    for (const CheckEntry& check : exercise.checks) {
      if (check.visibility == Visibility::visible) of_public += check.points;
      checks.add_row({check.says, name_of(check.visibility), check.points});
    }
    document.table(std::move(checks));
    document.value("points." + exercise.id, Value(exercise.points(), exact()));
    const std::string before = fmt::format("{}", fmt::join(exercise.builds_on, ", "));
    exercises.add_row({fmt::format("{}. {}", ++number, exercise.title), exercise.file,
                       before.empty() ? "–" : before, exercise.points(), of_public});
  }
  document.table(std::move(exercises));
}

// The rubric of the report, if it has one.
void register_criteria(Document& document, const Assignment& assignment) {
  document.flag("report.has-rubric", !assignment.criteria.empty());
  if (assignment.criteria.empty()) return;
  Table table("criteria", {Column::text("criterion"), Column::text("what is looked for"),
                           Column("points", exact())});
  for (const course::Criterion& criterion : assignment.criteria) {
    table.add_row({criterion.title, criterion.says, criterion.points});
  }
  document.table(std::move(table));
  document.value("report.points", Value(assignment.report_points(), exact()));
}

void register_quantities(Document& document, const Assignment& assignment, const Variant& variant) {
  Table table("quantities", {Column::text(""), Column::text("quantity"), Column::text("name"),
                             Column::text("value")});
  for (const course::Quantity& quantity : assignment.quantities) {
    const Value value = Value(variant(quantity.name), exact(), quantity.unit);
    const auto known = meanings.find(quantity.name);
    const Meaning meaning = known == meanings.end() ? Meaning{} : known->second;
    table.add_row(
        {Cell::latex(meaning.symbol), meaning.words, quantity.name, Cell::latex(value.latex())});
  }
  document.table(std::move(table));
}

}  // namespace

void register_sheet(Document& document, const Assignment& assignment, const Variant& variant) {
  register_facts(document, assignment, variant);
  register_exercises(document, assignment);
  register_criteria(document, assignment);
  register_quantities(document, assignment, variant);
  document.figure("setting", setting());
  document.figure("lost-digits", lost_digits());
}

}  // namespace assignment
