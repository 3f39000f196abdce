// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/digest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/record.hpp"

namespace literate {
namespace fs = std::filesystem;

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
