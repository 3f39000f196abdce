// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/own_tests.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <sstream>
#include <utility>

#include "course/assignment/student.hpp"
#include "course/marking/build.hpp"
#include "course/marking/compiler.hpp"
#include "course/marking/program_run.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr int most_runs = 300;  ///< of tests whose questions depend on the answers

/// What tests ask, and what a program answers to it, a line each.
struct Talk {
  std::vector<std::string> questions;
  std::vector<std::string> answers = {};
};

/// What tests say of a program.
struct Verdict {
  std::string failure;  ///< why they say nothing, as «took longer than 5 s»
  int n_checks = 0;
  int rejecting_line = 0;  ///< of the first check that does not hold; 0 if all do

  bool accepts() const { return failure.empty() && rejecting_line == 0; }
  bool rejects() const { return failure.empty() && rejecting_line != 0; }
};

/// The lines of an output that came to their end.
std::vector<std::string> whole_lines(std::string text) {
  text.resize(text.rfind('\n') + 1);  // nothing, if there is none
  std::vector<std::string> lines;
  for (const std::string_view line : sys::lines_of(text)) lines.emplace_back(line);
  return lines;
}

std::string text_of(const std::vector<std::string>& lines) {
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

/// Whether all questions begin with the same word.
bool are_about_one_task(const std::vector<std::string>& questions) {
  const auto task_of = [](const std::string& line) { return line.substr(0, line.find(' ')); };
  return std::ranges::all_of(questions, [&](const std::string& question) {
    return task_of(question) == task_of(questions.front());
  });
}

/// Runs the program `folder`/tests.
class TestsRun {
 public:
  TestsRun(const Assignment& assignment, double seconds_left, fs::path folder, Isolation isolation)
      : limits_(assignment.limits),
        seconds_for_all_(std::max(
            1, limits_.submission_seconds / static_cast<int>(assignment.exercises.size() + 1))),
        seconds_left_(seconds_left),
        folder_(std::move(folder)),
        sandbox_(isolation, folder_) {}

  /// Of a program; the talk begins with questions that may be asked, and ends with those that are.
  Verdict verdict_on(const fs::path& program, Talk& talk);

  /// Once more, of a program that is known by its talk.
  Verdict repeated(const Talk& talk) {
    if (took_too_long()) return {too_long()};
    auto [asked, verdict] = run_tests(talk);
    return asked == talk.questions ? verdict : Verdict{"ask other questions each time"};
  }

 private:
  std::pair<std::vector<std::string>, Verdict> run_tests(const Talk& talk);
  std::vector<std::string> answers_of(const fs::path& program,
                                      const std::vector<std::string>& questions);
  std::vector<std::string> run(const fs::path& program, const std::vector<std::string>& arguments,
                               const std::string& text, JobEnd& end);
  double seconds_of_limit() const { return std::min<double>(seconds_for_all_, seconds_left_); }
  bool took_too_long() const { return seconds_ > seconds_of_limit(); }
  std::string too_long() const {
    return seconds_left_ < seconds_for_all_
               ? fmt::format("took longer than what all answers had left of {} s",
                             limits_.submission_seconds)
               : fmt::format("took longer than {} s in all", seconds_for_all_);
  }

  Limits limits_;
  int seconds_for_all_;
  double seconds_left_;  ///< of those that the whole submission has
  fs::path folder_;
  Sandbox sandbox_;
  double seconds_ = 0;
};

std::vector<std::string> TestsRun::run(const fs::path& program,
                                       const std::vector<std::string>& arguments,
                                       const std::string& text, JobEnd& end) {
  const int left = std::max(1, static_cast<int>(std::ceil(seconds_of_limit() - seconds_)));
  end =
      run_on_text(sandbox_, limits_, program, arguments, text, std::min(left, limits_.run_seconds));
  seconds_ += end.seconds;
  const auto max_bytes = static_cast<std::size_t>(limits_.output_kb) * 1024;
  return whole_lines(beginning_of(folder_ / "output", max_bytes));
}

/// The program is there only while it answers, so that tests never find it, not even without walls.
std::vector<std::string> TestsRun::answers_of(const fs::path& program,
                                              const std::vector<std::string>& questions) {
  if (questions.empty()) return {};
  const fs::path copy = folder_ / "program";
  fs::copy_file(program, copy, fs::copy_options::overwrite_existing);
  make_executable(copy);
  JobEnd end;
  auto answers = run(copy, {"-"}, text_of(questions), end);
  fs::remove(copy);
  answers.resize(questions.size());  // there are fewer if the program came to no end
  return answers;
}

std::pair<std::vector<std::string>, Verdict> TestsRun::run_tests(const Talk& talk) {
  JobEnd end;
  std::pair<std::vector<std::string>, Verdict> result;
  auto& [asked, verdict] = result;
  bool has_ended = false;
  for (const std::string& line : run(folder_ / "tests", {}, text_of(talk.answers), end)) {
    if (line.starts_with("? ")) asked.push_back(line.substr(2));
    if (!line.starts_with(". ")) continue;
    std::istringstream(line.substr(2)) >> verdict.n_checks >> verdict.rejecting_line;
    has_ended = true;
  }
  verdict.failure = failure_of(limits_, end);
  if (verdict.failure.empty() && !has_ended) verdict.failure = "ended before their last check";
  return result;
}

Verdict TestsRun::verdict_on(const fs::path& program, Talk& talk) {
  for (int i = 0; i < most_runs && !took_too_long(); ++i) {
    talk.answers = answers_of(program, talk.questions);
    auto [asked, verdict] = run_tests(talk);
    if (asked == talk.questions) return verdict;
    if (!are_about_one_task(asked)) return {"asked about several tasks"};
    talk.questions = std::move(asked);
  }
  return {took_too_long() ? too_long()
                          : fmt::format("asked more than {} questions one after the other, each of "
                                        "which depends on the answer before",
                                        most_runs)};
}

/// The line of a text, for a message; nothing else that tests said of the right program is told.
std::string shown_line(const std::string& text, int number) {
  const auto lines = sys::lines_of(text);
  if (number < 1 || number > static_cast<int>(lines.size())) return "a check";
  const auto line = sys::stripped(lines[static_cast<std::size_t>(number - 1)]);
  return fmt::format("line {}, «{}»", number, shown_name(line));
}

/// Compiles the tests to `folder`/tests, and takes its time off what is left. Returns the message
/// of compiler or linker, empty if it worked.
std::string compile(const OwnTestsTask& task, const Exercise& exercise, const fs::path& folder,
                    double& seconds_left) {
  fs::create_directories(folder);
  Assignment assignment = task.assignment;
  assignment.limits.submission_seconds = static_cast<int>(std::ceil(seconds_left));
  Compiler compiler(assignment, task.toolkit, folder, task.isolation);
  compiler.write_project(task.assignment, {{exercise.tests, task.files.at(exercise.tests)}});
  std::string error = compiler.compile(exercise.tests, folder / "tests.o");
  if (error.empty()) {
    compiler.use_object(compiler.toolkit().replay_object());
    error = compiler.link({{folder / "tests.o", "/objects/tests.o"}}, folder / "tests");
  }
  seconds_left -= compiler.seconds();
  if (error.empty()) make_executable(folder / "tests");
  return error;
}

constexpr const char* the_right_one = "";

/// The wrong programs, and the right one as often, or a few times if they are few, in an order that
/// nobody can foresee: tests that follow the clock or count their runs are out of step with it.
std::vector<std::string> shuffled_with_the_right_one(std::vector<std::string> programs) {
  constexpr std::size_t fewest = 6;
  programs.insert(programs.end(), std::max(programs.size(), fewest), the_right_one);
  std::ranges::shuffle(programs, std::mt19937_64(std::random_device{}()));
  return programs;
}

Outcome outcome_of(const OwnTestsTask& task, const Exercise& exercise,
                   std::vector<std::string>& missed) {
  const auto file = task.files.find(exercise.tests);
  if (file == task.files.end()) return {0, exercise.tests + " was not taken"};
  const fs::path folder = fs::absolute(task.scratch) / exercise.id;
  double seconds_left = task.assignment.limits.submission_seconds - task.seconds_so_far();
  if (seconds_left <= 0) return {0, "all answers took the time that there is for the tests, too"};
  const std::string error = compile(task, exercise, folder, seconds_left);
  if (!error.empty()) return {0, fmt::format("{} is not compiled: {}", exercise.tests, error)};

  TestsRun run(task.assignment, seconds_left, folder, task.isolation);
  const fs::path programs = open_toolkit(task.assignment, task.toolkit).programs_of(exercise.id);
  Talk right;
  const Verdict verdict = run.verdict_on(programs / "right", right);
  const auto fault = [&](const std::string& what) {
    return Outcome{0, fmt::format("your tests {}", what)};
  };
  if (!verdict.failure.empty())
    return fault(verdict.failure + " when they tried the right program");
  if (verdict.rejects()) {
    return fault("reject the right program: " + shown_line(file->second, verdict.rejecting_line));
  }
  if (verdict.n_checks == 0) return fault("check nothing");
  const std::vector<std::string> wrong = sys::files_below(programs / "wrong");
  std::set<std::string> caught;
  for (const std::string& id : shuffled_with_the_right_one(wrong)) {
    if (id == the_right_one) {
      const Verdict again = run.repeated(right);
      if (again.accepts()) continue;
      return fault(again.failure.empty()
                       ? "do not always accept the right program"
                       : again.failure + " when they tried the right program again");
    }
    Talk talk{right.questions};
    if (run.verdict_on(programs / "wrong" / id, talk).rejects()) caught.insert(id);
  }
  for (const std::string& id : wrong) {
    if (!caught.contains(id)) {
      missed.push_back(fmt::format("{} does not catch {}", exercise.tests, id));
    }
  }
  return {static_cast<double>(caught.size()) / static_cast<double>(wrong.size()),
          fmt::format("your tests catch {} of {} wrong programs", caught.size(), wrong.size())};
}

/// Adds the check of each exercise that asks for tests, with what `outcome` makes of the exercise.
template <class MakeOutcome>
Checks with_checks_of_tests(Checks checks, const Assignment& assignment,
                            const MakeOutcome& outcome) {
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) {
      if (entry.visibility != Visibility::tests) continue;
      checks[entry.id] = [outcome, &exercise](const Program&, const Variant&) {
        return outcome(exercise);
      };
    }
  }
  return checks;
}

}  // namespace

Checks with_own_tests(Checks checks, const OwnTestsTask& task, std::vector<std::string>& missed) {
  return with_checks_of_tests(
      std::move(checks), task.assignment,
      [task, &missed](const Exercise& exercise) { return outcome_of(task, exercise, missed); });
}

Checks without_own_tests(Checks checks, const Assignment& assignment, double share) {
  return with_checks_of_tests(std::move(checks), assignment, [share](const Exercise&) {
    return Outcome{share, "the tests were not tried"};
  });
}

}  // namespace course
