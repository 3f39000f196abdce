// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line/exit_codes.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <exception>

namespace command_line {
namespace {

std::string& name_of_program() {
  static std::string name = ::program_invocation_short_name;
  return name;
}

}  // namespace

std::string program_name() {
  return name_of_program();
}

void set_program_name(const std::string& name) {
  name_of_program() = name;
}

ExitCode complain(const std::string& message, ExitCode exit_code) {
  fmt::print(stderr, "{}: {}\n", program_name(), message);
  return exit_code;
}

ExitCode run_guarded(const std::function<ExitCode()>& command) {
  try {
    return command();
  } catch (const sys::Error& e) {
    return complain(e.what(), e.exit_code());
  } catch (const std::exception& e) {
    return complain(e.what(), ExitCode::failed);
  }
}

}  // namespace command_line
