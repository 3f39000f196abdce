// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace course {

/// Does work of this program's own on a text that somebody else wrote in a child process, which is
/// ended if it takes longer than `cpu_seconds` of processor time or `memory_mb` of address space
/// beyond what this process has when it begins, so that no text can hold this process up or crash
/// it. Returns what the work returns; nothing if it was ended, crashed or threw. Not for a process
/// with several threads. Throws sys::ToolError if there can be no child.
std::optional<std::string> apart(const std::function<std::string()>& work, unsigned cpu_seconds,
                                 unsigned memory_mb);

}  // namespace course
