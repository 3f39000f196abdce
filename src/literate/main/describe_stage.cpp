// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include "command_line/options.hpp"
#include "literate/deposit/describe_folder.hpp"
#include "literate/main/stages.hpp"
#include "literate/provenance/manifest.hpp"

namespace literate {
namespace {

struct DescribeOptions {
  std::string folder, manifest, citation;
};

}  // namespace

void add_describe_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper) {
  using namespace command_line;
  add_command(
      program, "describe", "Describe a folder of results for archives: codecheck.yml, RO-Crate",
      exit_code, [&paper](CLI::App& command) {
        auto options = std::make_shared<DescribeOptions>();
        add_required_text(command, "--folder", options->folder, "DIR", "Folder with the results");
        add_required_text(command, "--manifest", options->manifest, "FILE",
                          "Manifest that `typeset` wrote");
        add_required_text(command, "--citation", options->citation, "FILE", "CITATION.cff");
        return [options, &paper] {
          describe_folder(options->folder, read_manifest(options->manifest, paper.project),
                          read_citation(options->citation));
          return ExitCode::success;
        };
      });
}

}  // namespace literate
