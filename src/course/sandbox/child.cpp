// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "course/sandbox/descendants.hpp"
#include "system/spawn.hpp"

namespace course {
namespace {

void set_streams(sys::FileActions& actions, const Child& child) {
  constexpr int written = O_WRONLY | O_CREAT | O_TRUNC;
  actions.open(STDIN_FILENO, child.input, O_RDONLY);
  actions.open(STDOUT_FILENO, child.output, written, 0600);
  actions.open(STDERR_FILENO, child.errors, written, 0600);
  actions.open(3, child.third, O_RDONLY);
  actions.close_from(4);
  actions.change_folder(child.folder);
}

/// What the attendant reports: why the child could not start, or its status as of wait and the
/// processor time of all that were waited for.
struct Report {
  int error = 0;
  int status = SIGKILL;
  double cpu_seconds = 0;
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The attendant's life: it starts the child, reports how that ended, and stays until no process is
/// left below it, since orphans become its own. It was forked from a process that may have threads,
/// so it allocates nothing.
[[noreturn]] void attend(const sys::FileActions& actions, char* const* command,
                         char* const* environment, int reports) {
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
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    report.cpu_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
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
  explicit Attended(const Child& child) : pipe_(sys::open_pipe(O_NONBLOCK)) {
    std::vector<std::string> command = child.command;
    std::vector<std::string> environment = child.environment;
    const std::vector<char*> command_pointers = sys::exec_pointers(command);
    const std::vector<char*> environment_pointers = sys::exec_pointers(environment);
    sys::FileActions actions;
    set_streams(actions, child);
    attendant_ = ::fork();
    if (attendant_ == 0) {
      attend(actions, command_pointers.data(), environment_pointers.data(), pipe_.writing.number());
    }
    if (attendant_ < 0) throw sys::cannot_start(child.command.front(), errno);
    pipe_.writing.close();
  }
  Attended(const Attended&) = delete;
  Attended& operator=(const Attended&) = delete;
  ~Attended() { end_all(); }

  /// Waits for the child's end, and looks at what it uses 20 times a second, since limits of single
  /// processes do not count what many of them hold together. Time counts as waiting if none of them
  /// wanted a processor and none was used: on a busy machine a process that waits for its turn does
  /// not wait in this sense.
  Excess watch(const Child& child) {
    using Clock = std::chrono::steady_clock;
    pollfd poll{pipe_.reading.number(), POLLIN, 0};
    Clock::time_point last = Clock::now();
    std::chrono::duration<double> waited{};
    for (int ready = 0; (ready = ::poll(&poll, 1, 50)) <= 0;) {
      if (ready < 0 && errno != EINTR) break;
      const Usage usage = usage_of(descendants(attendant_));
      const Clock::time_point now = Clock::now();
      if (usage.is_waiting && usage.cpu_seconds <= cpu_seconds_) waited += now - last;
      last = now;
      cpu_seconds_ = usage.cpu_seconds;
      if (child.waiting_seconds > 0 && waited.count() > child.waiting_seconds) return Excess::time;
      if (child.memory_mb > 0 && usage.bytes > child.memory_mb * 1'048'576) return Excess::memory;
      if (child.cpu_seconds > 0 && usage.cpu_seconds > child.cpu_seconds) return Excess::time;
      if (child.tasks > 0 && usage.tasks > child.tasks) return Excess::tasks;
      if (has_ended()) break;  // something else killed the attendant
    }
    return Excess::none;
  }

  /// The processor time that watch() saw last.
  double cpu_seconds() const { return cpu_seconds_; }

  /// What the attendant reported; to be asked for after watch() found no excess.
  Report report() const {
    Report report;
    const ssize_t n_read = ::read(pipe_.reading.number(), &report, sizeof report);
    return n_read == sizeof report ? report : Report{};
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

  sys::Pipe pipe_;
  pid_t attendant_ = 0;
  double cpu_seconds_ = 0;
  bool is_over_ = false;
};

}  // namespace

ChildEnd run_child(const Child& child) {
  Attended attended(child);
  ChildEnd end;
  end.excess = attended.watch(child);
  end.cpu_seconds = attended.cpu_seconds();
  if (end.excess != Excess::none) return end;
  const auto [error, status, cpu_seconds] = attended.report();
  if (error != 0) throw sys::cannot_start(child.command.front(), error);
  end.cpu_seconds = std::max(end.cpu_seconds, cpu_seconds);
  end.status = sys::shell_status(status);
  return end;
}

}  // namespace course
