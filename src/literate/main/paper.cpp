// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/paper.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "system/error.hpp"

namespace literate {
namespace fs = std::filesystem;

std::string version_text(const Paper& paper, const Repository& repository) {
  return fmt::format("{} {} (commit {}{})", paper.project, paper.version, repository.commit,
                     repository.modified ? ", modified" : "");
}

std::string version_text(const Paper& paper) {
  try {
    const fs::path program = fs::read_symlink("/proc/self/exe");
    return version_text(paper, read_repository(program.parent_path() / paper.repository));
  } catch (const sys::OutputError&) {
    return version_text(paper, {});
  }
}

}  // namespace literate
