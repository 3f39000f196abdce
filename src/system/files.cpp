// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>

#include "system/error.hpp"

namespace sys {
namespace fs = std::filesystem;
namespace {

/// An error that names the file and, if there is one, the system's reason.
OutputError failure(std::string_view what, const fs::path& file, std::error_code reason = {}) {
  const std::string why = reason ? fmt::format(": {}", reason.message()) : "";
  return OutputError(fmt::format("cannot {} '{}'{}", what, file.string(), why));
}

std::error_code last_error() {
  return {errno, std::generic_category()};
}

/// Writes a new file; the system's reason if that fails, such as a full disk.
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
  // A disk that other machines share may tell only here that it is full.
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

std::string sha256_of_text(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("OpenSSL cannot take a SHA-256");
  }
  std::string hexadecimal;
  for (unsigned int i = 0; i < size; ++i) hexadecimal += fmt::format("{:02x}", digest[i]);
  return hexadecimal;
}

std::string sha256_of_file(const fs::path& file) {
  return sha256_of_text(read_file(file));
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->is_regular_file()) {
      files.push_back(entry->path().lexically_relative(folder).generic_string());
    }
  }
  if (error) throw failure("list", folder, error);
  std::ranges::sort(files);
  return files;
}

namespace {

// sha256sum writes these characters of a name by two, and a backslash before such a line.
constexpr std::string_view escaped_characters = "\\\n\r";
constexpr std::string_view escape_letters = "\\nr";

std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const auto at = escaped_characters.find(c);
    if (at == std::string_view::npos) {
      text += c;
    } else {
      text += {'\\', escape_letters[at]};
    }
  }
  return text;
}

std::string unescaped(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size();
    const auto letter = is_escape ? escape_letters.find(text[++i]) : std::string_view::npos;
    name += letter == std::string_view::npos ? text[i] : escaped_characters[letter];
  }
  return name;
}

}  // namespace

std::optional<std::string> name_below(const fs::path& folder, const fs::path& file) {
  const fs::path relative = file.lexically_relative(folder);
  if (relative.empty() || *relative.begin() == "..") return std::nullopt;
  return relative.generic_string();
}

RecordEntry record_entry(const fs::path& folder, const std::string& file) {
  const bool is_there = fs::is_regular_file(folder / file);
  return {is_there ? sha256_of_file(folder / file) : "-", file};
}

Record record_entries(const fs::path& folder, const std::vector<std::string>& files) {
  Record record;
  for (const std::string& file : files) record.push_back(record_entry(folder, file));
  return record;
}

bool is_as_recorded(const fs::path& folder, const RecordEntry& entry) {
  const fs::path file = folder / entry.name;
  return fs::is_regular_file(file) && sha256_of_file(file) == entry.digest;
}

std::string record_text(const Record& record) {
  std::string text;
  for (const auto& [digest, name] : record) {
    const std::string written = escaped(name);
    text += fmt::format("{}{}  {}\n", written == name ? "" : "\\", digest, written);
  }
  return text;
}

std::optional<Record> parse_record(std::string_view text) {
  Record record;
  while (!text.empty()) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.starts_with('#')) continue;
    const bool is_escaped = line.starts_with('\\');
    if (is_escaped) line.remove_prefix(1);
    const auto blank = line.find("  ");
    if (blank == std::string_view::npos) return std::nullopt;
    const std::string_view name = line.substr(blank + 2);
    record.push_back(
        {std::string(line.substr(0, blank)), is_escaped ? unescaped(name) : std::string(name)});
  }
  return record;
}

}  // namespace sys
