// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

/// Returns the SHA-256 of a text in lower-case hexadecimal.
std::string sha256_of_text(std::string_view text);

/// Returns the SHA-256 of a file's bytes; throws OutputError naming a file that cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

/// Lists all regular files below a folder, sorted, as generic paths relative to it; throws
/// OutputError if it cannot be read.
std::vector<std::string> files_below(const std::filesystem::path& folder);

/// A file's name from a folder on, as a generic path; none if it lies elsewhere. Both are whole
/// paths.
std::optional<std::string> name_below(const std::filesystem::path& folder,
                                      const std::filesystem::path& file);

/// What a file was, or something else that a result depends on.
struct RecordEntry {
  std::string digest;  ///< a SHA-256; "-" for a file that is not there
  std::string name;
};

/// What was read or made, in the order in which it was recorded.
using Record = std::vector<RecordEntry>;

/// The entry for a file below a folder, as the file is now.
RecordEntry record_entry(const std::filesystem::path& folder, const std::string& file);

/// The entries for several files below a folder.
Record record_entries(const std::filesystem::path& folder, const std::vector<std::string>& files);

/// Whether a file below this folder is there and has the digest of its entry.
bool is_as_recorded(const std::filesystem::path& folder, const RecordEntry& entry);

/// Writes a line «digest  name» for each entry, as `sha256sum --check` reads it.
std::string record_text(const Record& record);

/// Reads what record_text wrote, passing over lines that begin with '#'; none if another line is
/// not of this form.
std::optional<Record> parse_record(std::string_view text);

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
