// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "system/descriptor.hpp"

namespace course {

/// A fence of Landlock (Linux 5.13): within it a process can write, make, rename and remove nothing
/// but these files and what is below these folders, which must exist. Any user can have one. There
/// is no fence, but a descriptor of −1, where the kernel has no Landlock. Throws sys::ToolError if
/// a path cannot be opened.
sys::Descriptor write_fence(const std::vector<std::filesystem::path>& writable);

/// Encloses this process and all that it starts, which also gains no rights by running programs any
/// more. Returns whether the kernel has done so. Allocates nothing.
bool enclose(const sys::Descriptor& fence);

}  // namespace course
