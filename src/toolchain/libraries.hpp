// SPDX-License-Identifier: GPL-3.0-or-later
// The libraries and the processor that the program's results depend on.
#pragma once

#include <map>
#include <string>

namespace toolchain {

/// The versions of the libraries, by name: those that were compiled in, and for FFTW and glibc
/// those that run.
std::map<std::string, std::string> libraries();

/// The processor's architecture and those of its instruction sets by which FFTW, Eigen and the C
/// library choose their code, e.g. "x86_64 avx avx2 fma": others may round differently.
std::string processor();

}  // namespace toolchain
