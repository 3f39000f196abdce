// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include "command_line/options.hpp"
#include "literate/deposit/describe_folder.hpp"
#include "literate/main/stages.hpp"
#include "literate/provenance/manifest.hpp"

namespace literate {

void add_describe_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper) {
  const auto folder = std::make_shared<std::string>();
  add_stage(
      program, exit_code, "describe",
      "Describe a folder of results for archives: codecheck.yml, RO-Crate",
      [folder, &paper](const Settings& settings) {
        describe_folder(*folder, read_manifest(settings.manifest(), paper.project),
                        read_citation(settings.root / "CITATION.cff"));
        return sys::ExitCode::success;
      },
      [folder](CLI::App& command) {
        command_line::add_required_text(command, "--folder", *folder, "DIR",
                                        "Folder with the results");
      });
}

}  // namespace literate
