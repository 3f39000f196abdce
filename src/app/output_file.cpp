// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_file.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <system_error>

#include "system/error.hpp"

namespace app {

void require_folder_of(const std::string& flag, const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code ignored;
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return;
  throw sys::InputError(fmt::format("{} {}: folder does not exist", flag, file));
}

}  // namespace app
