// SPDX-License-Identifier: GPL-3.0-or-later
// What a program stands on besides its own sources and compiler.
#pragma once

#include <map>
#include <string>

namespace literate {

/// The libraries of the engine by name, and their versions: as compiled in, that of glibc as it
/// runs.
std::map<std::string, std::string> engine_libraries();

/// The engine's own version.
std::string engine_version();

/// The processor's architecture and those of its instruction sets by which numerical libraries and
/// the C library choose their code, e.g. "x86_64 avx avx2 fma": others may round differently.
std::string processor();

}  // namespace literate
