// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "app/commands.hpp"
#include "app/contact_options.hpp"
#include "app/contact_output.hpp"
#include "app/output_format.hpp"
#include "app/picture.hpp"
#include "app/validity.hpp"

namespace app {
namespace {

struct ContactCommandOptions {
  explicit ContactCommandOptions(CLI::App& command) : contact(command) {
    output.add_to(command);
    plot.add_to(command);
  }

  ContactOptions contact;
  OutputOptions output;
  PlotOption plot;
};

// The pressure at the nodes about the contact, the closed form and the shear, if there are any.
literate::Figure contact_figure(const ContactInput& input, const SolvedContact& solved,
                                const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  const auto regions = s.regions();
  const double begin = regions.front().begin;
  const double end = regions.back().end;
  const double margin = 0.15 * (end - begin);
  std::vector<double> x, pressure, shear;
  for (Eigen::Index i = 0; i < s.grid.n_nodes; ++i) {
    if (s.grid.x(i) < begin - margin || s.grid.x(i) > end + margin) continue;
    x.push_back(s.grid.x(i));
    pressure.push_back(s.pressure[i]);
    if (solved.friction) shear.push_back(solved.friction->shear[i]);
  }
  literate::Figure figure{
      .width_cm = 14,
      .height_cm = 9,
      .data = {{"nodes", {{"x", x}, {"pressure", pressure}}}},
      .texts = {{"axis", "x"}, {"length_unit", units.length}, {"stress_unit", units.stress}}};
  if (solved.friction) figure.data["shear"] = {{"x", x}, {"shear", shear}};
  if (input.closed_form) {
    std::vector<double> along, exact;
    constexpr int n = 400;
    for (int i = 0; i <= n; ++i) {
      const double at = begin - margin + (end - begin + 2 * margin) * i / n;
      const double p = input.closed_form->pressure(at);
      along.push_back(at);
      exact.push_back(std::isfinite(p) ? p : std::numeric_limits<double>::quiet_NaN());
    }
    figure.data["closed"] = {{"x", along}, {"pressure", exact}};
  }
  return figure;
}

ExitCode run(const ContactCommandOptions& options) {
  std::optional<parameters::Case> from_file;
  if (!options.contact.case_file().empty()) {
    from_file = parameters::read_case(options.contact.case_file());
  }
  const config::UnitSystem units = options.output.units(from_file);
  options.plot.require_drawable(options.output);
  const ContactInput input = options.contact.read(from_file);
  const SolvedContact solved = solve(input);
  require_finite(input, solved);
  print_warnings(validity_warnings(input, solved));
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
  if (options.plot.is_given()) options.plot.draw("contact", contact_figure(input, solved, units));
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
