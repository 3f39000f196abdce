// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/deposit/describe_folder.hpp"

#include "literate/deposit/codecheck.hpp"
#include "literate/deposit/deposited_file.hpp"
#include "literate/deposit/ro_crate.hpp"
#include "system/files.hpp"

namespace literate {

void describe_folder(const std::filesystem::path& folder, const Manifest& manifest,
                     const Citation& citation) {
  const std::filesystem::path codecheck = folder / "codecheck.yml";
  const std::filesystem::path crate = folder / "ro-crate-metadata.json";
  std::filesystem::remove(codecheck);
  std::filesystem::remove(crate);
  sys::write_file_atomically(codecheck,
                             codecheck_yml(citation, manifest, deposited_files(folder, manifest)));
  sys::write_file_atomically(crate,
                             ro_crate_json(citation, manifest, deposited_files(folder, manifest)));
}

}  // namespace literate
