// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/run_compiler.hpp"

#include <fmt/core.h>

#include "system/error.hpp"
#include "system/process.hpp"

namespace course {

void run_compiler(std::vector<std::string> arguments, const std::filesystem::path& product) {
  std::filesystem::create_directories(product.parent_path());
  arguments.insert(arguments.end(), {"-o", product.string()});
  const sys::ProcessResult result = sys::run(
      {.program = "g++", .arguments = std::move(arguments), .environment = {{"LC_ALL", "C"}}});
  if (result.exit_status != 0) {
    throw sys::ToolError(fmt::format("the toolkit does not compile: g++ says\n{}", result.output));
  }
}

}  // namespace course
