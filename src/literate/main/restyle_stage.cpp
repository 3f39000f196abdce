// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <string>

#include "command_line/options.hpp"
#include "literate/document/names.hpp"
#include "literate/main/stages.hpp"
#include "literate/prose/restyle.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

using command_line::complain;
using command_line::ExitCode;

struct RestyleOptions {
  std::string document, generated, output;
};

ExitCode run(const RestyleOptions& options) {
  const Names names = read_names(std::filesystem::path(options.generated) / "names.json");
  const Restyled restyled = restyled_values(options.document, names);
  for (const std::string& error : restyled.errors) complain(error, ExitCode::bad_input);
  if (!restyled.errors.empty()) return ExitCode::bad_input;
  sys::write_if_changed(options.output, restyled.latex);
  return ExitCode::success;
}

}  // namespace

void add_restyle_stage(CLI::App& program, sys::ExitCode& exit_code) {
  using namespace command_line;
  add_command(program, "restyle",
              "Write the values that the prose prints in another way, as `typeset` does for LaTeX",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<RestyleOptions>();
                add_required_text(command, "--document", options->document, "DIR",
                                  "Folder of the LaTeX document");
                add_required_text(command, "--generated", options->generated, "DIR",
                                  "Folder that `compute` wrote");
                add_required_text(command, "--output", options->output, "FILE",
                                  "The definitions, restyled.tex");
                return [options] { return run(*options); };
              });
}

}  // namespace literate
