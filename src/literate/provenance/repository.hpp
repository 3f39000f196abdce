// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace literate {

/// The state of a paper's repository, as the build asked for it last. No program is compiled from
/// it and nothing is computed from it, so that a commit asks for neither.
struct Repository {
  std::string commit = "unknown";  ///< twelve digits; unknown without git or before the first
  bool modified = false;           ///< whether files of the repository differ from the commit
  std::string date = "unknown";    ///< SOURCE_DATE_EPOCH, or else the commit's
  std::string engine_commit =
      "unknown";  ///< of the engine: its checkout's, or that it was installed from
  bool engine_modified = false;
};

/// Reads the repository.json that cmake/WriteRepository.cmake wrote to a folder. Throws
/// sys::OutputError naming the file if it cannot be read or says nothing of the kind.
Repository read_repository(const std::filesystem::path& folder);

}  // namespace literate
