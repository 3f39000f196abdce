// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>
#include <string>

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"
#include "course/assignment/student.hpp"
#include "course/marking/grade.hpp"
#include "course/marking/toolkit.hpp"
#include "course/release/make_toolkit.hpp"
#include "course/release/markers.hpp"
#include "course/sandbox/sandbox.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

/// An assignment that compiles quickly, with two exercises of ten points each, `square` and `sum`.
namespace toy_grading {

inline const std::filesystem::path folder =
    std::filesystem::path(HALFSPACE_SOURCE_DIR) / "tests/course/toy_grading";

inline course::Assignment assignment() {
  using course::Visibility;
  course::Assignment toy;
  toy.folder = folder;
  toy.title = "Toy";
  toy.deadline = std::chrono::sys_days{std::chrono::year{2027} / 1 / 15} + std::chrono::hours(23);
  toy.points = 20;
  toy.provided = {"course/assignment/answer_channel.hpp", "course/assignment/check.hpp",
                  "course/assignment/own_tests.hpp", "course/assignment/replay.hpp",
                  "course/assignment/variant.hpp"};
  toy.late = {.percent_per_day = 10, .days = 5};
  toy.limits = {.compile_seconds = 10,
                .run_seconds = 1,
                .memory_mb = 512,
                .processes = 8,
                .output_kb = 16,
                .file_kb = 64,
                .submission_mb = 1};
  toy.exercises = {
      {.id = "square",
       .title = "Squares",
       .file = "src/square.cpp",
       .builds_on = {},
       .checks = {{"square-growth", 4, Visibility::visible,
                   "the square of -x is that of x, that of 2x four times as much", ""},
                  {"square-values", 6, Visibility::hidden, "squares at points of your own", ""}}},
      {.id = "sum",
       .title = "Sums",
       .file = "src/sum.cpp",
       .builds_on = {"square"},
       .checks = {{"sum-order", 5, Visibility::visible, "the order does not matter", ""},
                  {"sum-values", 5, Visibility::hidden, "a sum of numbers of your own", ""}}}};
  return toy;
}

inline course::Outcome equal(const course::Numbers& given, const course::Numbers& expected) {
  return given == expected ? course::Outcome{1, ""} : course::Outcome{0, "differs"};
}

inline course::Checks checks() {
  using course::Numbers;
  using course::Outcome;
  using course::Program;
  using course::Variant;
  return {{"square-growth",
           [](const Program& program, const Variant&) {
             const Numbers squares = program("square", {2.385, -2.385, 4.77});
             const bool holds = squares.size() == 3 && squares[0] > 0 && squares[0] == squares[1] &&
                                squares[2] == 4 * squares[0] && squares[0] > 4.5;
             return holds ? Outcome{1, ""} : Outcome{0, "does not grow as a square"};
           }},
          {"square-values",
           [](const Program& program, const Variant&) {
             return equal(program("square", {7.25, 0.5}), {52.5625, 0.25});
           }},
          {"sum-order",
           [](const Program& program, const Variant&) {
             const Numbers answer = program("sum", {0.5, 1.25});
             if (answer.size() != 1 || answer[0] == 0) return Outcome{0, "is no sum"};
             return equal(answer, program("sum", {1.25, 0.5}));
           }},
          {"sum-values", [](const Program& program, const Variant&) {
             return equal(program("sum", {0.5, 1.25, 7}), {8.75});
           }}};
}

/// The instructor's files.
inline course::Files solution() {
  course::Files files;
  for (const char* file : {"src/square.cpp", "src/sum.cpp"}) {
    files[file] = course::apply_markers(sys::read_file(folder / "template" / file), file).solution;
  }
  return files;
}

/// The toolkit, compiled when it is first asked for.
inline const std::filesystem::path& toolkit() {
  static const TemporaryFolder made;
  static const std::filesystem::path path = [] {
    course::make_toolkit(assignment(), HALFSPACE_SOURCE_DIR, made.path() / "toolkit");
    course::make_readable(made.path());
    return made.path() / "toolkit";
  }();
  return path;
}

/// Writes files into the folder `name` and returns its path.
inline std::filesystem::path write(const TemporaryFolder& to, const std::string& name,
                                   const course::Files& files) {
  for (const auto& [file, text] : files) to.write(name + "/" + file, text);
  return to.path() / name;
}

/// The task to grade a submission by the checks of the toy.
inline course::GradingTask task_for(const std::filesystem::path& submission,
                                    const std::filesystem::path& with = toolkit()) {
  course::GradingTask task;
  task.submission = submission;
  task.student = course::student_of(submission);
  task.toolkit = with;
  task.checks = checks();
  return task;
}

}  // namespace toy_grading
