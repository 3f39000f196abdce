// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a stage on disk: running, done or failed.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

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
/// without done() has failed. Throws sys::OutputError for a folder that cannot be written.
class StageRecord {
 public:
  explicit StageRecord(const std::filesystem::path& record);
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

/// The SHA-256 of all files below a folder, lines «hash  file» as sha256sum writes them, sorted.
std::string digest_of(const std::filesystem::path& folder);

/// Checks that a folder holds what the program made. Throws sys::OutputError naming the first file
/// that is not among `made`, or else the first whose SHA-256 differs from the one in `digest_file`,
/// which has the form of digest_of, or the first of `made` that it does not name.
void require_as_made(const std::filesystem::path& folder, const std::filesystem::path& digest_file,
                     const std::vector<std::string>& made);

}  // namespace literate
