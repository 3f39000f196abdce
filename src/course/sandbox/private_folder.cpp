// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/private_folder.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "system/error.hpp"

namespace course {

std::filesystem::path private_folder(const std::filesystem::path& above, const std::string& name) {
  const std::filesystem::path folder = above / fmt::format("{}-{}", name, ::geteuid());
  if (::mkdir(folder.c_str(), 0711) != 0 && errno != EEXIST) {
    throw sys::OutputError(fmt::format("cannot make the folder '{}': {}", folder.string(),
                                       std::generic_category().message(errno)));
  }
  struct stat status {};
  const bool is_own = ::lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
                      status.st_uid == ::geteuid() && ::chmod(folder.c_str(), 0711) == 0;
  if (!is_own) {
    throw sys::OutputError(
        fmt::format("'{}' is not this user's own folder; remove it", folder.string()));
  }
  return folder;
}

}  // namespace course
