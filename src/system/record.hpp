// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// What a file was, or something else that a result depends on.
struct RecordEntry {
  std::string digest;  ///< a SHA-256; "-" for a file that is not there
  std::string name;
};

/// What was read or made, in the order in which it was recorded.
using Record = std::vector<RecordEntry>;

/// The entry for a file below a folder, as the file is now.
RecordEntry record_entry(const std::filesystem::path& folder, const std::string& file);

/// The entries for several files below a folder.
Record record_entries(const std::filesystem::path& folder, const std::vector<std::string>& files);

/// Whether a file below this folder is there and has the digest of its entry.
bool is_as_recorded(const std::filesystem::path& folder, const RecordEntry& entry);

/// Writes a line «digest  name» for each entry, as `sha256sum --check` reads it.
std::string record_text(const Record& record);

/// Reads what record_text wrote, passing over lines that begin with '#'; none if another line is
/// not of this form.
std::optional<Record> parse_record(std::string_view text);

}  // namespace sys
