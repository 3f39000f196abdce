// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace sys {

/// Reads a whole file. Throws OutputError with its name if that fails.
std::string read_file(const std::filesystem::path& file);

/// Writes a new file and renames it to this one, so that readers see either the old or the new
/// text. Creates the folder if it is missing. Throws OutputError with the name of the file.
void write_file_atomically(const std::filesystem::path& file, std::string_view text);

/// Calls write_file_atomically unless the file already contains this text, so that an unchanged
/// file keeps its time stamp. Returns whether the file was written.
bool write_if_changed(const std::filesystem::path& file, std::string_view text);

/// Removes a file if it exists. Throws OutputError with its name if that fails.
void remove_file(const std::filesystem::path& file);

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
 public:
  /// Takes ownership of an open descriptor; −1 means none.
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace sys
