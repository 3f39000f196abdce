// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace course {

/// A text from a submission as it may be shown. Bytes that are not UTF-8, control characters
/// other than tab and line end and characters that turn the direction of a text become '?'; a text
/// longer than `max_bytes` is cut and says so.
std::string shown(std::string_view text, std::size_t max_bytes);

/// The same in one line, for names: line ends and tabs become '?' as well.
std::string shown_name(std::string_view name);

/// The first `max_bytes` bytes of a file; empty if it cannot be read.
std::string beginning_of(const std::filesystem::path& file, std::size_t max_bytes);

}  // namespace course
