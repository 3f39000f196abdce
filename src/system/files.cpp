// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/files.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

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

}  // namespace

std::string read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw failure("read", file, last_error());
  try {
    return {std::istreambuf_iterator<char>(stream), {}};
  } catch (const std::ios_base::failure&) {  // such as a folder
    throw failure("read", file, last_error());
  }
}

void write_file_atomically(const fs::path& file, std::string_view text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throw failure("make the folder of", file, error);

  fs::path beside = file;
  beside += ".new";
  std::ofstream stream(beside, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) error = last_error();
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

fs::path find_tool(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / program;
    std::error_code error;
    if (fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  throw ToolError(fmt::format("{} is not installed: run `make setup`", program));
}

}  // namespace sys
