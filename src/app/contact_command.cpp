// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "app/commands.hpp"
#include "app/contact_options.hpp"

namespace app {
namespace {

struct ContactCommandOptions {
  explicit ContactCommandOptions(CLI::App& command) : contact(command) { output.add_to(command); }

  ContactOptions contact;
  Output output;
};

std::vector<Quantity> quantities_of(const ContactInput& input, const SolvedContact& solved,
                                    const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  std::vector<Quantity> quantities = {
      {"half_width", "half-width", half_width_of(input, s), units.length},
      {"peak_pressure", "peak pressure", s.peak_pressure(), units.stress},
      {"load", "load", s.line_load(), units.line_load}};
  if (input.closed_form) {
    quantities[0].exact = input.closed_form->half_width;
    quantities[1].exact = input.closed_form->peak_pressure;
  }
  if (solved.approach) {
    quantities.push_back({"approach", "approach", *solved.approach, units.length});
  }
  return quantities;
}

nlohmann::ordered_json details_of(const ContactInput& input, const SolvedContact& solved) {
  const line_contact::Solution& s = solved.solution;
  nlohmann::ordered_json json = {{"profile", input.profile},
                                 {"element", line_contact::name_of(s.element)},
                                 {"method", input.method},
                                 {"nodes", s.grid.n_nodes},
                                 {"nodes_in_contact", s.n_in_contact()},
                                 {"solves", s.work.revisions},
                                 {"iterations", s.work.iterations},
                                 {"products", s.work.products},
                                 {"seconds", solved.seconds},
                                 {"residuals",
                                  {{"gap", std::max(s.residuals.gap, s.residuals.separation)},
                                   {"pressure", s.residuals.pressure},
                                   {"load", s.residuals.load}}},
                                 {"contact_regions", nlohmann::ordered_json::array()}};
  for (const line_contact::Region& region : s.regions()) {
    json["contact_regions"].push_back({{"begin", region.begin},
                                       {"end", region.end},
                                       {"load", region.load},
                                       {"nodes", region.n_nodes}});
  }
  return json;
}

Table nodes_of(const ContactInput& input, const SolvedContact& solved, bool is_csv) {
  const line_contact::Solution& s = solved.solution;
  Table table{.columns = {{.key = "x", .numbers = to_vector(s.grid.nodes())},
                          {.key = "pressure", .numbers = to_vector(s.pressure)}},
              .in_json = InJson::columns};
  const auto add = [&](const char* key, const Eigen::VectorXd& numbers) {
    table.columns.push_back({.key = key, .numbers = to_vector(numbers)});
  };
  if (const auto& exact = input.closed_form; exact && is_csv) {
    add(exact->name == "hertz" ? "hertz_pressure" : "exact_pressure",
        s.grid.nodes().unaryExpr(exact->pressure));
    table.columns.back().may_be_infinite = true;
  }
  add("gap", s.gap);
  return table;
}

std::string notes_of(const ContactInput& input, const SolvedContact& solved,
                     const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  std::string text;
  text += regions_text(s.regions(), [&](const line_contact::Region& region) {
    return fmt::format("from {:.6g} to {:.6g} {}, {:.6g} {}", region.begin, region.end,
                       units.length, region.load, units.line_load);
  });
  text += fmt::format("{} of {} nodes in contact, {:.6g} {} apart; {}, {} elements",
                      s.n_in_contact(), s.grid.n_nodes, s.grid.spacing, units.length, input.method,
                      line_contact::name_of(s.element));
  if (s.work.revisions > 0)
    text += fmt::format(", steps to find the contact: {}", s.work.revisions);
  if (s.work.iterations > 0) text += fmt::format(", {} iterations", s.work.iterations);
  return text + "\n" + residuals_text(s.residuals, units, units.line_load);
}

// The pressure at the nodes about the contact, and the closed form, if there is one.
literate::Figure contact_figure(const ContactInput& input, const SolvedContact& solved,
                                const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  const auto regions = s.regions();
  const double margin = 0.15 * (regions.back().end - regions.front().begin);
  const double begin = regions.front().begin - margin;
  const double end = regions.back().end + margin;
  std::vector<double> x, pressure;
  for (Eigen::Index i = 0; i < s.grid.n_nodes; ++i) {
    if (s.grid.x(i) < begin || s.grid.x(i) > end) continue;
    x.push_back(s.grid.x(i));
    pressure.push_back(s.pressure[i]);
  }
  literate::Figure figure{
      .width_cm = 14,
      .height_cm = 9,
      .data = {{"nodes", {{"x", x}, {"pressure", pressure}}}},
      .texts = {{"axis", "x"}, {"length_unit", units.length}, {"stress_unit", units.stress}}};
  if (input.closed_form) {
    figure.data["closed"] = curve("x", "pressure", 401, begin, end, [&](double at) {
      const double exact = input.closed_form->pressure(at);
      return std::isfinite(exact) ? exact : literate::gap;
    });
  }
  return figure;
}

ExitCode run(const ContactCommandOptions& options) {
  const auto from_file = case_of(options.contact.case_file());
  const config::UnitSystem units = options.output.units(from_file);
  const ContactInput input = options.contact.read(from_file);
  const SolvedContact solved = solve(input);
  return options.output.print({.quantities = quantities_of(input, solved, units),
                               .closed_form = input.closed_form ? input.closed_form->name : "",
                               .details = details_of(input, solved),
                               .tables = {nodes_of(input, solved, options.output.is_csv())},
                               .notes = notes_of(input, solved, units),
                               .warnings = validity_warnings(input, solved),
                               .script = "contact",
                               .figure = [&] { return contact_figure(input, solved, units); }});
}

}  // namespace

void add_contact_command(CLI::App& program, ExitCode& exit_code) {
  add_command<ContactCommandOptions>(program, "contact",
                                     "Two bodies pressed together along a line: pressure and gap",
                                     exit_code, run);
}

}  // namespace app
