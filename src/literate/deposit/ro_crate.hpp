// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/deposit/citation.hpp"
#include "literate/deposit/deposited_file.hpp"

namespace literate {

/// The text of ro-crate-metadata.json (RO-Crate 1.1, https://w3id.org/ro/crate/1.1) for the folder
/// that holds it: the folder as a dataset with its files, their digests, sizes and media types; the
/// program with the libraries and tools of the manifest; and the action by which it made the
/// outputs from the inputs. Inputs that are not in the folder are described by name and digest
/// alone.
///
/// The date is the manifest's, which is that of its sources, or else the citation's. Throws
/// sys::InputError if there is neither, or no license.
std::string ro_crate_json(const Citation& citation, const Manifest& manifest,
                          const std::vector<DepositedFile>& files);

}  // namespace literate
