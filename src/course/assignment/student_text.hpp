// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace course {

/// A text from a submission as it may be shown: bytes that are no UTF-8 and control characters but
/// tab and line end become '?', and from `max_bytes` on it is cut, saying so.
std::string shown(std::string_view text, std::size_t max_bytes);

/// The same in one line, for names: line ends and tabs become '?' too.
std::string shown_name(std::string_view name);

/// The first `max_bytes` of a file, whatever it is; empty if it cannot be read.
std::string beginning_of(const std::filesystem::path& file, std::size_t max_bytes);

}  // namespace course
