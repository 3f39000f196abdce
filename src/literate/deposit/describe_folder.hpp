// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "literate/deposit/citation.hpp"
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

/// The text of codecheck.yml as an author hands it in (CODECHECK configuration file 1.0,
/// https://codecheck.org.uk/spec/config/1.0/), for the folder that holds it: the outputs that a
/// check has to make again, title and authors of the work, its reference and where it comes from.
/// What the codechecker adds (codechecker, report, check_time, certificate) is not there. Throws
/// sys::InputError if there is no output.
std::string codecheck_yml(const Citation& citation, const Manifest& manifest,
                          const std::vector<DepositedFile>& files);

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

/// Writes codecheck.yml and ro-crate-metadata.json into a folder, about the files that lie in it
/// now; those two, if they are there from before, are made anew. The same files, manifest and
/// citation give the same bytes. Throws sys::InputError as codecheck_yml and ro_crate_json do, and
/// sys::OutputError.
void describe_folder(const std::filesystem::path& folder, const Manifest& manifest,
                     const Citation& citation);

}  // namespace literate
