// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

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

// What the user ran, "halfspace" or "halfspace displacement".
std::string chosen_command(const CLI::App& program) {
  std::string command = program.get_name();
  for (const CLI::App* subcommand : program.get_subcommands()) {
    command += " " + subcommand->get_name();
  }
  return command;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program{
      "Surface displacements and contact of elastic half-spaces: Ruggiero (2001) rebuilt from its "
      "equations.",
      "halfspace"};
  program.set_version_flag("--version", version_text());
  program.require_subcommand(0, 1);  // none is refused below, after what was given instead
  app::ExitCode exit_code = app::ExitCode::success;
  app::add_displacement_command(program, exit_code);
  app::add_block_command(program, exit_code);
  app::add_contact_command(program, exit_code);
  app::add_stress_command(program, exit_code);
  app::add_report_command(program, exit_code);
  app::add_typeset_command(program, exit_code);
  app::add_check_report_command(program, exit_code);
  app::add_course_command(program, exit_code);
  // After the subcommands, which would inherit it.
  program.set_help_all_flag("--help-all", "Print the help of every subcommand");

  try {
    program.parse(argc, argv);
    if (program.get_subcommands().empty()) throw CLI::RequiredError("A subcommand");
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return program.exit(e);  // --help, --version
    fmt::print(stderr, "halfspace: {} (see {} --help)\n", e.what(), chosen_command(program));
    return static_cast<int>(app::ExitCode::bad_input);
  }
  // A full disk shows when the last of the output is written, not before.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "halfspace: standard output cannot be written\n");
    return static_cast<int>(app::ExitCode::bad_input);
  }
  return static_cast<int>(exit_code);
}
