// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "app/commands.hpp"
#include "app/output_file.hpp"
#include "app/output_format.hpp"
#include "app/picture.hpp"
#include "app/point_contact_figure.hpp"
#include "app/point_contact_options.hpp"
#include "app/point_contact_output.hpp"
#include "app/validity.hpp"
#include "point_contact/solver/vtu.hpp"
#include "system/files.hpp"

namespace app {
namespace {

struct PointContactCommandOptions {
  explicit PointContactCommandOptions(CLI::App& command) : contact(command) {
    add_text(command, "--field", field_file, "FILE",
             "Write pressure and gap at the nodes as CSV, columns x,y,pressure,gap");
    add_text(command, "--vtu", vtu_file, "FILE", "Write the same for ParaView");
    output.add_to(command);
    plot.add_to(command);
  }

  PointContactOptions contact;
  std::string field_file, vtu_file;
  OutputOptions output;
  PlotOption plot;
};

ExitCode run(const PointContactCommandOptions& options) {
  std::optional<parameters::Case> from_file;
  if (!options.contact.case_file().empty()) {
    from_file = parameters::read_case(options.contact.case_file());
  }
  const config::UnitSystem units = options.output.units(from_file);
  require_folder_of("--field", options.field_file);
  require_folder_of("--vtu", options.vtu_file);
  options.plot.require_drawable(options.output);
  const PointContactInput input = options.contact.read(from_file);
  const SolvedPointContact solved = solve(input);
  require_finite(input, solved);
  print_warnings(validity_warnings(input, solved));
  if (!options.field_file.empty()) {
    sys::write_file_atomically(options.field_file, point_contact_csv(solved));
  }
  if (!options.vtu_file.empty()) {
    sys::write_file_atomically(
        options.vtu_file,
        point_contact::vtu(solved.solution,
                           solved.friction ? solved.friction->shear : Eigen::VectorXd()));
  }
  switch (options.output.format()) {
    case OutputFormat::csv:
      fmt::print("{}", point_contact_csv(solved));
      break;
    case OutputFormat::json:
      fmt::print("{}", point_contact_json(input, solved));
      break;
    case OutputFormat::table:
      fmt::print("{}", point_contact_text(input, solved, units));
      break;
  }
  if (options.plot.is_given()) {
    options.plot.draw("point-contact", point_contact_figure(input, solved, units));
  }
  return ExitCode::success;
}

}  // namespace

void add_point_contact_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "point-contact",
              "Two bodies pressed together at a point: pressure and gap on a plane of nodes",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<PointContactCommandOptions>(command);
                return [options] { return run(*options); };
              });
}

}  // namespace app
