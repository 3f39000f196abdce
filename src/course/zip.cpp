// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/zip.hpp"

#include <fmt/core.h>

#include "literate/error.hpp"
#include "literate/process.hpp"

namespace course {

void unpack_zip(const std::filesystem::path& zip, const std::filesystem::path& folder) {
  const literate::ProcessResult result =
      literate::run({.program = "bsdtar",
                     .arguments = {"-xf", std::filesystem::absolute(zip).string()},
                     .working_directory = folder});
  if (result.exit_status == 0) return;
  throw literate::ToolError(fmt::format("bsdtar cannot unpack '{}': {}", zip.string(),
                                        result.output.substr(0, result.output.find('\n'))));
}

}  // namespace course
