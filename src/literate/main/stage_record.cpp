// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stage_record.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

// What this process and all that it waited for have cost.
std::string costs_json(std::chrono::duration<double> elapsed) {
  double cpu_seconds = 0;
  long peak_kilobytes = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
      cpu_seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    peak_kilobytes = std::max(peak_kilobytes, usage.ru_maxrss);
  }
  return fmt::format("{{\"seconds\": {:.2f}, \"cpu_seconds\": {:.2f}, \"peak_memory_mb\": {}}}\n",
                     elapsed.count(), cpu_seconds, peak_kilobytes / 1024);
}

}  // namespace

StageRecord::StageRecord(const fs::path& record)
    : record_(record), unfinished_(record.string() + ".unfinished") {
  sys::write_file_atomically(unfinished_, "running\n");
  sys::remove_file(record_);
}

StageRecord::~StageRecord() {
  if (is_done_) return;
  try {
    sys::write_file_atomically(unfinished_, "failed\n");
  } catch (const sys::OutputError&) {
    // It stays running, which is begun again in the same way.
  }
}

void StageRecord::done(const FileDigests& files) {
  is_done_ = true;
  sys::write_file_atomically(record_.string() + ".costs",
                             costs_json(std::chrono::steady_clock::now() - begin_));
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

std::string digest_of(const fs::path& folder) {
  return sys::record_text(sys::record_entries(folder, sys::files_below(folder)));
}

void require_as_made(const fs::path& folder, const fs::path& digest_file,
                     const std::vector<std::string>& made) {
  for (const std::string& file : sys::files_below(folder)) {
    if (std::ranges::find(made, file) != made.end()) continue;
    throw sys::OutputError(
        fmt::format("'{}' was not made by the program but could be taken for its output; "
                    "move it elsewhere",
                    (folder / file).string()));
  }

  const auto record = sys::parse_record(sys::read_file(digest_file));
  if (!record) {
    throw sys::OutputError(fmt::format("'{}' is not a list of digests", digest_file.string()));
  }
  std::set<std::string> named;
  for (const sys::RecordEntry& entry : *record) {
    named.insert(entry.name);
    if (sys::is_as_recorded(folder, entry)) continue;
    throw sys::OutputError(
        fmt::format("'{}' was changed after it was made; 'make report' makes it again",
                    (folder / entry.name).string()));
  }
  for (const std::string& file : made) {
    if (named.contains(file)) continue;
    throw sys::OutputError(fmt::format("'{}' does not name '{}'; 'make report' makes both again",
                                       digest_file.string(), (folder / file).string()));
  }
}

}  // namespace literate
