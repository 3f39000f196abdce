// SPDX-License-Identifier: GPL-3.0-or-later
// The version of the sources that this program was compiled from, and the compiler.
#pragma once

namespace toolchain {

/// The project's version, e.g. "0.1.0".
extern const char* const version;

/// The first 12 digits of the commit; "unknown" without git, outside a checkout or before the first
/// commit.
extern const char* const commit;

/// Whether files differ from `commit`; files that are neither committed nor ignored count. False if
/// the commit is unknown.
extern const bool modified;

/// The date of the report, e.g. "2001-04-23T12:00:00Z": SOURCE_DATE_EPOCH as it was when the
/// program was built, or else the commit's; "unknown" where there is neither.
extern const char* const date;

/// Name and version of the compiler, e.g. "GNU 12.2.0".
extern const char* const compiler;

/// CMake's build type, e.g. "Release".
extern const char* const build_type;

/// The compiler flags of the build type.
extern const char* const flags;

}  // namespace toolchain
