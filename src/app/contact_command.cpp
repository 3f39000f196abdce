// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/commands.hpp"
#include "app/contact.hpp"
#include "contact/limits.hpp"
#include "line_contact/element.hpp"

namespace app {
namespace {

struct ContactOptions {
  CLI::App& command;
  ContactFlags contact{command};
  Output output{command, "[contact]"};
};

std::vector<Quantity> quantities_of(const SolvedContact& solved, const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  std::vector<Quantity> quantities = {
      {"half_width", "half-width", units.length, solved.half_width()},
      {"peak_pressure", "peak pressure", units.stress, s.peak_pressure()},
      {"load", "load", units.line_load, s.line_load()}};
  if (solved.datum) {
    quantities.push_back({"approach", "approach", units.length, s.approach(*solved.datum)});
  }
  if (!solved.hertz) return quantities;
  quantities[0].exact = solved.hertz->half_width();
  quantities[1].exact = solved.hertz->peak_pressure();
  if (solved.datum) quantities[3].exact = solved.hertz->approach(*solved.datum);
  return quantities;
}

Json details_of(const ContactFlags& flags, const SolvedContact& solved) {
  const line_contact::Solution& s = solved.solution;
  Json details = {{"profile", flags.profile.text_or("cylinder")},
                  {"element", line_contact::name_of(s.element)},
                  {"method", solved.method},
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
                  {"contact_regions", Json::array()}};
  for (const line_contact::Region& region : s.regions()) {
    details["contact_regions"].push_back({{"begin", region.begin},
                                          {"end", region.end},
                                          {"load", region.load},
                                          {"nodes", region.n_nodes}});
  }
  return details;
}

// The CSV also has Hertz's pressure; in JSON its half-width and peak define it.
Table nodes_of(const SolvedContact& solved, bool is_csv) {
  const line_contact::Solution& s = solved.solution;
  const Eigen::VectorXd x = s.grid.nodes();
  Table table = {{.key = "x", .numbers = to_vector(x)},
                 {.key = "pressure", .numbers = to_vector(s.pressure)}};
  if (solved.hertz && is_csv) {
    const auto hertz = x.unaryExpr([&](double at) { return solved.hertz->pressure(at); });
    table.push_back({.key = "hertz_pressure", .numbers = to_vector(hertz)});
  }
  table.push_back({.key = "gap", .numbers = to_vector(s.gap)});
  return table;
}

void add_notes(std::vector<std::string>& notes, const SolvedContact& solved,
               const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  const auto regions = s.regions();
  if (regions.size() > 1) notes.push_back(fmt::format("{} regions in contact", regions.size()));
  if (solved.datum) {
    notes.push_back(
        fmt::format("approach of points at x = {} {}", rounded(*solved.datum), units.length));
  }
  notes.push_back(fmt::format("{} of {} nodes in contact, {:.4g} {} apart", s.n_in_contact(),
                              s.grid.n_nodes, s.grid.spacing, units.length));
  notes.push_back(fmt::format("{} elements, {}", line_contact::name_of(s.element), solved.method));
}

// The pressure at the nodes around the contact, with Hertz's if there is one.
Picture picture_of(const SolvedContact& solved, const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  const auto regions = s.regions();
  const double margin = 0.15 * (regions.back().end - regions.front().begin);
  const double begin = regions.front().begin - margin, end = regions.back().end + margin;
  Picture picture{
      fmt::format("x ({})", units.length), fmt::format("pressure ({})", units.stress), {}};
  if (solved.hertz) {
    picture.curves.push_back(
        line("Hertz", begin, end, [&](double x) { return solved.hertz->pressure(x); }));
  }
  picture.curves.push_back({"elements", !solved.hertz, {}, {}});
  // With about a hundred points, the line below them stays visible.
  const Eigen::Index step = solved.hertz ? 1 + s.n_in_contact() / 100 : 1;
  for (Eigen::Index i = 0; i < s.grid.n_nodes; i += step) {
    if (s.grid.x(i) < begin || s.grid.x(i) > end) continue;
    picture.curves.back().x.push_back(s.grid.x(i));
    picture.curves.back().y.push_back(s.pressure[i]);
  }
  return picture;
}

void run(const ContactOptions& options) {
  const Given given = options.output.given();
  const config::UnitSystem& units = given.units;
  const SolvedContact solved = options.contact.solve(given);
  constexpr int most_digits = 7;
  Result result{
      .quantities = quantities_of(solved, units),
      .digits = earned_digits(contact::relative_error(solved.solution.resolution()), most_digits),
      .is_hertz = solved.hertz.has_value(),
      .details = details_of(options.contact, solved),
      .table = nodes_of(solved, options.output.format() == "csv"),
      .units = {{"half_width", units.length},
                {"peak_pressure", units.stress},
                {"load", units.line_load},
                {"approach", units.length},
                {"x", units.length},
                {"pressure", units.stress},
                {"gap", units.length}},
      .notes = solved.notes,
      .warnings = solved.warnings};
  add_notes(result.notes, solved, units);
  options.output.print(result, [&] { return picture_of(solved, units); });
}

}  // namespace

void add_contact_command(CLI::App& program) {
  add_command<ContactOptions>(
      program, "contact",
      "Hertz line contact: two cylinders, or a cylinder on a plane, pressed together along a line",
      R"(Pressure, half-width and gap by boundary elements are compared with Hertz's
closed form; the profile may also be measured.

Examples:
  A steel cylinder of radius 10 mm on a steel plane, 100 N/mm, plotted below:
    halfspace contact --radius1 10 --load 100 --plot -
  A steel shaft in a bronze bearing, in inches and pounds, with the approach:
    halfspace contact --units in-lbf --radius1 1 --radius2 -1.1 --load 2500 \
      --young1 30e6 --poisson1 0.3 --young2 16e6 --poisson2 0.34 --datum 1
  A measured profile on a million nodes, all pressures as CSV:
    halfspace contact --profile file:gap.csv --load 50N/mm --nodes 1e6 \
      --format csv)",
      run);
}

}  // namespace app
