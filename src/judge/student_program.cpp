// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge/student_program.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

namespace judge {
namespace {

using Clock = std::chrono::steady_clock;

// Seconds for a question, which an honest program answers within milliseconds.
constexpr double most_patience = 10;
constexpr std::size_t max_answer_bytes = 1 << 20;
const char* const unasked = "the program wrote an answer without a question";
const char* const too_slow = "the program did not answer in time";

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Returns the line "TASK number number …", with all digits.
std::string question_of(const std::string& task, const Numbers& inputs) {
  std::string line = task;
  for (const double input : inputs) {
    char digits[40];
    std::snprintf(digits, sizeof digits, " %.17g", input);
    line += digits;
  }
  return line + '\n';
}

bool has_something_to_read(int channel, double seconds) {
  pollfd waiting{channel, POLLIN, 0};
  return ::poll(&waiting, 1, static_cast<int>(1000 * seconds)) > 0;
}

}  // namespace

Numbers numbers_of_line(const std::string& line) {
  Numbers numbers;
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at != end) {
    if (*at == ' ') {
      ++at;
      continue;
    }
    double number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || (next != end && *next != ' ')) {
      throw NoAnswer("the program's answer contains text that is not a decimal number");
    }
    numbers.push_back(number);
    at = next;
  }
  if (numbers.empty()) throw NoAnswer("the program's answer is empty");
  return numbers;
}

StudentProgram::StudentProgram(std::vector<std::string> command, double seconds)
    : command_(std::move(command)),
      patience_(std::min(most_patience, seconds / 2)),
      seconds_left_(seconds) {}

StudentProgram::~StudentProgram() {
  stop();
}

Numbers StudentProgram::answer(const std::string& task, const Numbers& inputs) {
  const std::string question = question_of(task, inputs);
  auto known = known_.find(question);
  if (known == known_.end()) {
    if (seconds_left_ <= 0) throw NoAnswer(too_slow);
    const Clock::time_point begin = Clock::now();
    known = known_.emplace(question, ask(question)).first;
    seconds_left_ -= seconds_since(begin);
  }
  if (!known->second.failure.empty()) throw NoAnswer(known->second.failure);
  return known->second.numbers;
}

StudentProgram::Answer StudentProgram::ask(const std::string& question) {
  try {
    if (process_ < 0) start();
    if (has_something_to_read(channel_, 0)) {
      read_line();  // throws if the program has ended
      throw NoAnswer(unasked);
    }
    ::send(channel_, question.data(), question.size(), MSG_NOSIGNAL);
    const std::string line = read_line();
    if (line.empty()) return {{}, "the program has no answer"};  // but it can answer the next one
    return {numbers_of_line(line), ""};
  } catch (const NoAnswer& e) {
    stop();
    return {{}, e.what()};
  }
}

// Reads one line of output, without the line end. Throws NoAnswer for no line or several.
std::string StudentProgram::read_line() {
  const double seconds = std::min(patience_, seconds_left_);
  const Clock::time_point begin = Clock::now();
  std::string text;
  while (text.find('\n') == text.npos) {
    const double left = seconds - seconds_since(begin);
    if (left <= 0 || !has_something_to_read(channel_, left)) throw NoAnswer(too_slow);
    char chunk[65536];
    const auto n = ::recv(channel_, chunk, sizeof chunk, 0);
    if (n <= 0) throw NoAnswer(reason_of_exit());
    text.append(chunk, static_cast<std::size_t>(n));
    if (text.size() > max_answer_bytes) throw NoAnswer("the program's answer is too long");
  }
  const std::size_t end = text.find('\n');
  if (end + 1 != text.size()) throw NoAnswer(unasked);
  return text.substr(0, end);
}

// Returns the message for the student after the program has closed its channel.
std::string StudentProgram::reason_of_exit() const {
  siginfo_t end{};
  for (int tries = 0; tries < 1000 && end.si_pid == 0; ++tries) {
    ::usleep(1000);
    ::waitid(P_PID, static_cast<id_t>(process_), &end, WEXITED | WNOHANG | WNOWAIT);
  }
  // A shell or a sandbox reports a signal as exit code 128 + signal.
  const int signal = end.si_code == CLD_EXITED ? end.si_status - 128 : end.si_status;
  if (signal == SIGXCPU) return "the program used up its processor time";
  const char* name = signal > 0 ? ::sigabbrev_np(signal) : nullptr;
  if (name == nullptr) return "the program ended before it answered";
  return std::string("the program crashed (SIG") + name + ")";
}

void StudentProgram::start() {
  if (n_starts_left_ <= 0)
    throw NoAnswer("the program failed too often before and was not started again");
  --n_starts_left_;
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot make a channel");
  }
  std::vector<char*> words;
  for (std::string& word : command_) words.push_back(word.data());
  words.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    ::setpgid(0, 0);
    ::dup2(ends[1], STDIN_FILENO);
    ::dup2(ends[1], STDOUT_FILENO);
    ::execvp(words[0], words.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  channel_ = ends[0];
  if (process_ < 0)
    throw std::system_error(errno, std::generic_category(), "cannot start a process");
}

void StudentProgram::stop() {
  if (channel_ >= 0) ::close(std::exchange(channel_, -1));
  if (process_ < 0) return;
  ::kill(-process_, SIGKILL);
  ::kill(process_, SIGKILL);
  ::waitpid(std::exchange(process_, -1), nullptr, 0);
}

}  // namespace judge
