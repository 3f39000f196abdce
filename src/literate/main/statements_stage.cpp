// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <string>

#include "command_line/options.hpp"
#include "literate/document/names.hpp"
#include "literate/main/stages.hpp"
#include "literate/prose/statements.hpp"

namespace literate {
namespace {

struct StatementsOptions {
  std::string document, generated, output;
};

}  // namespace

void add_statements_stage(CLI::App& program, sys::ExitCode& exit_code) {
  using namespace command_line;
  add_command(
      program, "statements",
      "Write what the document says of claims, for other readers of LaTeX than `typeset`",
      exit_code, [](CLI::App& command) {
        auto options = std::make_shared<StatementsOptions>();
        add_required_text(command, "--document", options->document, "DIR",
                          "Folder of the LaTeX document");
        add_required_text(command, "--generated", options->generated, "DIR",
                          "Folder that `compute` wrote");
        add_required_text(command, "--output", options->output, "FILE", "The file to write");
        return [options] {
          write_statements(options->document,
                           read_names(std::filesystem::path(options->generated) / "names.json"),
                           options->output);
          return ExitCode::success;
        };
      });
}

}  // namespace literate
