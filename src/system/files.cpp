// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.hpp"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
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

}  // namespace

std::string read_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw failure("read", file);
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw failure("read", file);
  return text;
}

void write_file_atomically(const fs::path& file, std::string_view text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throw failure("make the folder of", file, error);

  fs::path beside = file;
  beside += ".new";
  std::ofstream stream(beside, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream) {
    fs::remove(beside, error);
    throw failure("write", file);
  }
  fs::rename(beside, file, error);
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

}  // namespace sys
