// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "system/decimal.hpp"
#include "system/error.hpp"
#include "system/spawn.hpp"

namespace sys {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> merged_environment(const std::map<std::string, std::string>& added) {
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!added.contains(text.substr(0, text.find('=')))) environment.push_back(text);
  }
  for (const auto& [name, value] : added) environment.push_back(name + "=" + value);
  return environment;
}

using Clock = std::chrono::steady_clock;

/// When a program that begins now has to be ended; none for no limit.
std::optional<Clock::time_point> deadline(const TimeLimit& limit) {
  if (limit.seconds == 0) return std::nullopt;
  const int allowed = given_limit().value_or(limit.seconds);
  if (allowed == 0) return std::nullopt;
  return Clock::now() + std::chrono::seconds(allowed);
}

/// Waits until something can be read; returns whether that was before the deadline.
bool is_readable_before(int descriptor, std::optional<Clock::time_point> deadline) {
  for (;;) {
    int wait_ms = -1;
    if (deadline) {
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(*deadline - Clock::now()).count();
      wait_ms = static_cast<int>(std::clamp<long>(left + 1, 0, 1'000'000'000));
    }
    pollfd waited{.fd = descriptor, .events = POLLIN, .revents = 0};
    const int n_ready = ::poll(&waited, 1, wait_ms);
    if (n_ready > 0 || (n_ready < 0 && errno != EINTR)) return true;
    if (deadline && Clock::now() >= *deadline) return false;
  }
}

/// Appends all that is written until the last writer closes; returns whether that was in time.
bool read_to_end(int descriptor, std::optional<Clock::time_point> deadline, std::string& text) {
  std::array<char, 4096> buffer;
  while (is_readable_before(descriptor, deadline)) {
    const ssize_t n_read = ::read(descriptor, buffer.data(), buffer.size());
    if (n_read > 0) text.append(buffer.data(), static_cast<std::size_t>(n_read));
    if (n_read == 0 || (n_read < 0 && errno != EINTR)) return true;
  }
  return false;
}

/// Ends a child and all that it started, which would otherwise go on writing.
void end_with_descendants(pid_t child) {
  std::vector<pid_t> ended = descendants(child);
  ended.push_back(child);
  for (const pid_t process : ended) ::kill(process, SIGKILL);
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return shell_status(status);
}

}  // namespace

std::optional<int> given_limit() {
  const char* variable = std::getenv("LITERATE_TIMEOUT");
  if (variable == nullptr) return std::nullopt;
  const std::string_view text = variable;
  const int seconds = text.empty() ? 0 : parsed<int>(text).value_or(-1);
  if (seconds < 0 || seconds > 10'000'000) {
    throw InputError(fmt::format("TIMEOUT: '{}' is not a number of seconds, 0 to 10000000", text));
  }
  return seconds;
}

fs::path find_tool(std::string_view program) {
  const char* variable = std::getenv("PATH");
  std::string_view folders = variable == nullptr ? "" : variable;
  while (!folders.empty()) {
    const auto colon = folders.find(':');
    const fs::path candidate = fs::absolute(fs::path(folders.substr(0, colon)) / program);
    if (::access(candidate.c_str(), X_OK) == 0 && fs::is_regular_file(candidate)) return candidate;
    folders = colon == std::string_view::npos ? "" : folders.substr(colon + 1);
  }
  const char* setup = std::getenv("LITERATE_SETUP");
  if (setup == nullptr) throw ToolError(fmt::format("{} is not installed", program));
  throw ToolError(
      fmt::format("{} is not installed; '{}' installs what packages.txt lists", program, setup));
}

std::string end_of(const ProcessResult& result) {
  const int signal = result.exit_status - 128;
  if (signal <= 0 || signal >= NSIG) return fmt::format("status {}", result.exit_status);
  return fmt::format("signal {} ({})", signal, ::strsignal(signal));
}

ProcessResult run(const Command& command) {
  const auto until = deadline(command.limit);
  fs::path program = find_tool(command.program);
  std::vector<std::string> arguments{command.program};
  if (command.ends_with_caller) {
    // In this order: whose caller is gone before setpriv could look has not yet blocked its signal.
    arguments = {"setpriv", "--pdeathsig", "KILL", "env", "--block-signal=INT", program};
    program = find_tool("setpriv");
  }
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  Pipe pipe = open_pipe();
  FileActions actions;
  actions.change_folder(command.working_directory);
  actions.open(STDIN_FILENO, "/dev/null", O_RDONLY);
  actions.duplicate(pipe.writing.number(), STDOUT_FILENO);
  actions.duplicate(pipe.writing.number(), STDERR_FILENO);

  std::vector<std::string> environment = merged_environment(command.environment);
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), actions.get(), nullptr,
                                exec_pointers(arguments).data(), exec_pointers(environment).data());
  if (error != 0) throw cannot_start(command.program, error);

  pipe.writing.close();
  ProcessResult result;
  const auto begin = Clock::now();
  const bool is_in_time = read_to_end(pipe.reading.number(), until, result.output);
  if (!is_in_time) end_with_descendants(child);
  result.exit_status = wait_for(child);
  if (!is_in_time) {
    throw ToolError(fmt::format(
        "{}: {} has not ended after {} s and was stopped; LITERATE_TIMEOUT=seconds allows more, 0 "
        "any time",
        command.limit.what, command.program,
        std::chrono::round<std::chrono::seconds>(Clock::now() - begin).count()));
  }
  return result;
}

std::string tool_version(const std::string& program) {
  const ProcessResult result = run({.program = program, .arguments = {"--version"}});
  return result.output.substr(0, result.output.find('\n'));
}

std::string read_proc_file(const std::filesystem::path& file) {
  const std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();  // stops at an error, where stream iterators would throw
  return text.str();
}

std::vector<pid_t> processes_in(const fs::path& folder) {
  std::vector<pid_t> processes;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (const auto number = parsed<pid_t>(entry->path().filename().string())) {
      processes.push_back(*number);
    }
  }
  return processes;
}

std::vector<pid_t> descendants(pid_t process) {
  std::vector<pid_t> found = {process};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const fs::path tasks = fs::path("/proc") / std::to_string(found[i]) / "task";
    for (const pid_t task : processes_in(tasks)) {
      std::istringstream children(read_proc_file(tasks / std::to_string(task) / "children"));
      for (pid_t child = 0; children >> child;) found.push_back(child);
    }
  }
  found.erase(found.begin());
  return found;
}

}  // namespace sys
