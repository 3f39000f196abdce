// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace sys {

/// Reads a whole file; throws OutputError naming it if it cannot be read.
std::string read_file(const std::filesystem::path& file);

/// Writes a new file beside this one and renames it, so that readers see the old text or the new
/// one and never a part. Makes the folder if it is missing. Throws OutputError naming the file.
void write_file_atomically(const std::filesystem::path& file, std::string_view text);

/// Does as write_file_atomically, unless the file holds this text already: then it keeps its time
/// stamp. Returns whether it was written.
bool write_if_changed(const std::filesystem::path& file, std::string_view text);

/// Removes a file if it is there; throws OutputError naming it if that fails.
void remove_file(const std::filesystem::path& file);

/// A file descriptor, closed at the end of its scope.
class Descriptor {
 public:
  /// Takes over an open descriptor; −1 stands for none.
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
