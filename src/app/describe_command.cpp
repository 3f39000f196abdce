// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "literate/deposit/describe_folder.hpp"
#include "literate/provenance/manifest.hpp"

namespace app {

void add_describe_command(CLI::App& program, ExitCode& exit_code) {
  struct Options {
    std::string folder, manifest, citation;
  };
  add_command(
      program, "describe", "Describe a folder of results for archives: codecheck.yml, RO-Crate",
      exit_code, [](CLI::App& command) {
        auto options = std::make_shared<Options>();
        add_required_text(command, "--folder", options->folder, "DIR", "Folder with the results");
        add_required_text(command, "--manifest", options->manifest, "FILE",
                          "Manifest that `typeset` wrote");
        add_required_text(command, "--citation", options->citation, "FILE", "CITATION.cff");
        return [options] {
          literate::describe_folder(options->folder,
                                    literate::read_manifest(options->manifest, "halfspace"),
                                    literate::read_citation(options->citation));
          return ExitCode::success;
        };
      });
}

}  // namespace app
