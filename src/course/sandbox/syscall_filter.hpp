// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace course {

/// Writes the filter of system calls under which a submission runs, in the form that bubblewrap
/// reads. Calls fail with EPERM if no numerical program needs them and if they reach what the
/// limits do not count: memory of System V and of key rings, new namespaces, other processes.
/// Throws sys::ToolError if the filter cannot be made.
void write_syscall_filter(const std::filesystem::path& file);

}  // namespace course
