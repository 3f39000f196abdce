// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

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

/// What the build knows of a paper and of the program that computes it.
struct Paper {
  std::string project = {};  ///< begins each message, and names the manifest
  std::string version = {};
  std::string compiler = {};  ///< with its version
  std::string build_type = {};
  std::string flags = {};                             ///< of the compiler, for the build type
  std::string latex = "pdflatex";                     ///< the program that typesets it
  std::vector<std::string> source_folders = {};       ///< that hold its code and excerpts
  std::string repository = {};                        ///< folder of its state, from the program's
  std::string_view excerpts = {};                     ///< that it was compiled from, as record_of()
  std::map<std::string, std::string> libraries = {};  ///< versions, besides those of the engine
};

/// The paper whose program this is; of several papers the first. literate_add_paper compiles it
/// into each program.
const Paper& this_paper();

/// «rod 1.2.0 (commit 0123456789ab, modified)», for --version.
std::string version_text(const Paper& paper, const Repository& repository);

/// The same, with the commit of the checkout when it was last built. It is unknown if the program
/// was moved away from there.
std::string version_text(const Paper& paper);

/// The libraries of the engine by name, and their versions: as compiled in, that of glibc as it
/// runs.
std::map<std::string, std::string> engine_libraries();

/// The engine's own version.
std::string engine_version();

/// The processor's architecture and those of its instruction sets by which numerical libraries and
/// the C library choose their code, e.g. "x86_64 avx avx2 fma": others may round differently.
std::string processor();

}  // namespace literate
