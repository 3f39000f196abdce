// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/scratch_folder.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "course/sandbox/private_folder.hpp"
#include "system/error.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// A lock on a folder, to be closed; -1 if another process has it, or it cannot be opened.
int locked(const fs::path& folder, int how) {
  const int lock = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (lock >= 0 && ::flock(lock, how) == 0) return lock;
  if (lock >= 0) ::close(lock);
  return -1;
}

/// Removes the folders below that no process holds.
void remove_left_behind(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const int lock = locked(entry->path(), LOCK_EX | LOCK_NB);
    if (lock < 0) continue;
    std::error_code ignored;
    fs::remove_all(entry->path(), ignored);
    ::close(lock);
  }
}

}  // namespace

ScratchFolder::ScratchFolder() {
  const fs::path all = private_folder(fs::temp_directory_path(), "halfspace-course");
  const int lock_of_all = locked(all, LOCK_EX);  // one that is made is not yet locked
  remove_left_behind(all);
  std::string name = (all / "XXXXXX").string();
  const bool is_made = ::mkdtemp(name.data()) != nullptr;
  const int error = errno;
  if (is_made) lock_ = locked(name, LOCK_EX);
  ::close(lock_of_all);
  if (!is_made) {
    throw sys::OutputError("cannot make a scratch folder such as '" + name +
                           "': " + std::generic_category().message(error));
  }
  path_ = name;
  using fs::perms;
  fs::permissions(path_, perms::owner_all | perms::group_exec | perms::others_exec);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  ::close(lock_);
}

}  // namespace course
