// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <iterator>
#include <sstream>
#include <string>

#include "system/process.hpp"

namespace course {
namespace {

/// The fields of /proc/ID/stat of a process or thread from the third on. The second is a name,
/// which may hold anything.
std::vector<std::string> statistics_of(pid_t process) {
  const std::string text = sys::read_proc_file(fmt::format("/proc/{}/stat", process));
  const auto end_of_name = text.rfind(')');
  if (end_of_name == text.npos) return {};
  std::istringstream rest(text.substr(end_of_name + 1));
  return {std::istream_iterator<std::string>(rest), {}};
}

/// Whether no thread of a process is on a processor or in the queue for one. At a disk it waits: a
/// parent in vfork looks the same.
bool waits(pid_t process) {
  for (const pid_t thread : sys::processes_in(fmt::format("/proc/{}/task", process))) {
    const std::vector<std::string> fields = statistics_of(thread);
    if (!fields.empty() && fields[0] == "R") return false;
  }
  return true;
}

}  // namespace

Usage usage_of(const std::vector<pid_t>& processes) {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const auto ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));
  Usage usage;
  for (const pid_t process : processes) {
    const std::vector<std::string> fields = statistics_of(process);
    if (fields.size() < 22) continue;  // it has ended
    if (usage.is_waiting) usage.is_waiting = waits(process);
    for (std::size_t i = 11; i < 15; ++i) usage.cpu_seconds += std::stod(fields[i]) / ticks;
    usage.tasks += std::stoul(fields[17]);
    usage.bytes += std::stoul(fields[21]) * page;
  }
  return usage;
}

std::size_t own_tasks() {
  std::size_t n_tasks = 0;
  for (const pid_t process : sys::processes_in("/proc")) {
    struct stat status {};
    const std::string folder = fmt::format("/proc/{}", process);
    if (::stat(folder.c_str(), &status) != 0 || status.st_uid != ::geteuid()) continue;
    n_tasks += usage_of({process}).tasks;
  }
  return n_tasks;
}

}  // namespace course
