// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/options.hpp"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>

namespace app {
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

}  // namespace

void add_command(CLI::App& program, const std::string& name, const std::string& description,
                 ExitCode& exit_code,
                 const std::function<std::function<ExitCode()>(CLI::App&)>& set_up) {
  CLI::App* command = program.add_subcommand(name, description);
  command->callback([run = set_up(*command), &exit_code] { exit_code = run_guarded(run); });
}

CLI::App& add_command_group(CLI::App& program, const std::string& name,
                            const std::string& description) {
  CLI::App* group = program.add_subcommand(name, description);
  group->require_subcommand(1);
  return *group;
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

NumberOption::NumberOption(CLI::App& command, const std::string& flag, const std::string& help)
    : flag_(flag) {
  add_text(command, flag, text_, "NUMBER", help);
}

std::optional<double> NumberOption::number() const {
  if (text_.empty()) return std::nullopt;
  return parse_number(flag_, text_);
}

double NumberOption::number_or(std::optional<double> from_case) const {
  if (const auto given = number()) return *given;
  if (from_case) return *from_case;
  throw InputError(flag_ + " is missing: give it, or a --case that has it");
}

std::optional<long> NumberOption::integer() const {
  if (text_.empty()) return std::nullopt;
  long number = 0;
  const char* end = text_.data() + text_.size();
  const auto [stop, error] = std::from_chars(text_.data(), end, number);
  if (error != std::errc() || stop != end) {
    throw InputError(fmt::format("{}: \"{}\" is not a whole number", flag_, text_));
  }
  return number;
}

}  // namespace app
