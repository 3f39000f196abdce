// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace course {

/// The folder `above`/`name`-UID of this process's user, which is made if it does not exist.
/// Other users can reach files in it whose names they know, but cannot list it. Throws
/// sys::OutputError if something else has that name, such as a link or another user's folder.
std::filesystem::path private_folder(const std::filesystem::path& above, const std::string& name);

}  // namespace course
