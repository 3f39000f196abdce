// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/child.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <sstream>
#include <system_error>

#include "literate/error.hpp"

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

std::string first_line_of(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// Pages that a process and all below it hold. A page that two of them share counts twice.
std::size_t pages_of(pid_t process) {
  std::istringstream sizes(first_line_of(fmt::format("/proc/{}/statm", process)));
  std::size_t all = 0;
  std::size_t resident = 0;
  sizes >> all >> resident;
  std::istringstream children(first_line_of(fmt::format("/proc/{0}/task/{0}/children", process)));
  for (pid_t child = 0; children >> child;) resident += pages_of(child);
  return resident;
}

/// Waits for the child's end, and looks at its size 20 times a second: limits of single processes
/// do not count what many hold together. Returns whether it had to be killed.
bool watch(pid_t process, std::size_t memory_mb) {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const int handle = static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
  if (handle < 0) return false;
  bool is_too_large = false;
  pollfd poll{handle, POLLIN, 0};
  while (!is_too_large && ::poll(&poll, 1, 50) == 0) {
    is_too_large = memory_mb > 0 && pages_of(process) > memory_mb * 1'048'576 / page;
  }
  if (is_too_large) ::kill(process, SIGKILL);
  ::close(handle);
  return is_too_large;
}

}  // namespace

ChildEnd run_child(const Child& child) {
  std::vector<std::string> command = child.command;
  std::vector<std::string> environment = child.environment;
  const FileActions actions(child);
  pid_t pid = 0;
  const int error = posix_spawn(&pid, command.front().c_str(), actions.get(), nullptr,
                                pointers(command).data(), pointers(environment).data());
  if (error != 0) {
    throw literate::ToolError(fmt::format("cannot start {}: {}", command.front(),
                                          std::generic_category().message(error)));
  }
  ChildEnd end;
  end.is_too_large = watch(pid, child.memory_mb);
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  end.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return end;
}

}  // namespace course
