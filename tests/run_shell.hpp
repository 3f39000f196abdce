// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

struct ShellResult {
  int exit_status = 0;
  std::string output;  ///< standard output and standard error
};

/// Runs a shell script with the arguments $1, $2, … and no input. The variables are added to this
/// program's environment.
inline ShellResult run_shell(const std::string& script, const std::vector<std::string>& arguments,
                             const std::filesystem::path& folder = ".",
                             const std::map<std::string, std::string>& variables = {}) {
  const auto quoted = [](const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
  };
  std::string command = "cd " + quoted(folder.string()) + " && exec </dev/null 2>&1 env";
  for (const auto& [name, value] : variables) command += " " + quoted(name + "=" + value);
  command += " /bin/sh -c " + quoted(script) + " sh";
  for (const std::string& argument : arguments) command += " " + quoted(argument);

  std::FILE* const pipe = ::popen(command.c_str(), "r");
  ShellResult result;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    result.output += static_cast<char>(c);
  }
  const int status = ::pclose(pipe);
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}
