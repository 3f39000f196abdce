// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/sandbox.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <system_error>

#include "course/sandbox/child.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// Parts of /usr that the distribution's compiler does not need and where an instructor may keep
/// things.
std::vector<std::string> hidden_folders() {
  const fs::path compiler = fs::canonical(sys::find_tool("g++"));
  std::vector<std::string> hidden;
  for (const char* folder : {"/usr/local", "/usr/src"}) {
    const bool has_compiler = compiler.string().starts_with(std::string(folder) + "/");
    if (fs::is_directory(folder) && !has_compiler) hidden.emplace_back(folder);
  }
  return hidden;
}

/// The folders on the way to a path, without the root.
std::vector<std::string> folders_above(const fs::path& path) {
  std::vector<std::string> folders;
  for (fs::path folder = path.parent_path(); folder != folder.root_path();
       folder = folder.parent_path()) {
    folders.insert(folders.begin(), folder.string());
  }
  return folders;
}

/// A job has so many times its processor time by the clock, which it can only need where it hardly
/// ever gets a processor.
constexpr int most_by_the_clock = 20;

JobEnd ending_of(const ChildEnd& end, const Job& job) {
  JobEnd ending{.seconds = end.cpu_seconds + end.waiting_seconds};
  const int status = end.status;
  // The status alone would not tell, since a program may end itself by the signals that end what
  // took too long. The kernel's own account is behind by a few clock ticks.
  constexpr double accounted = 0.9;
  const bool took_too_long = end.cpu_seconds >= accounted * job.seconds;
  const bool is_ended_for_it = status == 128 + SIGKILL || status == 128 + SIGXCPU;
  if (end.excess == Excess::memory) {
    ending.ending = Ending::too_large;
  } else if (end.excess == Excess::tasks) {
    ending.ending = Ending::too_many_processes;
  } else if (end.excess == Excess::time || (is_ended_for_it && took_too_long)) {
    ending.ending = Ending::too_slow;
  } else if (status == 128 + SIGXFSZ) {
    ending.ending = Ending::too_much_output;
  } else {
    ending.ending = status > 128 ? Ending::crash : Ending::normal;
    ending.status = status > 128 ? status - 128 : status;
  }
  return ending;
}

/// Lets a job write a file that nobody wrote before: what it set on an earlier one, such as rights
/// or attributes, would tell the next job something, or keep it from starting.
void make_way_for(const fs::path& file) {
  if (!file.string().starts_with("/dev/")) fs::remove(file);
}

/// Lets this process read what a job wrote, whatever rights the job gave it.
void make_own(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) {
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, fs::perm_options::add,
                    ignored);
  }
}

/// The start of a command line that runs the rest as another user without any capability.
std::vector<std::string> as_user(unsigned user) {
  return {"/usr/bin/setpriv",
          fmt::format("--reuid={}", user),
          fmt::format("--regid={}", user),
          "--clear-groups",
          "--no-new-privs",
          "--pdeathsig=KILL",  // which a change of user had switched off
          "--inh-caps=-all",
          "--bounding-set=-all"};
}

/// The stack of a thread, of which hardly any is used.
constexpr long stack_mb = 8;

/// The start of a command line that runs the rest within limits. Processor time is limited, so
/// that a busy machine does nobody an injustice; what sleeps is ended by run_child. So is what uses
/// too much processor time, by the time for which it really ran. The kernel's limit counts whole
/// ticks of its clock instead, which on a busy machine can run ahead by a fifth: it stands behind
/// the other with a wide margin, for the case that nobody watches any more.
std::vector<std::string> within_limits(const Job& job) {
  return {"/usr/bin/prlimit",
          "--core=0",
          "--nofile=64",
          fmt::format("--stack={}", stack_mb * 1048576L),
          fmt::format("--cpu={}:{}", 2 * job.seconds + 1, 2 * job.seconds + 2),
          fmt::format("--as={}", (job.memory_mb + stack_mb * job.processes) * 1048576L),
          fmt::format("--fsize={}", job.file_kb * 1024L)};
}

/// Removes what a user left in the folders that all users share, to which a job can write only
/// where the kernel has no Landlock. Only for a user of whom nobody else has anything.
void clear_traces_of(unsigned user) {
  std::error_code ignored;
  for (const char* shared : {"/tmp", "/var/tmp", "/dev/shm"}) {
    for (const auto& entry : fs::directory_iterator(shared, ignored)) {
      struct stat status {};
      if (::lstat(entry.path().c_str(), &status) == 0 && status.st_uid == user) {
        fs::remove_all(entry.path(), ignored);
      }
    }
  }
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
      user_(is_root_ ? job_user() : ::geteuid()) {
  write_syscall_filter(work_ / "filter");
  if (isolation_ == Isolation::none) make_reachable();
  probe();
}

/// Lets this process's jobs into its folder and no others: its path stands in the list of
/// processes, where jobs of another grading can read it.
void Sandbox::make_reachable() const {
  using fs::perms;
  fs::permissions(work_, perms::owner_all | perms::group_exec);
  if (is_root_ && ::chown(work_.c_str(), 0, user_) != 0) {
    throw sys::ToolError(fmt::format("cannot give '{}' to another group", work_.string()));
  }
}

std::string Sandbox::place(const Readable& readable) const {
  return isolation_ == Isolation::sandbox ? readable.place : fs::absolute(readable.path).string();
}

std::string Sandbox::scratch() const {
  return isolation_ == Isolation::sandbox ? "/tmp" : (work_ / "scratch").string();
}

std::vector<std::string> Sandbox::walls(const Job& job) const {
  std::vector<std::string> walls = {
      sys::find_tool("bwrap"), "--unshare-ipc",        "--unshare-pid",     "--unshare-net",
      "--unshare-uts",         "--unshare-cgroup-try", "--die-with-parent", "--new-session"};
  if (is_root_) {
    append(walls,
           {"--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID", "--cap-add", "CAP_SETPCAP"});
  } else {
    append(walls, {"--unshare-user", "--disable-userns"});
  }
  append(walls, {"--ro-bind", "/usr", "/usr"});
  for (const std::string& folder : hidden_folders()) {
    append(walls, {"--perms", "0755", "--tmpfs", folder, "--remount-ro", folder});
  }
  for (const std::string folder : {"bin", "lib", "lib64"}) {
    append(walls, {"--symlink", "usr/" + folder, "/" + folder});
  }
  append(walls, {"--perms", "0755", "--dir", "/etc"});
  for (const char* setting : {"/etc/alternatives", "/etc/ld.so.cache"}) {
    append(walls, {"--ro-bind-try", setting, setting});
  }
  append(walls, {"--perms", "0755", "--tmpfs", "/dev"});
  // There is no terminal, which a compiler would wait for, no room that jobs share, and nothing to
  // read that is another each time, such as /proc: a compiler's message would show it, or an object
  // hold it, and /proc also tells what the rest of the machine does.
  append(walls, {"--dev-bind", "/dev/null", "/dev/null", "--remount-ro", "/dev"});
  for (const auto& [path, place] : job.readable) {
    // bubblewrap would make the folders on the way readable to the superuser only.
    for (const std::string& folder : folders_above(place)) {
      append(walls, {"--perms", "0755", "--dir", folder});
    }
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
  // If the grading is killed, its job is killed too.
  std::vector<std::string> command = {"/usr/bin/setpriv", "--pdeathsig=KILL"};
  if (isolation_ == Isolation::sandbox) append(command, walls(job));
  if (is_root_) append(command, as_user(user_));
  append(command, within_limits(job));
  // The limit counts all processes of the user. If a person grades without walls, these include
  // the person's own; then run_child counts the job's processes, and this limit only stops a job
  // that starts processes faster than they are counted.
  const bool counts_alone = is_root_ || isolation_ == Isolation::sandbox;
  command.push_back(fmt::format(
      "--nproc={}", counts_alone ? static_cast<std::size_t>(job.processes)
                                 : own_tasks() + 8 * static_cast<std::size_t>(job.processes)));
  append(command, job.command);
  return command;
}

// SOURCE_DATE_EPOCH is what a compiler takes for __DATE__ and __TIME__, which a message could tell.
// MALLOC_ARENA_MAX keeps threads from reserving 64 MB of address space each.
std::vector<std::string> Sandbox::environment() const {
  return {"PATH=/usr/bin:/bin",  "LC_ALL=C",          "HOME=" + scratch(), "TMPDIR=" + scratch(),
          "SOURCE_DATE_EPOCH=0", "MALLOC_ARENA_MAX=2"};
}

JobEnd Sandbox::run(const Job& job) const {
  const bool has_walls = isolation_ == Isolation::sandbox;
  if (!has_walls) prepare_scratch();
  const std::size_t max_tasks = has_walls || is_root_ ? 0 : static_cast<std::size_t>(job.processes);
  make_way_for(job.output);
  make_way_for(job.errors);
  const ChildEnd end = run_child(
      {.command = command(job),
       .environment = environment(),
       .folder = has_walls            ? "/"
                 : job.folder.empty() ? scratch()
                                      : job.folder,
       .input = job.input,
       .output = job.output,
       .errors = job.errors,
       // bubblewrap makes its walls before it installs the filter itself.
       .third = has_walls ? work_ / "filter" : "/dev/null",
       .filter = has_walls ? fs::path() : work_ / "filter",
       .writable =
           has_walls ? std::vector<fs::path>{} : std::vector<fs::path>{scratch(), "/dev/null"},
       .memory_mb = static_cast<std::size_t>(job.memory_mb),
       .cpu_seconds = static_cast<double>(job.seconds),
       .waiting_seconds = job.waiting_seconds > 0 ? job.waiting_seconds : 2.0 * job.seconds,
       .clock_seconds = static_cast<double>(most_by_the_clock * job.seconds),
       .tasks = max_tasks});
  make_own(job.output);
  make_own(job.errors);
  std::error_code ignored;
  if (!has_walls) fs::remove_all(scratch(), ignored);
  if (!has_walls && is_root_) clear_traces_of(user_);
  return ending_of(end, job);
}

void Sandbox::prepare_scratch() const {
  fs::create_directories(scratch());
  if (is_root_ && ::chown(scratch().c_str(), user_, user_) != 0) {
    throw sys::ToolError(fmt::format("cannot give '{}' to another user", scratch()));
  }
}

void Sandbox::probe() const {
  const fs::path errors = work_ / "probe.err";
  const JobEnd end = run({.command = {"/usr/bin/true"},
                          .readable = {},
                          .folder = "",
                          .output = work_ / "probe.out",
                          .errors = errors,
                          .seconds = 60});  // far more than it takes, for a busy machine
  if (end.ending == Ending::normal && end.status == 0) return;
  std::string why = sys::read_file(errors);
  why = why.substr(0, why.find('\n'));
  throw sys::ToolError(isolation_ == Isolation::sandbox
                           ? fmt::format("bubblewrap cannot keep submissions apart here: {}", why)
                           : fmt::format("cannot run a program within limits: {}", why));
}

}  // namespace course
