// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/assignment.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "config/table.hpp"
#include "system/decimal.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
using config::Table;

namespace {

// Points and grids are decimal fractions, so that sums of a few of them are far more accurate.
constexpr double rel_rounding = 1e-9;

std::string text(const Table& table, const std::string& key) {
  std::string text = table.text(key);
  if (text.empty()) table.fail(key, "must not be empty");
  if (text.find_first_of("\r\n") != std::string::npos) table.fail(key, "must be one line");
  return text;
}

template <class Number>
Number within(const Table& table, const std::string& key, Number number, Number least,
              Number most) {
  if (number < least || number > most) {
    table.fail(key, fmt::format("{} is not from {} to {}", number, least, most));
  }
  return number;
}

double number(const Table& table, const std::string& key, double least, double most) {
  return within(table, key, table.number(key), least, most);
}

double positive(const Table& table, const std::string& key) {
  const double number = table.number(key);
  if (number <= 0) table.fail(key, fmt::format("{} is not positive", number));
  return number;
}

int integer(const Table& table, const std::string& key, long least, long most) {
  return static_cast<int>(within(table, key, table.integer(key), least, most));
}

// Reads an identifier, which must not be among those known.
std::string new_id(const Table& table, const std::string& key, std::set<std::string>& known) {
  const std::string id = text(table, key);
  const bool is_word = std::ranges::all_of(
      id, [](char c) { return sys::is_alphanumeric(c) || c == '_' || c == '-'; });
  if (!is_word) {
    table.fail(key, fmt::format("\"{}\" is not of letters, digits, '_' and '-' alone", id));
  }
  if (!known.insert(id).second) table.fail(key, fmt::format("\"{}\" stands here again", id));
  return id;
}

void require_below(const Table& table, const std::string& key, const fs::path& file) {
  const bool climbs = std::ranges::find(file, "..") != file.end();
  if (file.empty() || file.is_absolute() || climbs || file != file.lexically_normal()) {
    table.fail(key, fmt::format("\"{}\" is not a plain path to a file below", file.string()));
  }
}

bool is_empty_list(const Table& table, const std::string& key) {
  try {
    return table.has(key) && table.texts(key).empty();
  } catch (const config::Error&) {
    return false;  // the list holds something else than texts
  }
}

/// Whether the feedback is held back.
bool read_feedback(const Table& root) {
  const std::string feedback = root.text("feedback");
  if (feedback != "at once" && feedback != "held back") {
    root.fail("feedback", fmt::format("\"{}\" is not \"at once\" or \"held back\"", feedback));
  }
  return feedback == "held back";
}

LatePolicy read_late(const Table& table) {
  constexpr int year = 366;
  constexpr int day_in_minutes = 1440;
  LatePolicy late{.percent_per_day = number(table, "percent_per_day", 0, 100),
                  .days = integer(table, "days", 0, year)};
  if (table.has("grace_minutes")) {
    late.grace_minutes = integer(table, "grace_minutes", 0, day_in_minutes);
  }
  if (table.has("slip_days")) late.slip_days = integer(table, "slip_days", 0, year);
  return late;
}

// A limit that is not given stays at its default.
Limits read_limits(const Table& table) {
  constexpr int day = 86400;
  constexpr int tebibyte_in_mb = 1 << 20;
  Limits limits;
  const auto read = [&](const std::string& key, int& limit, int most) {
    if (table.has(key)) limit = integer(table, key, 1, most);
  };
  read("compile_seconds", limits.compile_seconds, day);
  read("run_seconds", limits.run_seconds, day);
  read("submission_seconds", limits.submission_seconds, day);
  read("report_seconds", limits.report_seconds, day);
  read("memory_mb", limits.memory_mb, tebibyte_in_mb);
  read("processes", limits.processes, 100000);
  read("output_kb", limits.output_kb, tebibyte_in_mb);
  read("file_kb", limits.file_kb, tebibyte_in_mb);
  read("submission_mb", limits.submission_mb, tebibyte_in_mb);
  return limits;
}

std::map<std::string, std::size_t> read_single_numbers(const Table& table) {
  constexpr int most = 1000;
  std::map<std::string, std::size_t> numbers;
  for (const std::string& task : table.keys()) {
    numbers[task] = static_cast<std::size_t>(integer(table, task, 1, most));
  }
  return numbers;
}

CheckEntry read_check(const Table& table, std::set<std::string>& ids) {
  CheckEntry check;
  check.id = new_id(table, "id", ids);
  check.place = table.place("id");
  check.points = positive(table, "points");
  const std::string visibility = table.text("visibility");
  if (visibility != "public" && visibility != "hidden" && visibility != "tests") {
    table.fail("visibility",
               fmt::format("\"{}\" is not \"public\", \"hidden\" or \"tests\"", visibility));
  }
  check.visibility = visibility == "public"   ? Visibility::visible
                     : visibility == "hidden" ? Visibility::hidden
                                              : Visibility::tests;
  check.says = text(table, "says");
  return check;
}

Criterion read_criterion(const Table& table, std::set<std::string>& ids) {
  return {.id = new_id(table, "id", ids),
          .title = text(table, "title"),
          .says = text(table, "says"),
          .points = positive(table, "points")};
}

Quantity read_quantity(const Table& table, std::set<std::string>& names) {
  Quantity quantity;
  quantity.name = new_id(table, "name", names);
  quantity.unit = table.text("unit");
  quantity.from = table.number("from");
  quantity.to = number(table, "to", quantity.from, HUGE_VAL);
  quantity.step = positive(table, "step");
  if ((quantity.to - quantity.from) / quantity.step > 1e9) {
    table.fail("step", fmt::format("{} makes more than 1e9 values", quantity.step));
  }
  quantity.nominal = number(table, "nominal", quantity.from, quantity.to);
  const double k = std::round((quantity.nominal - quantity.from) / quantity.step);
  const double nearest = on_grid(quantity, static_cast<std::uint64_t>(k));
  if (std::abs(nearest - quantity.nominal) > rel_rounding * quantity.step) {
    table.fail("nominal", fmt::format("{} is not {} + k {}; the nearest that is is {}",
                                      quantity.nominal, quantity.from, quantity.step, nearest));
  }
  return quantity;
}

/// Reads the exercises, each of which builds on earlier ones alone.
class Exercises {
 public:
  Exercises(const Table& root, const fs::path& folder) : folder_(folder) {
    const auto tables = root.tables("exercise");
    if (tables.empty()) root.fail("exercise", "missing; there must be one at least");
    for (const Table& table : tables) exercises_.push_back(read(table));
  }

  std::vector<Exercise> take() && { return std::move(exercises_); }

  double points() const {
    double sum = 0;
    for (const Exercise& exercise : exercises_) sum += exercise.points();
    return sum;
  }

 private:
  Exercise read(const Table& table);
  std::string read_file_name(const Table& table, const std::string& key);

  fs::path folder_;
  std::vector<Exercise> exercises_;
  std::set<std::string> ids_, check_ids_, files_;
};

/// Reads the name of a file that students write.
std::string Exercises::read_file_name(const Table& table, const std::string& key) {
  std::string file = text(table, key);
  require_below(table, key, file);
  if (!fs::is_regular_file(folder_ / "template" / file)) {
    table.fail(key, fmt::format("there is no template/{}", file));
  }
  if (!files_.insert(file).second) {
    table.fail(key, fmt::format("{} is another exercise's file already", file));
  }
  return file;
}

Exercise Exercises::read(const Table& table) {
  Exercise exercise;
  exercise.id = new_id(table, "id", ids_);
  exercise.title = text(table, "title");
  exercise.file = read_file_name(table, "file");
  if (table.has("tests")) exercise.tests = read_file_name(table, "tests");
  if (table.has("builds_on")) exercise.builds_on = table.texts("builds_on");
  for (const std::string& needed : exercise.builds_on) {
    if (std::ranges::find(exercises_, needed, &Exercise::id) == exercises_.end()) {
      table.fail("builds_on", fmt::format("there is no exercise \"{}\" before this one", needed));
    }
  }
  // An empty list `check = []` is no list of tables for the parser.
  const bool has_none = is_empty_list(table, "check");
  const auto checks = has_none ? std::vector<Table>{} : table.tables("check");
  if (checks.empty()) {
    table.fail("id", fmt::format("exercise \"{}\" has no [[exercise.check]]", exercise.id));
  }
  for (const Table& check : checks) exercise.checks.push_back(read_check(check, check_ids_));
  const auto n = std::ranges::count(exercise.checks, Visibility::tests, &CheckEntry::visibility);
  if (n != (exercise.tests.empty() ? 0 : 1)) {
    table.fail("id",
               fmt::format("exercise \"{}\" has {} checks of visibility \"tests\", not one for "
                           "a file `tests` and none without it",
                           exercise.id, n));
  }
  return exercise;
}

std::vector<std::string> read_provided(const Table& root, const std::vector<Exercise>& exercises) {
  constexpr std::string_view name = "@name@";
  std::vector<std::string> files;
  for (const std::string& file : root.texts("provided")) {
    const auto at = file.find(name);
    if (at == file.npos) files.push_back(file);
    for (const Exercise& exercise : at == file.npos ? std::vector<Exercise>{} : exercises) {
      files.push_back(std::string(file).replace(at, name.size(), exercise.name()));
    }
  }
  std::set<std::string> known;
  for (const std::string& file : files) {
    require_below(root, "provided", file);
    if (!known.insert(file).second)
      root.fail("provided", fmt::format("{} stands here twice", file));
  }
  return files;
}

}  // namespace

double Exercise::points() const {
  double sum = 0;
  for (const CheckEntry& check : checks) sum += check.points;
  return sum;
}

std::string Exercise::name() const {
  return fs::path(file).stem().string();
}

double Assignment::report_points() const {
  double sum = 0;
  for (const Criterion& criterion : criteria) sum += criterion.points;
  return sum;
}

Assignment read_assignment(const fs::path& folder) {
  const Table root = Table::parse_file(folder / "assignment.toml");
  Assignment assignment;
  assignment.folder = folder;
  assignment.title = text(root, "title");
  assignment.deadline = root.instant("deadline");
  assignment.points = positive(root, "points");
  assignment.floor = number(root, "floor", 0, assignment.points);
  if (root.has("feedback")) assignment.holds_feedback_back = read_feedback(root);
  if (root.has("single_numbers")) {
    assignment.single_numbers = read_single_numbers(root.table("single_numbers"));
  }
  if (root.has("late")) assignment.late = read_late(root.table("late"));
  if (root.has("limits")) assignment.limits = read_limits(root.table("limits"));
  Exercises exercises(root, folder);
  const double sum = exercises.points();
  std::set<std::string> ids;
  for (const Table& table : root.tables("criterion")) {
    assignment.criteria.push_back(read_criterion(table, ids));
  }
  assignment.exercises = std::move(exercises).take();
  if (root.has("provided")) assignment.provided = read_provided(root, assignment.exercises);
  std::set<std::string> names;
  for (const Table& table : root.tables("quantity")) {
    assignment.quantities.push_back(read_quantity(table, names));
  }
  root.reject_unknown_keys();
  if (std::abs(sum - assignment.points) > rel_rounding * sum) {
    root.fail("points",
              fmt::format("{}, but the checks' points add up to {}", assignment.points, sum));
  }
  return assignment;
}

std::set<std::string> files_behind(const Assignment& assignment, const Exercise& exercise) {
  std::set<std::string> files = {exercise.file};
  for (const std::string& id : exercise.builds_on) {
    const auto other = std::ranges::find(assignment.exercises, id, &Exercise::id);
    files.merge(files_behind(assignment, *other));
  }
  return files;
}

double on_grid(const Quantity& quantity, std::uint64_t k) {
  // std::fma rounds once, whether or not the compiler itself would fuse the operations.
  const double exact = std::fma(static_cast<double>(k), quantity.step, quantity.from);
  return sys::parsed<double>(fmt::format("{:.12g}", exact)).value();
}

std::uint64_t n_values(const Quantity& quantity) {
  const double steps = (quantity.to - quantity.from) / quantity.step;
  return static_cast<std::uint64_t>(std::floor(steps * (1 + rel_rounding))) + 1;
}

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
