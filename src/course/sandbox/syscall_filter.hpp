// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace course {

/// Writes the filter of system calls, as bubblewrap reads it, that a submission runs under: those
/// fail with EPERM that no numerical program needs and that reach what limits do not count (memory
/// of System V and of key rings, namespaces of one's own, other processes). Throws
/// sys::ToolError.
void write_syscall_filter(const std::filesystem::path& file);

}  // namespace course
