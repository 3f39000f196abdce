// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "app/commands.hpp"
#include "app/contact_options.hpp"
#include "app/contact_output.hpp"
#include "app/output_format.hpp"

namespace app {
namespace {

struct ContactCommandOptions {
  explicit ContactCommandOptions(CLI::App& command) : contact(command) { output.add_to(command); }

  ContactOptions contact;
  OutputOptions output;
};

ExitCode run(const ContactCommandOptions& options) {
  std::optional<parameters::Case> from_file;
  if (!options.contact.case_file().empty()) {
    from_file = parameters::read_case(options.contact.case_file());
  }
  const config::UnitSystem units = options.output.units(from_file);
  const ContactInput input = options.contact.read(from_file);
  const SolvedContact solved = solve(input);
  require_finite(input, solved);
  switch (options.output.format()) {
    case OutputFormat::csv:
      fmt::print("{}", contact_csv(input, solved));
      break;
    case OutputFormat::json:
      fmt::print("{}", contact_json(input, solved));
      break;
    case OutputFormat::table:
      fmt::print("{}", contact_text(input, solved, units));
      break;
  }
  return ExitCode::success;
}

}  // namespace

void add_contact_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "contact", "Two bodies pressed together along a line: pressure and gap",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<ContactCommandOptions>(command);
                return [options] { return run(*options); };
              });
}

}  // namespace app
