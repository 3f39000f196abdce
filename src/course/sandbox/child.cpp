// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <random>
#include <thread>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "system/spawn.hpp"
#include "system/text.hpp"

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

/// What the attendant reports when the child has ended: why it could not start, or its status as of
/// wait.
struct AttendantsReport {
  int error = 0;
  bool is_unlimited = false;  ///< because the kernel refused, so nothing was started
  int status = SIGKILL;
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The processor time of all children that were waited for, and of theirs.
double seconds_of_children() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

template <class T>
void send(int pipe, const T& message) {
  while (::write(pipe, &message, sizeof message) < 0 && errno == EINTR) {
  }
}

using Filter = std::vector<sock_filter>;

Filter read_filter(const std::filesystem::path& file) {
  if (file.empty()) return {};
  const std::string bytes = sys::read_file(file);
  Filter filter(bytes.size() / sizeof(sock_filter));
  std::memcpy(filter.data(), bytes.data(), filter.size() * sizeof(sock_filter));
  return filter;
}

/// The fence of a child that may not write everywhere. Its streams are files that exist then, since
/// it can make none elsewhere.
sys::Descriptor fence_of(const Child& child) {
  if (child.writable.empty()) return sys::Descriptor();
  std::vector<std::filesystem::path> writable = child.writable;
  for (const std::filesystem::path& stream : {child.output, child.errors}) {
    const sys::Descriptor made(::open(stream.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    writable.push_back(stream);
  }
  return write_fence(writable);
}

/// Refuses this process and all that it starts what the filter refuses. Returns whether the kernel
/// does so.
bool install(Filter& filter) {
  if (filter.empty()) return true;
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
}

/// Kills the children of this thread, as many as one look finds. Returns whether it could look.
bool kill_children() {
  const int list = ::open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (list < 0) return false;
  std::array<char, 4096> text;
  const ssize_t n_read = ::read(list, text.data(), text.size());
  ::close(list);
  pid_t child = 0;
  for (ssize_t i = 0; i < n_read; ++i) {
    const char c = text[static_cast<std::size_t>(i)];
    if (sys::is_digit(c)) {
      child = 10 * child + (c - '0');
    } else if (child > 0) {
      ::kill(child, SIGKILL);
      child = 0;
    }
  }
  return true;
}

/// The attendant's end if the process that watches the job was killed: the job ends first, with all
/// that it started, since orphans become the attendant's own children. It does only what a signal's
/// handler may do.
[[noreturn]] void end_with_the_watcher(int /*signal*/) {
  while (kill_children()) {
    pid_t ended = 0;
    do {
      ended = ::waitpid(-1, nullptr, WNOHANG);
    } while (ended > 0);
    if (ended < 0 && errno == ECHILD) break;
    ::poll(nullptr, 0, 1);
  }
  ::_exit(1);
}

/// Arranges that the attendant ends when `watcher` does, which may have happened already.
void end_when_it_ends(pid_t watcher) {
  struct sigaction action {};
  action.sa_handler = end_with_the_watcher;
  sigemptyset(&action.sa_mask);
  ::sigaction(SIGTERM, &action, nullptr);
  sigset_t awaited;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGTERM);
  ::sigprocmask(SIG_UNBLOCK, &awaited, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != watcher) end_with_the_watcher(SIGTERM);
}

/// The attendant's life: it starts the child, reports how that ended, and stays until no process is
/// left below it, since orphans become its own. At last it tells the processor time of them all,
/// which the kernel counts when they are waited for. It was forked from a process that may have
/// threads, so it allocates nothing. It leads a process group of its own, so that a signal to the
/// watcher's group does not end it before the job.
[[noreturn]] void attend(const sys::FileActions& actions, char* const* command,
                         char* const* environment, const sys::Descriptor& fence, Filter& filter,
                         int reports, pid_t watcher) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  ::signal(SIGCHLD, SIG_DFL);  // which a child that the filter holds cannot change
  end_when_it_ends(watcher);
  AttendantsReport report;
  pid_t child = 0;
  report.is_unlimited = (fence.number() >= 0 && !enclose(fence)) || !install(filter);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // In a group of its own a child that kills its group kills itself alone.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  report.error = report.is_unlimited ? EPERM
                                     : posix_spawn(&child, command[0], actions.get(), &attributes,
                                                   command, environment);
  if (report.error == 0) {
    pid_t ended = 0;
    do {
      ended = ::wait(&report.status);
    } while (ended != child && (ended > 0 || errno == EINTR));
  }
  send(reports, report);
  while (::wait(nullptr) > 0 || errno == EINTR) {
  }
  send(reports, seconds_of_children());
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
    const sys::Descriptor fence = fence_of(child);
    Filter filter = read_filter(child.filter);
    const pid_t watcher = ::getpid();
    attendant_ = ::fork();
    if (attendant_ == 0) {
      attend(actions, command_pointers.data(), environment_pointers.data(), fence, filter,
             pipe_.writing.number(), watcher);
    }
    if (attendant_ < 0) throw sys::cannot_start(child.command.front(), errno);
    pipe_.writing.close();
  }
  Attended(const Attended&) = delete;
  Attended& operator=(const Attended&) = delete;
  ~Attended() { end_all(); }

  /// Waits for the child's end, and looks at what it uses some 20 times a second, since limits of
  /// single processes do not count what many of them hold together. Time in which no processor was
  /// used counts as waiting if none of them wanted one: on a busy machine a process that waits for
  /// its turn does not wait in this sense. The looks come at random, so that none can be ready for
  /// them and sleep between.
  Excess watch(const Child& child) {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    constexpr Seconds longest_look{0.25};  // five times as long as it is between two looks
    std::minstd_rand random(std::random_device{}());
    std::uniform_int_distribution<int> until_next(10, 90);  // milliseconds
    pollfd poll{pipe_.reading.number(), POLLIN, 0};
    Clock::time_point last = Clock::now();
    Seconds in_all{};
    for (int ready = 0; (ready = ::poll(&poll, 1, until_next(random))) <= 0;) {
      if (ready < 0 && errno != EINTR) break;
      const Usage usage = usage_of(sys::descendants(attendant_));
      const Clock::time_point now = Clock::now();
      const Seconds seen = std::min(Seconds(now - last), longest_look);
      const double used = std::max(0.0, usage.cpu_seconds - cpu_seconds_);
      if (usage.is_waiting) waiting_seconds_ += std::max(0.0, seen.count() - used);
      in_all += seen;
      last = now;
      cpu_seconds_ += used;
      if (child.waiting_seconds > 0 && waiting_seconds_ > child.waiting_seconds) {
        return Excess::time;
      }
      if (child.clock_seconds > 0 && in_all.count() > child.clock_seconds) return Excess::time;
      if (child.memory_mb > 0 && usage.bytes > child.memory_mb * 1'048'576) return Excess::memory;
      if (child.cpu_seconds > 0 && cpu_seconds_ > child.cpu_seconds) return Excess::time;
      if (child.tasks > 0 && usage.tasks > child.tasks) return Excess::tasks;
      if (has_ended()) break;  // something else killed the attendant
    }
    return Excess::none;
  }

  /// Ends all processes and returns what the attendant reported of the child.
  AttendantsReport end() {
    end_all();
    AttendantsReport report = received<AttendantsReport>();
    cpu_seconds_ = std::max(cpu_seconds_, received<double>());
    return report;
  }

  /// The processor time of all processes, after end().
  double cpu_seconds() const { return cpu_seconds_; }
  double waiting_seconds() const { return waiting_seconds_; }

 private:
  /// The next that the attendant sent; T{} if it was killed before.
  template <class T>
  T received() const {
    T message{};
    const ssize_t n_read = ::read(pipe_.reading.number(), &message, sizeof message);
    return n_read == sizeof message ? message : T{};
  }

  bool has_ended() {
    if (is_over_) return true;
    const pid_t ended = ::waitpid(attendant_, nullptr, WNOHANG);
    is_over_ = ended > 0 || (ended < 0 && errno != EINTR);
    return is_over_;
  }

  void end_all() {
    while (!has_ended()) {
      for (const pid_t process : sys::descendants(attendant_)) ::kill(process, SIGKILL);
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  }

  sys::Pipe pipe_;
  pid_t attendant_ = 0;
  double cpu_seconds_ = 0;
  double waiting_seconds_ = 0;
  bool is_over_ = false;
};

}  // namespace

ChildEnd run_child(const Child& child) {
  Attended attended(child);
  ChildEnd end;
  end.excess = attended.watch(child);
  const AttendantsReport report = attended.end();
  if (report.is_unlimited) {
    throw sys::ToolError(
        "the kernel refuses to limit system calls or writing, without which nothing is run");
  }
  if (report.error != 0) throw sys::cannot_start(child.command.front(), report.error);
  end.cpu_seconds = attended.cpu_seconds();
  end.waiting_seconds = attended.waiting_seconds();
  if (end.excess == Excess::none) end.status = sys::shell_status(report.status);
  return end;
}

}  // namespace course
