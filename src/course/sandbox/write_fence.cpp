// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/sandbox/child.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

#include "system/error.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t version_1 =
    LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
    LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK |
    LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

/// The rights to change what a folder holds, as far as this version of Landlock knows them.
std::uint64_t making_and_removing(long version) {
  return version_1 | (version >= 2 ? LANDLOCK_ACCESS_FS_REFER : 0);
}

/// The rights to change a file itself, as far as this version of Landlock knows them.
std::uint64_t changing(long version) {
  constexpr std::uint64_t truncate = 1ULL << 14;  // older headers do not name it
  return LANDLOCK_ACCESS_FS_WRITE_FILE | (version >= 3 ? truncate : 0);
}

void allow(const sys::Descriptor& fence, const fs::path& path, long version) {
  const sys::Descriptor opened(::open(path.c_str(), O_PATH | O_CLOEXEC));
  landlock_path_beneath_attr rule{};
  rule.allowed_access =
      changing(version) | (fs::is_directory(path) ? making_and_removing(version) : 0);
  rule.parent_fd = opened.number();
  if (::syscall(SYS_landlock_add_rule, fence.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0) {
    throw sys::ToolError(fmt::format("cannot let a job write to '{}': {}", path.string(),
                                     std::generic_category().message(errno)));
  }
}

}  // namespace

sys::Descriptor write_fence(const std::vector<fs::path>& writable) {
  const long version =
      ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return sys::Descriptor();
  landlock_ruleset_attr refused{};
  refused.handled_access_fs = changing(version) | making_and_removing(version);
  sys::Descriptor fence(static_cast<int>(
      ::syscall(SYS_landlock_create_ruleset, &refused, sizeof refused.handled_access_fs, 0)));
  if (fence.number() < 0) return fence;
  for (const fs::path& path : writable) allow(fence, path, version);
  return fence;
}

bool enclose(const sys::Descriptor& fence) {
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::syscall(SYS_landlock_restrict_self, fence.number(), 0) == 0;
}

}  // namespace course
