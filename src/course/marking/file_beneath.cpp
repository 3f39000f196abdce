// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/submission.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "system/files.hpp"

namespace course {
namespace {

std::invalid_argument cannot_open(int error) {
  if (error == ENOENT || error == ENOTDIR) return std::invalid_argument("is missing");
  if (error == ELOOP) return std::invalid_argument("is a symbolic link, or lies behind one");
  return std::invalid_argument(
      fmt::format("cannot be read: {}", std::generic_category().message(error)));
}

std::string kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISSOCK(mode) ? "a socket" : "a device";
}

std::string read_all(int descriptor, std::size_t max_bytes) {
  std::string text;
  std::array<char, 65536> buffer;
  while (text.size() <= max_bytes) {
    const ssize_t n_read = ::read(descriptor, buffer.data(), buffer.size());
    if (n_read < 0 && errno != EINTR) throw cannot_open(errno);
    if (n_read == 0) return text;
    if (n_read > 0) text.append(buffer.data(), static_cast<std::size_t>(n_read));
  }
  throw std::invalid_argument(fmt::format("is larger than {} kB", max_bytes / 1024));
}

}  // namespace

std::string read_beneath(const std::filesystem::path& folder, const std::string& file,
                         std::size_t max_bytes) {
  const sys::Descriptor base(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (base.number() < 0) throw cannot_open(errno);
  open_how how{};
  how.flags = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
  const sys::Descriptor opened(
      static_cast<int>(::syscall(SYS_openat2, base.number(), file.c_str(), &how, sizeof how)));
  if (opened.number() < 0) throw cannot_open(errno);
  struct stat status {};
  if (::fstat(opened.number(), &status) != 0) throw cannot_open(errno);
  if (!S_ISREG(status.st_mode)) {
    throw std::invalid_argument(fmt::format("is {}, not a file", kind_of(status.st_mode)));
  }
  return read_all(opened.number(), max_bytes);
}

}  // namespace course
