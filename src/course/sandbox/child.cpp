// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include "course/sandbox/descendants.hpp"
#include "system/error.hpp"

namespace course {
namespace {

/// What the child does between fork and exec.
class FileActions {
 public:
  explicit FileActions(const Child& child) {
    constexpr int written = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, child.input.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 1, child.output.c_str(), written, 0600);
    posix_spawn_file_actions_addopen(&actions_, 2, child.errors.c_str(), written, 0600);
    posix_spawn_file_actions_addopen(&actions_, 3, child.third.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions_, 4);
    posix_spawn_file_actions_addchdir_np(&actions_, child.folder.c_str());
  }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// The null-terminated array that exec takes; it points into `texts`.
std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// What the attendant tells: why the child could not start, or its status as of wait.
struct Report {
  int error = 0;
  int status = SIGKILL;
};

/// The attendant's life: it starts the child, tells how that ended, and stays until nothing is left
/// below it, as orphans become its own. It was forked from a process that may have threads, so it
/// allocates nothing.
[[noreturn]] void attend(const FileActions& actions, char* const* command, char* const* environment,
                         int reports) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  Report report;
  pid_t child = 0;
  report.error = posix_spawn(&child, command[0], actions.get(), nullptr, command, environment);
  if (report.error == 0) {
    pid_t ended = 0;
    do {
      ended = ::wait(&report.status);
    } while (ended != child && (ended > 0 || errno == EINTR));
  }
  while (::write(reports, &report, sizeof report) < 0 && errno == EINTR) {
  }
  while (::wait(nullptr) > 0 || errno == EINTR) {
  }
  ::_exit(0);
}

/// A child with the attendant above it.
class Attended {
 public:
  explicit Attended(const Child& child) {
    std::vector<std::string> command = child.command;
    std::vector<std::string> environment = child.environment;
    const std::vector<char*> command_pointers = pointers(command);
    const std::vector<char*> environment_pointers = pointers(environment);
    const FileActions actions(child);
    if (::pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0) fail(errno, child);
    attendant_ = ::fork();
    if (attendant_ == 0) {
      attend(actions, command_pointers.data(), environment_pointers.data(), pipe_[1]);
    }
    const int error = errno;
    ::close(pipe_[1]);
    if (attendant_ > 0) return;
    ::close(pipe_[0]);
    fail(error, child);
  }
  Attended(const Attended&) = delete;
  Attended& operator=(const Attended&) = delete;
  ~Attended() {
    end_all();
    ::close(pipe_[0]);
  }

  /// Waits for the child's end, and looks at what it uses 20 times a second: limits of single
  /// processes do not count what many hold together.
  Excess watch(const Child& child) {
    pollfd poll{pipe_[0], POLLIN, 0};
    for (int ready = 0; (ready = ::poll(&poll, 1, 50)) <= 0;) {
      if (ready < 0 && errno != EINTR) break;
      const Usage usage = usage_of(descendants(attendant_));
      if (child.memory_mb > 0 && usage.bytes > child.memory_mb * 1'048'576) return Excess::memory;
      if (child.cpu_seconds > 0 && usage.cpu_seconds > child.cpu_seconds) return Excess::time;
      if (child.tasks > 0 && usage.tasks > child.tasks) return Excess::tasks;
      if (has_ended()) break;  // something killed it
    }
    return Excess::none;
  }

  /// After watch() without excess.
  Report report() const {
    Report report;
    if (::read(pipe_[0], &report, sizeof report) != sizeof report) return {};
    return report;
  }

  [[noreturn]] static void fail(int error, const Child& child) {
    throw sys::ToolError(fmt::format("cannot start {}: {}", child.command.front(),
                                     std::generic_category().message(error)));
  }

 private:
  bool has_ended() {
    if (is_over_) return true;
    const pid_t ended = ::waitpid(attendant_, nullptr, WNOHANG);
    is_over_ = ended > 0 || (ended < 0 && errno != EINTR);
    return is_over_;
  }

  void end_all() {
    while (!has_ended()) {
      for (const pid_t process : descendants(attendant_)) ::kill(process, SIGKILL);
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  }

  std::array<int, 2> pipe_{};
  pid_t attendant_ = 0;
  bool is_over_ = false;
};

}  // namespace

ChildEnd run_child(const Child& child) {
  Attended attended(child);
  ChildEnd end;
  end.excess = attended.watch(child);
  if (end.excess != Excess::none) return end;
  const auto [error, status] = attended.report();
  if (error != 0) Attended::fail(error, child);
  end.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return end;
}

}  // namespace course
