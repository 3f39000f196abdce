// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/digest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"

namespace literate {
namespace fs = std::filesystem;

std::string digest_of(const fs::path& folder) {
  std::string text;
  for (const std::string& file : sys::files_below(folder)) {
    text += fmt::format("{}  {}\n", sys::sha256_of_file(folder / file), file);
  }
  return text;
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

  std::set<std::string> named;
  const std::string digest = sys::read_file(digest_file);
  for (const std::string_view line : sys::lines_of(digest)) {
    const auto end = line.find("  ");
    if (end == std::string_view::npos) {
      throw sys::OutputError(fmt::format("'{}' is not a list of digests", digest_file.string()));
    }
    const fs::path file = folder / line.substr(end + 2);
    named.emplace(line.substr(end + 2));
    if (fs::is_regular_file(file) && sys::sha256_of_file(file) == line.substr(0, end)) continue;
    throw sys::OutputError(fmt::format(
        "'{}' was changed after it was made; 'make report' makes it again", file.string()));
  }
  for (const std::string& file : made) {
    if (named.contains(file)) continue;
    throw sys::OutputError(fmt::format("'{}' does not name '{}'; 'make report' makes both again",
                                       digest_file.string(), (folder / file).string()));
  }
}

}  // namespace literate
