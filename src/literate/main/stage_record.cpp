// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stage_record.hpp"

#include <string_view>
#include <system_error>
#include <utility>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/record.hpp"

namespace literate {
namespace fs = std::filesystem;

StageRecord::StageRecord(fs::path record) : record_(std::move(record)) {
  if (record_.empty()) return;
  unfinished_ = record_.string() + ".unfinished";
  sys::write_file_atomically(unfinished_, "running\n");
  sys::remove_file(record_);
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
  sys::Record record;
  for (const auto& [file, digest] : files) record.push_back({digest, file});
  // A record that was cut off lacks the last line.
  sys::write_file_atomically(record_, sys::record_text(record) + "# done\n");
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
