// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>

#include "app/commands.hpp"
#include "toolchain/build_info.hpp"

namespace {

std::string version_text() {
  return fmt::format("halfspace {} (commit {}{})", toolchain::version, toolchain::commit,
                     toolchain::modified ? ", modified" : "");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program{
      "Surface displacements and contact of elastic half-spaces: Ruggiero (2001) rebuilt from its "
      "equations.",
      "halfspace"};
  program.set_version_flag("--version", version_text());
  program.require_subcommand(0, 1);  // none is refused below, after what was given instead
  program.set_help_all_flag("--help-all", "Print the help of every subcommand");
  app::ExitCode exit_code = app::ExitCode::success;
  app::add_displacement_command(program, exit_code);
  app::add_block_command(program, exit_code);
  app::add_contact_command(program, exit_code);
  app::add_report_command(program, exit_code);
  app::add_typeset_command(program, exit_code);

  try {
    program.parse(argc, argv);
    if (program.get_subcommands().empty()) throw CLI::RequiredError("A subcommand");
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return program.exit(e);  // --help, --version
    fmt::print(stderr, "halfspace: {} (see halfspace --help)\n", e.what());
    return static_cast<int>(app::ExitCode::bad_input);
  }
  // A full disk shows when the last of the output is written, not before.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "halfspace: standard output cannot be written\n");
    return static_cast<int>(app::ExitCode::bad_input);
  }
  return static_cast<int>(exit_code);
}
