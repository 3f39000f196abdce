// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line/options.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <CLI/StringTools.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <system_error>

#include "system/decimal.hpp"

namespace command_line {
namespace {

CLI::Option* add(CLI::App& command, const std::string& flag, std::string& text,
                 const std::string& help) {
  CLI::Option* option = command.add_option(flag, text, help);
  if (!text.empty()) option->capture_default_str();
  option->check([](const std::string& given) {
    return given.empty() ? std::string("the value is empty") : std::string();
  });
  return option;
}

// What the user ran, "halfspace" or "halfspace contact".
std::string chosen_command(const CLI::App& program) {
  std::string command = program.get_name();
  for (const CLI::App* subcommand : program.get_subcommands()) {
    command += " " + chosen_command(*subcommand);
  }
  return command;
}

int bad_input(const std::string& message) {
  return static_cast<int>(complain(message, ExitCode::bad_input));
}

}  // namespace

int run_program(const ProgramText& text, const std::vector<AddCommand>& add_commands, int argc,
                char** argv) {
  set_program_name(text.name);
  CLI::App program{text.description, text.name};
  program.set_version_flag("--version", text.version);
  program.require_subcommand(0, 1);  // none is refused below, after what was given instead
  ExitCode exit_code = ExitCode::success;
  for (const AddCommand& add : add_commands) add(program, exit_code);
  // After the subcommands, which would inherit it.
  program.set_help_all_flag("--help-all", "Print the help of every subcommand");

  try {
    program.parse(argc, argv);
    if (program.get_subcommands().empty()) throw CLI::RequiredError("A subcommand");
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return program.exit(e);  // --help, --version
    return bad_input(fmt::format("{} (see {} --help)", e.what(), chosen_command(program)));
  }
  // A full disk shows when the last of the output is written, not before.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return bad_input("standard output cannot be written");
  }
  return static_cast<int>(exit_code);
}

void add_command(CLI::App& program, const std::string& name, const std::string& description,
                 ExitCode& exit_code,
                 const std::function<std::function<ExitCode()>(CLI::App&)>& set_up) {
  CLI::App* command = program.add_subcommand(name, description);
  command->callback([run = set_up(*command), &exit_code] { exit_code = run_guarded(run); });
}

void hide(CLI::App& command) {
  command.group("");
}

void add_text(CLI::App& command, const std::string& flag, std::string& text,
              const std::string& type, const std::string& help) {
  add(command, flag, text, help)->type_name(type);
}

void add_required_text(CLI::App& command, const std::string& flag, std::string& text,
                       const std::string& type, const std::string& help) {
  add(command, flag, text, help)->type_name(type)->required();
}

void add_switch(CLI::App& command, const std::string& flag, bool& is_given,
                const std::string& help) {
  command.add_flag(flag, is_given, help);
}

void add_choice(CLI::App& command, const std::string& flag, std::string& chosen,
                const std::vector<std::string>& choices, const std::string& help) {
  add(command, flag, chosen, help)->check(CLI::IsMember(choices));
}

NumberOption::NumberOption(CLI::App& command, const std::string& flag, const std::string& help,
                           const std::string& type)
    : flag_(flag) {
  add_text(command, flag, text_, type, help);
}

std::optional<double> NumberOption::number() const {
  if (text_.empty()) return std::nullopt;
  return parse_number(flag_, text_);
}

double NumberOption::number_or(std::optional<double> from_case) const {
  if (const auto given = number()) return *given;
  if (from_case) return *from_case;
  throw sys::InputError(flag_ + " is missing: give it, or a --case that has it");
}

std::optional<long> NumberOption::integer() const {
  if (text_.empty()) return std::nullopt;
  const auto number = sys::parsed<long>(text_);
  if (!number) {
    throw sys::InputError(fmt::format("{}: \"{}\" is not a whole number", flag_, text_));
  }
  return number;
}

void refuse_if(bool is_wrong, const std::string& message) {
  if (is_wrong) throw sys::InputError(message);
}

double parse_number(const std::string& what, const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (text.starts_with('+') && !text.starts_with("+-")) ++begin;
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error == std::errc::result_out_of_range) {
    throw sys::InputError(fmt::format("{}: \"{}\" is beyond the range of a double", what, text));
  }
  if (error != std::errc() || stop != end) {
    throw sys::InputError(fmt::format("{}: \"{}\" is not a number", what, text));
  }
  if (!std::isfinite(number)) {
    throw sys::InputError(fmt::format("{} = {}: must be a finite number", what, text));
  }
  return number;
}

std::vector<double> parse_numbers(const std::string& what, const std::string& text) {
  std::vector<double> numbers;
  for (std::string element : CLI::detail::split(text, ',')) {
    numbers.push_back(parse_number(what, CLI::detail::trim(element)));
  }
  if (text.empty() || text.back() == ',') throw sys::InputError(what + ": a number is missing");
  return numbers;
}

std::vector<double> read_numbers(const std::string& file) {
  std::ifstream opened;
  if (file != "-") opened.open(file);
  std::istream& stream = file == "-" ? std::cin : opened;
  if (!stream) throw sys::InputError(file + ": cannot be read");
  std::vector<double> numbers;
  std::string line;
  for (int n = 1; std::getline(stream, line); ++n) {
    CLI::detail::trim(line);
    if (line.empty() || line.front() == '#') continue;
    numbers.push_back(parse_number(fmt::format("{}:{}", file == "-" ? "<stdin>" : file, n), line));
  }
  if (stream.bad()) throw sys::InputError(file + ": cannot be read");
  if (numbers.empty()) throw sys::InputError(file + ": holds no number");
  return numbers;
}

double finite_result(const std::string& what, double result) {
  if (std::isfinite(result)) return result;
  throw sys::InputError(what +
                        ": not a finite number; the parameters are beyond the range of a double");
}

std::string shortest(double number) {
  return fmt::format("{}", number);
}

}  // namespace command_line
