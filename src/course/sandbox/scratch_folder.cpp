// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/scratch_folder.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "course/sandbox/private_folder.hpp"
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

}  // namespace course
