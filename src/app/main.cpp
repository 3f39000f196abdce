// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <set>

#include "app/flags.hpp"
#include "command_line/exit_codes.hpp"
#include "system/error.hpp"
#include "system/text.hpp"

namespace app {
namespace {

// Rejects a missing or unknown command, and words that are not flags of the command.
void require_known(const CLI::App& program) {
  const std::vector<std::string> unknown = program.remaining(true);
  const auto refuse = [](const std::string& message, const std::string& command) {
    throw sys::InputError(fmt::format("{} (see {} --help)", message, command));
  };
  if (program.get_subcommands().empty()) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({})) {
      names.push_back(command->get_name());
    }
    refuse(fmt::format("{}: {}",
                       unknown.empty() ? "a command is missing" : "unknown command " + unknown[0],
                       fmt::join(names, ", ")),
           program.get_name());
  }
  if (unknown.empty()) return;
  const CLI::App& command = *program.get_subcommands()[0];
  const std::string full_name = program.get_name() + " " + command.get_name();
  if (!unknown[0].starts_with("--")) refuse("unexpected '" + unknown[0] + "'", full_name);
  const std::string flag = unknown[0].substr(0, unknown[0].find('='));
  std::set<std::string> flags;
  for (const CLI::Option* option : command.get_options()) flags.insert(option->get_name());
  refuse("unknown flag " + flag + sys::suggestion(flag, flags), full_name);
}

void parse_and_run(CLI::App& program, int argc, char** argv) {
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw sys::InputError(error.what());
    program.exit(error);  // prints the help or the version
  }
  // A full disk becomes apparent only when the last output is written.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw sys::InputError("cannot write to standard output");
  }
}

}  // namespace
}  // namespace app

int main(int argc, char** argv) {
  using namespace app;
  command_line::set_program_name("halfspace");
  CLI::App program(
      "Hertz contact and surface displacements of elastic half-spaces: cylinders and\n"
      "spheres pressed together, strip loads and any other pressure on a surface. Every\n"
      "result comes with an independent check or an error estimate.\n",
      "halfspace");
  program.set_version_flag("--version", "halfspace " HALFSPACE_VERSION)
      ->description("Print the version");
  program.get_help_ptr()->description("Print this help");
  program.get_formatter()->column_width(help_column);
  program.get_formatter()->label("OPTIONS", "FLAGS");
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.require_subcommand(0, 1)->allow_extras();
  program.parse_complete_callback([&] { require_known(program); });
  add_displacement_command(program);
  add_contact_command(program);
  add_point_contact_command(program);
  add_stress_command(program);
  add_block_command(program);
  program.footer(
      "Numbers may have a unit (210GPa, 100N/mm, 0.5in); without one they are in the\n"
      "system of --units or of the case file, mm-N if neither is given.\n\n"
      "Examples:\n"
      "  halfspace contact --radius1 10 --load 100 --plot -\n"
      "  halfspace displacement --shape uniform --peak-pressure 100 --half-width 1\n"
      "  halfspace contact --help");
  return static_cast<int>(command_line::run_guarded([&] {
    parse_and_run(program, argc, argv);
    return command_line::ExitCode::success;
  }));
}
