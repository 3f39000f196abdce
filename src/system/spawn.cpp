// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/spawn.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace sys {
namespace {

void require_success(int error) {
  if (error != 0) throw std::system_error(error, std::generic_category());
}

}  // namespace

FileActions::FileActions() {
  require_success(posix_spawn_file_actions_init(&actions_));
}

FileActions::~FileActions() {
  posix_spawn_file_actions_destroy(&actions_);
}

void FileActions::open(int descriptor, const std::filesystem::path& file, int flags, mode_t mode) {
  require_success(
      posix_spawn_file_actions_addopen(&actions_, descriptor, file.c_str(), flags, mode));
}

void FileActions::duplicate(int source, int descriptor) {
  require_success(posix_spawn_file_actions_adddup2(&actions_, source, descriptor));
}

void FileActions::change_folder(const std::filesystem::path& folder) {
  require_success(posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str()));
}

void FileActions::close_from(int descriptor) {
  require_success(posix_spawn_file_actions_addclosefrom_np(&actions_, descriptor));
}

std::vector<char*> exec_pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

Pipe open_pipe(int flags) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC | flags) != 0) {
    throw ToolError("cannot open a pipe: " + std::generic_category().message(errno));
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

int shell_status(int wait_status) {
  return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

ToolError cannot_start(const std::string& program, int error) {
  return ToolError(
      fmt::format("cannot start {}: {}", program, std::generic_category().message(error)));
}

}  // namespace sys
