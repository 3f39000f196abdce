// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "system/error.hpp"

namespace sys {
namespace fs = std::filesystem;
namespace {

/// Makes an error that names the file and the system's reason, if there is one.
OutputError failure(std::string_view what, const fs::path& file, std::error_code reason = {}) {
  const std::string why = reason ? fmt::format(": {}", reason.message()) : "";
  return OutputError(fmt::format("cannot {} '{}'{}", what, file.string(), why));
}

std::error_code last_error() {
  return {errno, std::generic_category()};
}

/// Writes a new file. Returns the system's reason if that fails, such as a full disk.
std::error_code write_whole(const fs::path& file, std::string_view text) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (opened < 0) return last_error();
  while (!text.empty()) {
    const ssize_t n_written = ::write(opened, text.data(), text.size());
    if (n_written > 0) {
      text.remove_prefix(static_cast<std::size_t>(n_written));
    } else if (n_written == 0 || errno != EINTR) {
      const std::error_code error =
          n_written == 0 ? std::make_error_code(std::errc::no_space_on_device) : last_error();
      ::close(opened);
      return error;
    }
  }
  // A network file system may report only here that it is full.
  return ::close(opened) == 0 ? std::error_code() : last_error();
}

}  // namespace

std::string read_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) {
    throw failure("read", file, std::make_error_code(std::errc::is_a_directory));
  }
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (descriptor.number() < 0) throw failure("read", file, last_error());
  std::string text;
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t n_read = ::read(descriptor.number(), buffer.data(), buffer.size());
    if (n_read == 0) return text;
    if (n_read > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(n_read));
    } else if (errno != EINTR) {
      throw failure("read", file, last_error());
    }
  }
}

void write_file_atomically(const fs::path& file, std::string_view text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throw failure("make the folder of", file, error);

  fs::path beside = file;
  beside += ".new";
  error = write_whole(beside, text);
  if (!error) fs::rename(beside, file, error);
  if (error) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw failure("write", file, error);
  }
}

bool write_if_changed(const fs::path& file, std::string_view text) {
  std::error_code error;
  if (fs::is_regular_file(file, error) && read_file(file) == text) return false;
  write_file_atomically(file, text);
  return true;
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw failure("remove", file, error);
}

}  // namespace sys
