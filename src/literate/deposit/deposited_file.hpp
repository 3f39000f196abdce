// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "literate/provenance/manifest.hpp"

namespace literate {

/// What a file of a deposit is to the run that its manifest tells of.
enum class Part { input, output, other };

/// A file in a folder that is given to an archive or to readers.
struct DepositedFile {
  std::string name;  ///< relative to the folder
  std::string sha256;
  std::uintmax_t size = 0;  ///< bytes
  Part part = Part::other;
};

/// All files below a folder, sorted by name; those with the content of one of the manifest's inputs
/// or outputs are known as such, whatever they are called here. Throws sys::OutputError.
std::vector<DepositedFile> deposited_files(const std::filesystem::path& folder,
                                           const Manifest& manifest);

/// The media type that the end of a file's name tells; empty if it is not known.
std::string media_type(const std::string& name);

}  // namespace literate
