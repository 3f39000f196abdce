// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"

namespace course {
namespace {

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

/// The address space that this process has already; a sanitizer alone takes terabytes of it.
rlim_t address_space() {
  const std::string text = sys::read_proc_file("/proc/self/statm");
  rlim_t pages = 0;
  std::from_chars(text.data(), text.data() + text.size(), pages);
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

[[noreturn]] void work_in_child(const std::function<std::string()>& work, int to,
                                unsigned cpu_seconds, unsigned memory_mb) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, cpu_seconds);
  try {
    limit(RLIMIT_AS, address_space() + memory_mb * rlim_t{1048576});
    const std::string result = work();
    for (std::size_t at = 0; at < result.size();) {
      const ssize_t n = ::write(to, result.data() + at, result.size() - at);
      if (n < 0 && errno != EINTR) ::_exit(1);
      if (n > 0) at += static_cast<std::size_t>(n);
    }
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

}  // namespace

std::optional<std::string> apart(const std::function<std::string()>& work, unsigned cpu_seconds,
                                 unsigned memory_mb) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw sys::ToolError("cannot make a pipe");
  const sys::Descriptor from(ends[0]);
  sys::Descriptor to(ends[1]);
  const pid_t child = ::fork();
  if (child < 0) throw sys::ToolError("cannot start a process");
  if (child == 0) work_in_child(work, to.number(), cpu_seconds, memory_mb);
  to.close();
  std::string result;
  std::array<char, 65536> buffer{};
  for (ssize_t n = 1; n != 0;) {
    n = ::read(from.number(), buffer.data(), buffer.size());
    if (n < 0 && errno != EINTR) break;
    if (n > 0) result.append(buffer.data(), static_cast<std::size_t>(n));
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (status != 0) return std::nullopt;
  return result;
}

}  // namespace course
