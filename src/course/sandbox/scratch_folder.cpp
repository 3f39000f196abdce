// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/scratch_folder.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "system/error.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// A lock on a folder, or none if another process has it or it cannot be opened.
sys::Descriptor locked(const fs::path& folder, int how) {
  sys::Descriptor lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (lock.number() >= 0 && ::flock(lock.number(), how) != 0) lock.close();
  return lock;
}

/// Removes the folders below that no process holds.
void remove_left_behind(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const sys::Descriptor lock = locked(entry->path(), LOCK_EX | LOCK_NB);
    std::error_code ignored;
    if (lock.number() >= 0) fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

ScratchFolder::ScratchFolder() {
  const fs::path all = private_folder(fs::temp_directory_path(), "halfspace-course");
  // Nobody else removes the new folder between its making and its lock.
  const sys::Descriptor lock_of_all = locked(all, LOCK_EX);
  remove_left_behind(all);
  std::string name = (all / "XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw sys::OutputError("cannot make a scratch folder such as '" + name +
                           "': " + std::generic_category().message(errno));
  }
  lock_ = locked(name, LOCK_EX);
  path_ = name;
  using fs::perms;
  fs::permissions(path_, perms::owner_all | perms::group_exec | perms::others_exec);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

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
