// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/json_text.hpp"
#include "app/options.hpp"
#include "app/output_format.hpp"
#include "contact/hertz.hpp"
#include "contact/matrix_inversion.hpp"
#include "parameters/case.hpp"

namespace app {
namespace {

using OptionalCase = std::optional<parameters::Case>;

struct BodyOptions {
  BodyOptions(CLI::App& command, const std::string& number)
      : young(command, "--young" + number, "Young's modulus of body " + number),
        poisson(command, "--poisson" + number, "Poisson's ratio of body " + number),
        radius(command, "--radius" + number,
               "Radius of body " + number + "; plane for a plane, negative for a hollow") {}

  NumberOption young, poisson, radius;
};

struct ContactOptions {
  explicit ContactOptions(CLI::App& command)
      : body1(command, "1"),
        body2(command, "2"),
        load(command, "--load", "Load P per unit length"),
        datum(command, "--datum", "Where the points lie whose approach is wanted"),
        nodes(command, "--nodes", "Nodes of a grid a little wider than the contact") {
    add_text(command, "--case", case_file, "FILE", "Case file; flags override what it says");
    output.add_to(command);
  }

  BodyOptions body1, body2;
  NumberOption load, datum, nodes;
  std::string case_file;
  OutputOptions output;
};

parameters::CylinderCase body_of(const BodyOptions& options, const OptionalCase& from_file,
                                 parameters::CylinderCase parameters::ContactCase::*body) {
  std::optional<double> young, poisson;
  std::optional<contact::Radius> radius;
  if (from_file) {
    const parameters::CylinderCase& given = from_file->contact.*body;
    young = given.material.young();
    poisson = given.material.poisson();
    radius = given.radius;
  }
  const elasticity::Material material(options.young.number_or(young),
                                      options.poisson.number_or(poisson));
  if (options.radius.text() == "plane") return {material, contact::Radius::of_plane()};
  if (options.radius.text().empty() && radius) return {material, *radius};
  const double given = options.radius.number_or(std::nullopt);
  return {material, contact::Radius::of_cylinder(options.radius.flag().c_str() + 2, given)};
}

struct Solved {
  contact::Hertz hertz;
  contact::Solution solution;
  std::optional<double> approach;
};

Solved solve(const ContactOptions& options, const OptionalCase& from_file) {
  const auto body1 = body_of(options.body1, from_file, &parameters::ContactCase::body1);
  const auto body2 = body_of(options.body2, from_file, &parameters::ContactCase::body2);
  const contact::CylinderPair cylinders(body1.material, body1.radius, body2.material, body2.radius);
  std::optional<double> case_load;
  std::optional<long> n_nodes = options.nodes.integer();
  std::optional<double> datum = options.datum.number();
  if (from_file) {
    case_load = from_file->contact.line_load;
    if (!n_nodes) n_nodes = from_file->contact.n_nodes;
    if (!datum) datum = from_file->contact.datum;
  }
  if (!n_nodes) throw InputError("--nodes is missing: give it, or a --case that has it");
  const double load = options.load.number_or(case_load);
  const contact::Hertz hertz(cylinders, load);
  auto solution = contact::solve_by_matrix_inversion(
      cylinders, load, contact::grid_around(hertz.half_width(), *n_nodes));
  std::optional<double> approach;
  if (datum) approach = solution.approach(*datum);
  return {hertz, std::move(solution), approach};
}

std::vector<double> to_vector(const Eigen::VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

void require_finite(const Solved& solved) {
  const contact::Solution& s = solved.solution;
  finite_result("half_width", s.half_width());
  finite_result("half_width / hertz_half_width", s.half_width() / solved.hertz.half_width());
  finite_result("peak_pressure", s.peak_pressure());
  finite_result("peak_pressure / hertz_peak_pressure",
                s.peak_pressure() / solved.hertz.peak_pressure());
  finite_result("load", s.line_load());
  finite_result("approach", solved.approach.value_or(0));
  for (const double residual :
       {s.residuals.contact, s.residuals.separation, s.residuals.pressure, s.residuals.load}) {
    finite_result("residuals", residual);
  }
  for (Eigen::Index i = 0; i < s.grid.n_nodes; ++i) {
    const double x = s.grid.x(i);
    finite_result(fmt::format("pressure at x = {}", x), s.pressure[i]);
    finite_result(fmt::format("hertz_pressure at x = {}", x), solved.hertz.pressure(x));
    finite_result(fmt::format("gap at x = {}", x), s.gap[i]);
  }
}

std::string contact_json(const Solved& solved) {
  const contact::Solution& s = solved.solution;
  nlohmann::ordered_json json;
  json["half_width"] = s.half_width();
  json["peak_pressure"] = s.peak_pressure();
  json["load"] = s.line_load();
  if (solved.approach) json["approach"] = *solved.approach;
  json["nodes"] = s.grid.n_nodes;
  json["nodes_in_contact"] = s.n_in_contact;
  json["solves"] = s.n_solves;
  json["residuals"] = {{"gap_in_contact", s.residuals.contact},
                       {"penetration_outside", s.residuals.separation},
                       {"tension", s.residuals.pressure},
                       {"load", s.residuals.load}};
  json["hertz"] = {{"half_width", solved.hertz.half_width()},
                   {"peak_pressure", solved.hertz.peak_pressure()}};
  json["x"] = to_vector(s.grid.nodes());
  json["pressure"] = to_vector(s.pressure);
  return json_text(json);
}

std::string contact_csv(const Solved& solved) {
  std::string text = "x,pressure,hertz_pressure,gap\n";
  const contact::Solution& s = solved.solution;
  for (Eigen::Index i = 0; i < s.grid.n_nodes; ++i) {
    const double x = s.grid.x(i);
    text += fmt::format("{},{},{},{}\n", x, s.pressure[i], solved.hertz.pressure(x), s.gap[i]);
  }
  return text;
}

std::string contact_text(const Solved& solved, const parameters::UnitSystem& units) {
  const contact::Solution& s = solved.solution;
  const contact::Hertz& hertz = solved.hertz;
  std::string text =
      fmt::format("{:<16}{:>16}{:>16}  {:>10}\n", "", "elements", "Hertz", "difference");
  const auto compared = [&](const char* name, double value, double exact, const std::string& unit) {
    text += fmt::format("{:<16}{:>16.9g}{:>16.9g}  {:>10.1e}  {}\n", name, value, exact,
                        value / exact - 1, unit);
  };
  compared("half-width", s.half_width(), hertz.half_width(), units.length);
  compared("peak pressure", s.peak_pressure(), hertz.peak_pressure(), units.stress);
  const auto single = [&](const char* name, double value, const std::string& unit) {
    text += fmt::format("{:<16}{:>16.9g}  {}\n", name, value, unit);
  };
  single("load", s.line_load(), units.line_load);
  if (solved.approach) single("approach", *solved.approach, units.length);
  text += fmt::format("{} of {} nodes in contact, {} apart, found in {} solves\n", s.n_in_contact,
                      s.grid.n_nodes, fmt::format("{:.6g} {}", s.grid.spacing, units.length),
                      s.n_solves);
  text +=
      fmt::format("residuals: (1a) {:.1e} {}, (1b) {:.1e} {}, tension {:.1e} {}, load {:.1e} {}\n",
                  s.residuals.contact, units.length, s.residuals.separation, units.length,
                  s.residuals.pressure, units.stress, s.residuals.load, units.line_load);
  return text;
}

ExitCode run(const ContactOptions& options) {
  OptionalCase from_file;
  if (!options.case_file.empty()) from_file = parameters::read_case(options.case_file);
  const parameters::UnitSystem units = options.output.units(from_file);
  const Solved solved = solve(options, from_file);
  require_finite(solved);
  switch (options.output.format()) {
    case OutputFormat::csv:
      fmt::print("{}", contact_csv(solved));
      break;
    case OutputFormat::json:
      fmt::print("{}", contact_json(solved));
      break;
    case OutputFormat::table:
      fmt::print("{}", contact_text(solved, units));
      break;
  }
  return ExitCode::success;
}

}  // namespace

void add_contact_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "contact",
              "Two cylinders pressed together: overlapping triangular elements against Hertz",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<ContactOptions>(command);
                return [options] { return run(*options); };
              });
}

}  // namespace app
