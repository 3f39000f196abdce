// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "literate/excerpts/excerpt.hpp"
#include "literate/provenance/repository.hpp"

namespace literate {

/// What the build knows of a paper and of the program that computes it.
struct Paper {
  std::string project = {};  ///< begins each message, and names the manifest
  std::string version = {};
  std::string compiler = {};  ///< with its version
  std::string build_type = {};
  std::string flags = {};                             ///< of the compiler, for the build type
  std::string main_file = {};                         ///< of the LaTeX document
  std::string latex = "pdflatex";                     ///< the program that typesets it
  std::vector<std::string> source_folders = {};       ///< that hold its code and excerpts
  std::string repository = {};                        ///< folder of its state, from the program's
  std::vector<CompiledExcerpt> excerpts = {};         ///< as the program was compiled from them
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
