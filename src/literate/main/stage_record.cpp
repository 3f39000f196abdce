// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stage_record.hpp"

#include <fmt/core.h>

#include <string_view>
#include <system_error>
#include <utility>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// A name in which sha256sum writes backslashes and line ends by two characters.
std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (c == '\\') {
      text += "\\\\";
    } else if (c == '\n') {
      text += "\\n";
    } else if (c == '\r') {
      text += "\\r";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string record_text(const FileDigests& files) {
  std::string text;
  for (const auto& [file, digest] : files) {
    const std::string name = escaped(file);
    text += fmt::format("{}{}  {}\n", name == file ? "" : "\\", digest, name);
  }
  return text + "# done\n";
}

StageRecord::StageRecord(fs::path record) : record_(std::move(record)) {
  if (record_.empty()) return;
  unfinished_ = record_.string() + ".unfinished";
  sys::write_file_atomically(unfinished_, "running\n");
  std::error_code error;
  fs::remove(record_, error);
  if (error) {
    throw sys::OutputError(
        fmt::format("cannot remove '{}': {}", record_.string(), error.message()));
  }
}

StageRecord::~StageRecord() {
  if (record_.empty() || is_done_) return;
  try {
    sys::write_file_atomically(unfinished_, "failed\n");
  } catch (const sys::OutputError&) {
    // It stays running, which is begun again in the same way.
  }
}

void StageRecord::done(const FileDigests& files) {
  is_done_ = true;
  if (record_.empty()) return;
  sys::write_file_atomically(record_, record_text(files));
  std::error_code ignored;
  fs::remove(unfinished_, ignored);
}

FileDigests this_program() {
  constexpr std::string_view replaced = " (deleted)";
  std::string file = fs::read_symlink("/proc/self/exe").string();
  if (file.ends_with(replaced)) file.erase(file.size() - replaced.size());
  return {{file, sys::sha256_of_file("/proc/self/exe")}};
}

}  // namespace literate
