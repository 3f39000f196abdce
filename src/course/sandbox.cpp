// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <sstream>

#include "course/child.hpp"
#include "course/syscall_filter.hpp"
#include "literate/error.hpp"
#include "literate/files.hpp"
#include "literate/process.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// A user for this process alone: where there are so many, one that no person and no service has;
/// else, in a container, one that differs for processes that run at the same time.
unsigned own_user() {
  std::istringstream map(literate::read_file("/proc/self/uid_map"));
  unsigned long inside = 0;
  unsigned long outside = 0;
  unsigned long n_users = 0;
  map >> inside >> outside >> n_users;
  const auto process = static_cast<unsigned>(::getpid());
  return n_users > 2'000'000'000UL ? 1'900'000'000U + process : 20'000U + process % 40'000U;
}

JobEnd ending_of(const ChildEnd& end) {
  const int status = end.status;
  if (end.is_too_large) return {Ending::too_large, 0};
  if (status == 124 || status == 128 + SIGKILL || status == 128 + SIGXCPU) {
    return {Ending::too_slow, 0};
  }
  if (status == 128 + SIGXFSZ) return {Ending::too_much_output, 0};
  if (status > 128) return {Ending::crash, status - 128};
  return {Ending::normal, status};
}

/// The user of the job, without any capability.
std::vector<std::string> as_user(unsigned user) {
  return {"/usr/bin/setpriv",
          fmt::format("--reuid={}", user),
          fmt::format("--regid={}", user),
          "--clear-groups",
          "--no-new-privs",
          "--inh-caps=-all",
          "--bounding-set=-all"};
}

/// The processor's time is what is limited, so that a busy machine does no injustice; the clock's,
/// twice as long, ends what sleeps.
std::vector<std::string> within_limits(const Job& job) {
  return {"/usr/bin/prlimit",
          "--core=0",
          "--nofile=64",
          fmt::format("--cpu={}:{}", job.seconds, job.seconds + 1),
          fmt::format("--as={}", job.memory_mb * 1048576L),
          fmt::format("--fsize={}", job.file_kb * 1024L)};
}

}  // namespace

void make_readable(const fs::path& path) {
  using fs::perms;
  const auto allow = [](const fs::path& one) {
    const perms read = perms::owner_read | perms::group_read | perms::others_read;
    const perms enter = perms::owner_exec | perms::group_exec | perms::others_exec;
    fs::permissions(one, fs::is_directory(one) ? read | enter : read, fs::perm_options::add);
  };
  allow(path);
  if (!fs::is_directory(path)) return;
  for (const auto& entry : fs::recursive_directory_iterator(path)) allow(entry.path());
}

Sandbox::Sandbox(Isolation isolation, const fs::path& work)
    : isolation_(isolation),
      work_(fs::absolute(work)),
      is_root_(::geteuid() == 0),
      user_(own_user()) {
  if (isolation_ == Isolation::sandbox) {
    write_syscall_filter(work_ / "filter");
  } else {
    fs::permissions(work_, fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add);
  }
  probe();
}

std::string Sandbox::place(const Readable& readable) const {
  return isolation_ == Isolation::sandbox ? readable.place : fs::absolute(readable.path).string();
}

std::string Sandbox::scratch() const {
  return isolation_ == Isolation::sandbox ? "/tmp" : (work_ / "scratch").string();
}

std::vector<std::string> Sandbox::walls(const Job& job) const {
  std::vector<std::string> walls = {literate::find_tool("bwrap"),
                                    "--unshare-ipc",
                                    "--unshare-pid",
                                    "--unshare-net",
                                    "--unshare-uts",
                                    "--unshare-cgroup-try",
                                    "--die-with-parent",
                                    "--new-session"};
  if (is_root_) {
    append(walls,
           {"--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID", "--cap-add", "CAP_SETPCAP"});
  } else {
    append(walls, {"--unshare-user", "--disable-userns"});
  }
  append(walls, {"--ro-bind",
                 "/usr",
                 "/usr",
                 "--symlink",
                 "usr/bin",
                 "/bin",
                 "--symlink",
                 "usr/lib",
                 "/lib",
                 "--symlink",
                 "usr/lib64",
                 "/lib64",
                 "--perms",
                 "0755",
                 "--dir",
                 "/etc",
                 "--ro-bind-try",
                 "/etc/alternatives",
                 "/etc/alternatives",
                 "--ro-bind-try",
                 "/etc/ld.so.cache",
                 "/etc/ld.so.cache",
                 "--proc",
                 "/proc",
                 "--dev",
                 "/dev",
                 "--remount-ro",
                 "/dev"});
  for (const auto& [path, place] : job.readable) {
    // Folders on the way would be the superuser's alone.
    const std::string parent = fs::path(place).parent_path().string();
    if (parent != "/") append(walls, {"--perms", "0755", "--dir", parent});
    append(walls, {"--ro-bind", fs::absolute(path).string(), place});
  }
  const std::string size = fmt::format("{}", std::max(1L, job.scratch_mb * 1048576L));
  append(walls, {"--size", size, "--perms", "1777", "--tmpfs", "/tmp"});
  if (job.scratch_mb == 0) append(walls, {"--remount-ro", "/tmp"});
  append(walls, {"--remount-ro", "/", "--chdir", job.folder.empty() ? "/tmp" : job.folder,
                 "--seccomp", "3", "--"});
  return walls;
}

std::vector<std::string> Sandbox::command(const Job& job) const {
  std::vector<std::string> command = {"/usr/bin/timeout"};
  // In a group of its own `timeout` would not hear Ctrl-C; without walls the group is all there is
  // to end the children with.
  if (isolation_ == Isolation::sandbox) command.emplace_back("--foreground");
  append(command, {"--kill-after=1", fmt::format("{}", 2 * job.seconds)});
  if (isolation_ == Isolation::sandbox) append(command, walls(job));
  if (is_root_) append(command, as_user(user_));
  append(command, within_limits(job));
  // Of a person grading without walls, all processes would count.
  if (is_root_ || isolation_ == Isolation::sandbox) {
    command.push_back(fmt::format("--nproc={}", job.processes));
  }
  append(command, job.command);
  return command;
}

JobEnd Sandbox::run(const Job& job) const {
  const bool has_walls = isolation_ == Isolation::sandbox;
  if (!has_walls) {
    fs::create_directories(scratch());
    if (is_root_ && ::chown(scratch().c_str(), user_, user_) != 0) {
      throw literate::ToolError(fmt::format("cannot give '{}' to another user", scratch()));
    }
  }
  const ChildEnd end = run_child({.command = command(job),
                                  .environment = {"PATH=/usr/bin:/bin", "LC_ALL=C",
                                                  "HOME=" + scratch(), "TMPDIR=" + scratch()},
                                  .folder = has_walls            ? "/"
                                            : job.folder.empty() ? scratch()
                                                                 : job.folder,
                                  .input = job.input,
                                  .output = job.output,
                                  .errors = job.errors,
                                  .third = has_walls ? work_ / "filter" : "/dev/null",
                                  .memory_mb = static_cast<std::size_t>(job.memory_mb)});
  if (!has_walls) end_what_is_left();
  return ending_of(end);
}

void Sandbox::end_what_is_left() const {
  if (is_root_) {
    std::vector<std::string> command = as_user(user_);
    append(command, {"/usr/bin/kill", "-KILL", "--", "-1"});
    run_child({.command = command,
               .environment = {},
               .folder = "/",
               .input = "/dev/null",
               .output = "/dev/null",
               .errors = "/dev/null"});
  }
  std::error_code ignored;
  fs::remove_all(scratch(), ignored);
}

void Sandbox::probe() const {
  const fs::path errors = work_ / "probe.err";
  const JobEnd end = run({.command = {"/usr/bin/true"},
                          .readable = {},
                          .folder = "",
                          .output = work_ / "probe.out",
                          .errors = errors,
                          .seconds = 60});  // nothing, but on a machine that is busy
  if (end.ending == Ending::normal && end.status == 0) return;
  std::string why = literate::read_file(errors);
  why = why.substr(0, why.find('\n'));
  throw literate::ToolError(
      isolation_ == Isolation::sandbox
          ? fmt::format("bubblewrap cannot keep submissions apart here: {}; --unsafe grades "
                        "without it, with limits only",
                        why)
          : fmt::format("cannot run a program within limits: {}", why));
}

}  // namespace course
