// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace course {

/// The folder `above`/`name`-UID of this process's user, made if need be. Others may pass through
/// it to what they know of, but not list it. Throws sys::OutputError if something else has
/// that name, such as another's folder or a link.
std::filesystem::path private_folder(const std::filesystem::path& above, const std::string& name);

}  // namespace course
