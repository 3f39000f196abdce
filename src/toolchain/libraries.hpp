// SPDX-License-Identifier: GPL-3.0-or-later
// What the program stands on besides its own sources and compiler.
#pragma once

#include <map>
#include <string>

namespace toolchain {

/// The libraries, by name, and their versions: as compiled in, those of FFTW and glibc as they run.
std::map<std::string, std::string> libraries();

/// The processor's architecture and those of its instruction sets by which FFTW, Eigen and the C
/// library choose their code, e.g. "x86_64 avx avx2 fma": others may round differently.
std::string processor();

}  // namespace toolchain
