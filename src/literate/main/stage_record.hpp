// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a stage on disk: running, done or failed.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

namespace literate {

/// The SHA-256 of files by their names.
using FileDigests = std::map<std::string, std::string>;

/// Says on disk how far a stage is. While the record exists the stage is done, and the record
/// lists all that it read and made, and ends with the line «# done». Until then «record.unfinished»
/// holds «running» or «failed».
///
/// Beside the record «record.costs» tells, as JSON, the seconds and the processor's seconds of the
/// stage and the largest memory of a process, in MB. Nothing is made from it, and no bytes of it
/// are compared.
///
/// The constructor removes the record. A stage that is killed stays running, and one that ends
/// without done() has failed. Without a name nothing is kept. Throws sys::OutputError for a folder
/// that cannot be written.
class StageRecord {
 public:
  explicit StageRecord(std::filesystem::path record);
  ~StageRecord();
  StageRecord(const StageRecord&) = delete;
  StageRecord& operator=(const StageRecord&) = delete;

  void done(const FileDigests& files);

 private:
  std::filesystem::path record_;
  std::filesystem::path unfinished_;
  bool is_done_ = false;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// The running program's own file and the SHA-256 of what runs, which may have been replaced since.
FileDigests this_program();

}  // namespace literate
