// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>

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

std::string read_to_end(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t n_read = ::read(descriptor, buffer.data(), buffer.size());
    if (n_read > 0) text.append(buffer.data(), static_cast<std::size_t>(n_read));
    if (n_read == 0 || (n_read < 0 && errno != EINTR)) return text;
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return shell_status(status);
}

}  // namespace

fs::path find_tool(std::string_view program) {
  const char* variable = std::getenv("PATH");
  std::string_view folders = variable == nullptr ? "" : variable;
  while (!folders.empty()) {
    const auto colon = folders.find(':');
    const fs::path candidate = fs::absolute(fs::path(folders.substr(0, colon)) / program);
    if (::access(candidate.c_str(), X_OK) == 0 && fs::is_regular_file(candidate)) return candidate;
    folders = colon == std::string_view::npos ? "" : folders.substr(colon + 1);
  }
  throw ToolError(fmt::format("{} is not installed; 'make setup' installs it", program));
}

ProcessResult run(const Command& command) {
  const fs::path program = find_tool(command.program);
  Pipe pipe = open_pipe();
  FileActions actions;
  actions.change_folder(command.working_directory);
  actions.open(STDIN_FILENO, "/dev/null", O_RDONLY);
  actions.duplicate(pipe.writing.number(), STDOUT_FILENO);
  actions.duplicate(pipe.writing.number(), STDERR_FILENO);

  std::vector<std::string> arguments{command.program};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> environment = merged_environment(command.environment);
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), actions.get(), nullptr,
                                exec_pointers(arguments).data(), exec_pointers(environment).data());
  if (error != 0) throw cannot_start(command.program, error);

  pipe.writing.close();
  ProcessResult result;
  result.output = read_to_end(pipe.reading.number());
  result.exit_status = wait_for(child);
  return result;
}

}  // namespace sys
