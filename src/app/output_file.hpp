// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace app {

/// Throws sys::InputError naming the flag unless the file's folder exists. Called before the
/// computation, so that a wrong name is found at once and not at its end.
void require_folder_of(const std::string& flag, const std::string& file);

}  // namespace app
