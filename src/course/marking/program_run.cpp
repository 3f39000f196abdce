// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/program_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>

#include "course/assignment/student.hpp"
#include "system/decimal.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// Whether this is what printf writes for a NaN or an infinity.
bool is_not_finite(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  return word == "nan" || word == "inf";
}

/// What a program said on standard error, in a line.
std::string said_in(const fs::path& errors) {
  constexpr std::size_t most = 1000;
  std::string line;
  const std::string text = shown(beginning_of(errors, 2 * most), most);
  for (std::string_view part : sys::lines_of(text)) {
    part.remove_prefix(std::min(part.find_first_not_of(" \t"), part.size()));
    if (part.empty()) continue;
    if (!line.empty()) line += "; ";
    line += part;
  }
  return line;
}

}  // namespace

Numbers parse_answer(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  Numbers numbers;
  for (auto begin = text.find_first_not_of(blank); begin != text.npos;
       begin = text.find_first_not_of(blank)) {
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(blank));
    const auto number = sys::parsed<double>(word);
    if (number && std::isfinite(*number)) {
      numbers.push_back(*number);
    } else if (is_not_finite(word)) {
      numbers.push_back(std::numeric_limits<double>::quiet_NaN());
    } else {
      throw ProgramFailure("the program's answer holds something that is no decimal number");
    }
    text.remove_prefix(word.size());
  }
  if (numbers.empty()) throw ProgramFailure("the program answered nothing");
  return numbers;
}

bool is_same_answer(const Numbers& first, const Numbers& second, std::size_t n_single) {
  constexpr double relative = 1e-10;
  constexpr double of_the_largest = 1e-13;
  if (first.size() != second.size()) return false;
  double largest = 0;
  for (std::size_t i = n_single; i < first.size(); ++i) {
    largest = std::fmax(largest, std::abs(first[i]));
  }
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double a = first[i], b = second[i];
    if (std::isnan(a) && std::isnan(b)) continue;
    const double of_its_kind = i < n_single ? 0 : of_the_largest * largest;
    if (!(std::abs(a - b) <= std::max(relative * std::abs(a), of_its_kind))) return false;
  }
  return true;
}

ProgramRun::ProgramRun(const Assignment& assignment, const Built& built, Isolation isolation)
    : limits_(assignment.limits),
      single_numbers_(assignment.single_numbers),
      exercise_seconds_(std::max(
          1, limits_.submission_seconds / static_cast<int>(assignment.exercises.size() + 1))),
      common_(fs::absolute(built.program)),
      program_(common_),
      tells_errors_(isolation == Isolation::sandbox),
      sandbox_(isolation, program_.parent_path()),
      seconds_(built.seconds) {}

std::string failure_of(const Limits& limits, const JobEnd& end) {
  switch (end.ending) {
    case Ending::too_slow:
      return fmt::format("took longer than {} s", limits.run_seconds);
    case Ending::too_large:
      return fmt::format("used more than {} MB", limits.memory_mb);
    case Ending::too_many_processes:
      return fmt::format("started more than {} processes and threads", limits.processes);
    case Ending::too_much_output:
      return fmt::format("wrote more than {} kB", limits.output_kb);
    case Ending::crash:
      return "crashed";
    case Ending::normal:
      break;
  }
  return end.status == 0 ? "" : "ended with a failure";
}

std::string ProgramRun::failure_of(const JobEnd& end) const {
  std::string failure = course::failure_of(limits_, end);
  if (failure.empty()) return "";
  failure.insert(0, "the program ");
  if (end.ending == Ending::crash) {
    const char* name = ::sigabbrev_np(end.status);
    failure +=
        name == nullptr ? fmt::format(" (signal {})", end.status) : fmt::format(" (SIG{})", name);
  }
  const bool may_say_why = end.ending == Ending::crash || end.ending == Ending::normal;
  return may_say_why ? with_errors(failure) : failure;
}

std::string ProgramRun::with_errors(const std::string& failure) const {
  const std::string said = said_in(program_.parent_path() / "errors");
  // So say the libraries of C++ and of OpenMP if they cannot start a thread.
  if (said.find("Resource temporarily unavailable") != said.npos) {
    return fmt::format(
        "the program started more than {} processes and threads, or they needed more "
        "than {} MB",
        limits_.processes, limits_.memory_mb);
  }
  // Without walls it may be what stands in a file of the teacher.
  return said.empty() || !tells_errors_ ? failure : failure + " and said: " + said;
}

JobEnd run_on_text(const Sandbox& sandbox, const Limits& limits, const fs::path& program,
                   const std::vector<std::string>& arguments, const std::string& text,
                   int seconds) {
  const fs::path folder = program.parent_path();
  sys::write_file_atomically(folder / "input", text);
  const Readable readable{program, "/program"};
  Job job;
  job.command = {sandbox.place(readable)};
  job.command.insert(job.command.end(), arguments.begin(), arguments.end());
  job.readable = {readable};
  job.input = folder / "input";
  job.output = folder / "output";
  job.errors = folder / "errors";
  job.seconds = seconds;
  job.memory_mb = limits.memory_mb;
  job.processes = limits.processes;
  job.file_kb = limits.output_kb;
  return sandbox.run(job);
}

JobEnd ProgramRun::run(const std::string& task, const Numbers& inputs, const Numbers& before) {
  std::string text;
  for (const double number : before) text += fmt::format("{}\n", number);
  if (!before.empty()) text += ";\n";
  for (const double number : inputs) text += fmt::format("{}\n", number);

  const int left = std::max(1, limits_.submission_seconds - static_cast<int>(seconds_));
  const int seconds = before.empty() ? limits_.run_seconds : 2 * limits_.run_seconds;
  const JobEnd end =
      run_on_text(sandbox_, limits_, program_, {task}, text, std::min(left, seconds));
  seconds_ += end.seconds;
  seconds_of_[program_] += end.seconds;
  return end;
}

/// Which limit of several answers was exceeded; empty if none was.
std::string ProgramRun::excess() const {
  if (seconds_ > limits_.submission_seconds) {
    return fmt::format("compiling and all answers together took more than {} s",
                       limits_.submission_seconds);
  }
  const auto spent = seconds_of_.find(program_);
  if (program_ == common_ || spent == seconds_of_.end() || spent->second <= exercise_seconds_) {
    return "";
  }
  return fmt::format("all answers of the exercise together took more than {} s", exercise_seconds_);
}

ProgramRun::Answer ProgramRun::ask_once(const std::string& task, const Numbers& inputs,
                                        const Numbers& before) {
  std::string excess = this->excess();
  if (!excess.empty()) return {{}, std::move(excess), 0};
  const JobEnd end = run(task, inputs, before);
  Answer answer{{}, failure_of(end), end.seconds};
  if (end.ending == Ending::too_slow) given_up_[task] = answer.failure;
  if (!answer.failure.empty()) return answer;
  try {
    const auto max_bytes = static_cast<std::size_t>(limits_.output_kb) * 1024;
    answer.numbers = parse_answer(beginning_of(program_.parent_path() / "output", max_bytes));
  } catch (const ProgramFailure& failure) {
    answer.failure = failure.what();
  }
  return answer;
}

ProgramRun::Answer ProgramRun::ask(const std::string& task, const Numbers& inputs) {
  const Answer first = ask_once(task, inputs, {});
  if (!first.failure.empty()) return first;
  const bool is_quick = first.seconds < 0.25 * limits_.run_seconds;
  Numbers& last = last_[{program_, task}];
  const Numbers before = is_quick ? last : Numbers{};
  if (is_quick) last = inputs;
  const Answer second = ask_once(task, inputs, before);
  const bool is_over = given_up_.contains(task) || !excess().empty();
  if (!second.failure.empty() && is_over) return second;
  const auto single = single_numbers_.find(task);
  const std::size_t n_single = single == single_numbers_.end() ? 0 : single->second;
  if (second.failure.empty() && is_same_answer(first.numbers, second.numbers, n_single))
    return first;
  const std::string failure = "the program gives different answers to the same question";
  return {{}, before.empty() ? failure : failure + ", asked alone and after another one", 0};
}

bool ProgramRun::was_asked(const std::string& task) const {
  return std::ranges::any_of(answers_,
                             [&](const auto& known) { return std::get<1>(known.first) == task; });
}

Numbers ProgramRun::answer(const std::string& task, const Numbers& inputs) {
  const auto key = std::tuple{program_, task, inputs};
  auto known = answers_.find(key);
  if (known == answers_.end()) {
    const auto failure = given_up_.find(task);
    known = answers_
                .emplace(key, failure == given_up_.end() ? ask(task, inputs)
                                                         : Answer{{}, failure->second, 0})
                .first;
  }
  if (!known->second.failure.empty()) throw ProgramFailure(known->second.failure);
  return known->second.numbers;
}

}  // namespace course
