// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/proc.hpp"

#include <fstream>
#include <sstream>
#include <system_error>

#include "system/decimal.hpp"

namespace sys {
namespace fs = std::filesystem;

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
