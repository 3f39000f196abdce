// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/handout.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "course/sandbox/scratch_folder.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

// The zip may hold one folder or the files themselves.
fs::path root_of(const fs::path& unpacked) {
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(unpacked)) entries.push_back(entry.path());
  return entries.size() == 1 && fs::is_directory(entries[0]) ? entries[0] : unpacked;
}

}  // namespace

void unpack_zip(const fs::path& zip, const fs::path& folder) {
  const sys::ProcessResult result = sys::run({.program = "bsdtar",
                                              .arguments = {"-xf", fs::absolute(zip).string()},
                                              .working_directory = folder});
  if (result.exit_status == 0) return;
  throw sys::ToolError(fmt::format("bsdtar cannot unpack '{}': {}", zip.string(),
                                   result.output.substr(0, result.output.find('\n'))));
}

std::vector<std::string> differences_of_zip(const fs::path& zip, const fs::path& folder) {
  const ScratchFolder unpacked;
  unpack_zip(zip, unpacked.path());
  const fs::path root = root_of(unpacked.path());
  const auto packed = sys::files_below(root);
  const auto loose = sys::files_below(folder);
  std::vector<std::string> faults;
  std::vector<std::string> unmatched;
  std::ranges::set_symmetric_difference(packed, loose, std::back_inserter(unmatched));
  for (const std::string& file : unmatched) {
    faults.push_back(fmt::format("zip and folder: {} is in one but not in the other", file));
  }
  for (const std::string& file : packed) {
    if (!std::ranges::binary_search(loose, file)) continue;
    if (sys::read_file(root / file) == sys::read_file(folder / file)) continue;
    faults.push_back(fmt::format("zip and folder: {} is not the same", file));
  }
  return faults;
}

}  // namespace course
