// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "literate/deposit/citation.hpp"
#include "literate/provenance/manifest.hpp"

namespace literate {

/// Writes codecheck.yml and ro-crate-metadata.json into a folder, about the files that lie in it
/// now; those two, if they are there from before, are made anew. The same files, manifest and
/// citation give the same bytes. Throws sys::InputError as codecheck_yml and ro_crate_json do, and
/// sys::OutputError.
void describe_folder(const std::filesystem::path& folder, const Manifest& manifest,
                     const Citation& citation);

}  // namespace literate
