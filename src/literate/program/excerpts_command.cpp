// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <string>

#include "command_line/options.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "literate/program/commands.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

struct ExcerptsOptions {
  std::string source, folders, output;
};

}  // namespace

void add_excerpts_command(CLI::App& program, sys::ExitCode& exit_code) {
  using namespace command_line;
  add_command(
      program, "excerpts",
      "Write a C++ source with the SHA-256 of each excerpt, for the program to compare with",
      exit_code, [](CLI::App& command) {
        auto options = std::make_shared<ExcerptsOptions>();
        command_line::hide(command);  // the build alone calls it
        add_required_text(command, "--source", options->source, "DIR", "The checkout");
        add_required_text(command, "--folders", options->folders, "DIR:DIR…",
                          "Its folders that hold excerpts");
        add_required_text(command, "--output", options->output, "FILE",
                          "The source to write; left alone if it would not change");
        return [options] {
          const auto excerpts = find_excerpts(options->source, sys::split(options->folders, ':'));
          sys::write_if_changed(
              options->output,
              fmt::format(
                  "// Written by the build.\n#include <string_view>\n\nnamespace literate {{\n"
                  "extern const std::string_view compiled_excerpts;\n"
                  "const std::string_view compiled_excerpts = R\"text({})text\";\n"
                  "}}  // namespace literate\n",
                  record_of(excerpts)));
          return ExitCode::success;
        };
      });
}

}  // namespace literate
