// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <set>
#include <sstream>
#include <string_view>

#include "system/error.hpp"
#include "system/text.hpp"

namespace app {
namespace {

constexpr std::size_t columns = 80;

// Wraps a text before column 80, indenting every line but the first.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string all;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + line.size() + 1 + word.size() >= columns) {
      all += line + '\n' + std::string(indent, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return all + line;
}

std::string help_of(const CLI::Option& option) {
  constexpr std::size_t column = 27;
  const std::string name =
      fmt::format("  {} {}", option.get_name(false, true), option.get_type_name());
  const std::string begin = name.size() + 1 < column ? fmt::format("{:<{}}", name, column)
                                                     : name + '\n' + std::string(column, ' ');
  return begin + wrapped(option.get_description(), column) + '\n';
}

// The names of the commands, as a list.
std::vector<std::string> names_of_commands(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::set<std::string> names_of_flags(const CLI::App& command) {
  std::set<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.insert("--" + name);
  }
  return names;
}

[[noreturn]] void refuse(const std::string& message, const std::string& command) {
  throw sys::InputError(fmt::format("{} (see {} --help)", message, command));
}

// Rejects what CLI11 would misread or report less clearly: it takes the flag that follows "--x=",
// or a flag without a value, for the value.
void require_sound(const CLI::App& program, const std::vector<std::string>& words) {
  const std::string first = words.empty() ? "" : words[0];
  if (first == "--help" || first == "-h" || first == "--version") return;
  const std::vector<std::string> names = names_of_commands(program);
  if (std::ranges::find(names, first) == names.end()) {
    refuse(
        fmt::format("{}: {}", first.empty() ? "a command is missing" : "unknown command " + first,
                    fmt::join(names, ", ")),
        program.get_name());
  }
  const CLI::App& command = *program.get_subcommand(first);
  const std::string full_name = program.get_name() + " " + first;
  std::set<std::string> given;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    const std::string flag = words[i].substr(0, equals);
    if (flag == "-h" || flag == "--help") return;
    if (!flag.starts_with("--")) refuse("unexpected '" + words[i] + "'", full_name);
    const CLI::Option* option = command.get_option_no_throw(flag);
    if (option == nullptr) {
      refuse("unknown flag " + flag + sys::suggestion(flag, names_of_flags(command)), full_name);
    }
    if (!given.insert(option->get_name()).second) refuse(flag + " is given twice", full_name);
    std::string value;
    if (equals != std::string::npos) {
      value = words[i].substr(equals + 1);
    } else if (++i < words.size() && !words[i].starts_with("--")) {
      value = words[i];
    }
    if (value.empty()) refuse(flag + " has no value", full_name);
  }
}

// The help of the program or of a command.
std::string help_of(const CLI::App& command, const std::string& full_name) {
  const auto commands = command.get_subcommands({});
  std::string text = fmt::format("{}\n\nUsage: {} {}\n", wrapped(command.get_description(), 0),
                                 full_name, commands.empty() ? "FLAGS" : "COMMAND FLAGS");
  if (!commands.empty()) text += "\nCommands:\n";
  constexpr std::size_t column = 18;
  for (const CLI::App* sub : commands) {
    const std::string description = sub->get_description();
    text += fmt::format("  {:<{}}{}\n", sub->get_name(), column - 2,
                        wrapped(description.substr(0, description.find(". ")), column));
  }
  std::vector<std::string> groups = command.get_groups();
  // The help comes last.
  std::rotate(groups.begin(), std::ranges::find(groups, "Options") + 1, groups.end());
  for (const std::string& group : groups) {
    text += fmt::format("\n{}:\n", group == "Options" ? "Other" : group);
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_group() == group) text += help_of(*option);
    }
  }
  return text + '\n' + command.get_footer();
}

int bad_input(const std::string& message) {
  return static_cast<int>(command_line::complain(message, ExitCode::bad_input));
}

}  // namespace

void add_command(CLI::App& program, const CommandText& text, ExitCode& exit_code,
                 const std::function<std::function<ExitCode()>(CLI::App&)>& set_up) {
  CLI::App* command = program.add_subcommand(text.name, text.description);
  command->footer("Examples:\n" + text.examples);
  command->callback(
      [run = set_up(*command), &exit_code] { exit_code = command_line::run_guarded(run); });
}

}  // namespace app

int main(int argc, char** argv) {
  using namespace app;
  command_line::set_program_name("halfspace");
  CLI::App program(
      "Hertz contact and surface displacements of elastic half-spaces: cylinders and spheres "
      "pressed together, strip loads and any other pressure on a surface. Every result comes with "
      "an independent check or an error estimate.",
      "halfspace");
  program.set_version_flag("--version", "halfspace " HALFSPACE_VERSION)
      ->description("Print the version");
  program.get_help_ptr()->description("Print this help");
  program.formatter_fn([](const CLI::App* command, const std::string& name, CLI::AppFormatMode) {
    return help_of(*command, name);
  });
  ExitCode exit_code = ExitCode::success;
  add_displacement_command(program, exit_code);
  add_contact_command(program, exit_code);
  add_point_contact_command(program, exit_code);
  add_stress_command(program, exit_code);
  add_block_command(program, exit_code);
  program.footer(
      "Numbers may have a unit (210GPa, 100N/mm, 0.5in); without one they are in the\n"
      "system of --units or of the case file, mm-N if neither is given.\n\n"
      "Examples:\n"
      "  halfspace contact --radius1 10 --load 100 --plot -\n"
      "  halfspace displacement --shape uniform --peak-pressure 100 --half-width 1\n"
      "  halfspace contact --help\n");
  try {
    require_sound(program, {argv + 1, argv + argc});
    program.parse(argc, argv);
  } catch (const sys::InputError& error) {
    return bad_input(error.what());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return bad_input(error.what());
    program.exit(error);  // prints the help or the version
  }
  // A full disk becomes apparent only when the last output is written.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return bad_input("cannot write to standard output");
  }
  return static_cast<int>(exit_code);
}
