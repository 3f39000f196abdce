// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "app/commands.hpp"
#include "app/point_contact_options.hpp"
#include "point_contact/solver/solution.hpp"
#include "system/files.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;
using point_contact::Vector2;

struct PointContactCommandOptions {
  explicit PointContactCommandOptions(CLI::App& command) : contact(command) {
    add_text(command, "--field", field_file, "FILE",
             "Write pressure and gap at the nodes as CSV, columns x,y,pressure,gap");
    output.add_to(command);
  }

  PointContactOptions contact;
  std::string field_file;
  Output output;
};

std::vector<Quantity> quantities_of(const PointContactInput& input,
                                    const SolvedPointContact& solved,
                                    const config::UnitSystem& units) {
  const point_contact::Solution& s = solved.solution;
  const Vector2 widths = half_widths_of(input, s);
  std::vector<Quantity> quantities = {
      {"half_widths", "half-width, greatest", widths[0], units.length},
      {"half_widths", "half-width, least", widths[1], units.length},
      {"peak_pressure", "peak pressure", s.peak_pressure(), units.stress},
      {"approach", "approach", s.approach, units.length},
      {"load", "load", s.load(), units.force}};
  if (const auto& exact = input.closed_form) {
    quantities[0].exact = std::max(exact->half_width_x, exact->half_width_y);
    quantities[1].exact = std::min(exact->half_width_x, exact->half_width_y);
    quantities[2].exact = exact->peak_pressure;
    quantities[3].exact = exact->approach;
    quantities[4].exact = exact->load;
  }
  return quantities;
}

ordered_json details_of(const PointContactInput& input, const SolvedPointContact& solved) {
  const point_contact::Solution& s = solved.solution;
  ordered_json json = {{"contact_area", s.contact_area()},
                       {"profile", input.profile},
                       {"element", point_contact::name_of(s.element)},
                       {"method", input.method},
                       {"nodes", s.grid.n1},
                       {"rows", s.grid.n2},
                       {"nodes_in_contact", s.n_in_contact()},
                       {"seconds", solved.seconds},
                       {"work",
                        {{"products", s.work.products},
                         {"preconditionings", s.work.preconditionings},
                         {"iterations", s.work.iterations},
                         {"revisions", s.work.revisions}}},
                       {"residuals",
                        {{"gap", s.residuals.gap},
                         {"separation", s.residuals.separation},
                         {"pressure", s.residuals.pressure},
                         {"load", s.residuals.load}}},
                       {"contact_regions", ordered_json::array()}};
  for (const point_contact::Region& region : point_contact::regions(s)) {
    json["contact_regions"].push_back({{"x", region.centre.x()},
                                       {"y", region.centre.y()},
                                       {"load", region.load},
                                       {"area", region.area},
                                       {"nodes", region.n_nodes}});
  }
  return json;
}

// Where nobody reads the table, it has the pressures alone, which have to be finite all the same.
Table nodes_of(const SolvedPointContact& solved, bool with_places) {
  const point_contact::Solution& s = solved.solution;
  if (!with_places) {
    return {.columns = {{.key = "pressure", .numbers = to_vector(s.pressure)}},
            .in_json = InJson::no};
  }
  Column x{.key = "x"};
  Column y{.key = "y"};
  for (Eigen::Index j = 0; j < s.grid.n2; ++j) {
    for (Eigen::Index i = 0; i < s.grid.n1; ++i) {
      const Vector2 at = s.grid.node(i, j);
      x.numbers.push_back(at.x());
      y.numbers.push_back(at.y());
    }
  }
  // Where there is no body its distance is infinite.
  Table table{.columns = {std::move(x),
                          std::move(y),
                          {.key = "pressure", .numbers = to_vector(s.pressure)},
                          {.key = "gap", .numbers = to_vector(s.gap), .may_be_infinite = true}},
              .in_json = InJson::no};
  return table;
}

std::string notes_of(const PointContactInput& input, const SolvedPointContact& solved,
                     const config::UnitSystem& units) {
  const point_contact::Solution& s = solved.solution;
  std::string text;
  text += regions_text(point_contact::regions(s), [&](const point_contact::Region& region) {
    return fmt::format("{:.6g} {} about ({:.6g}, {:.6g}) {}, {} nodes", region.load, units.force,
                       region.centre.x(), region.centre.y(), units.length, region.n_nodes);
  });
  text += fmt::format("{} of {} x {} nodes in contact, {:.6g} {} apart; {}, {} elements",
                      s.n_in_contact(), s.grid.n1, s.grid.n2, s.grid.spacing, units.length,
                      input.method, point_contact::name_of(s.element));
  text += fmt::format("\n{:.3g} s, {} products and {} preconditionings on these nodes\n",
                      solved.seconds, s.work.products, s.work.preconditionings);
  return text + residuals_text(s.residuals, units, units.force);
}

// The pressure at any point: that of the nearest node, 0 outside the grid.
double pressure_at(const point_contact::Solution& solution, const Vector2& at) {
  const point_contact::Grid& grid = solution.grid;
  const auto nearest = [&](double from_middle, Eigen::Index n) {
    return static_cast<Eigen::Index>(
        std::llround(from_middle / grid.spacing + static_cast<double>(n - 1) / 2));
  };
  const Eigen::Index j = nearest(at.y(), grid.n2);
  if (j < 0 || j >= grid.n2) return 0;
  const Eigen::Index i = nearest(at.x(), grid.n1);
  return i < 0 || i >= grid.n1 ? 0 : solution.pressure[grid.index(i, j)];
}

// Half the sides of the rectangle about the origin that holds the contact, with a little room.
Vector2 half_sides_of(const point_contact::Solution& solution) {
  const point_contact::Grid& grid = solution.grid;
  Vector2 half = Vector2::Zero();
  for (Eigen::Index j = 0; j < grid.n2; ++j) {
    for (Eigen::Index i = 0; i < grid.n1; ++i) {
      if (solution.pressure[grid.index(i, j)] > 0) half = half.cwiseMax(grid.node(i, j).cwiseAbs());
    }
  }
  constexpr double room = 1.12;
  return room * half;
}

literate::Figure point_contact_figure(const PointContactInput& input,
                                      const SolvedPointContact& solved,
                                      const config::UnitSystem& units) {
  const point_contact::Solution& s = solved.solution;
  const Vector2 half = half_sides_of(s);

  constexpr int n_across = 200;
  std::vector<double> x, y, pressure;
  for (int j = 0; j < n_across; ++j) {
    for (int i = 0; i < n_across; ++i) {
      x.push_back(place(i, n_across, -half.x(), half.x()));
      y.push_back(place(j, n_across, -half.y(), half.y()));
      pressure.push_back(pressure_at(s, {x.back(), y.back()}));
    }
  }
  literate::Figure figure{.width_cm = 20,
                          .height_cm = 9,
                          .data = {{"surface", {{"x", x}, {"y", y}, {"pressure", pressure}}}},
                          .numbers = {{"half_x", half.x()}, {"half_y", half.y()}},
                          .texts = {{"unit", units.length}, {"stress_unit", units.stress}}};

  for (const int axis : {0, 1}) {
    const auto along = [&](int n, const std::function<double(double)>& of_place) {
      return curve("s", "pressure", n, -half[axis], half[axis], of_place);
    };
    figure.data[axis == 0 ? "along_x" : "along_y"] =
        along(61, [&](double at) { return pressure_at(s, at * Vector2::Unit(axis)); });
    if (!input.is_curved || !input.closed_form) continue;
    const PointClosedForm& exact = *input.closed_form;
    const double width = axis == 0 ? exact.half_width_x : exact.half_width_y;
    figure.data[axis == 0 ? "closed_x" : "closed_y"] = along(401, [&](double at) {
      const double share = at / width;
      return exact.peak_pressure * std::sqrt(std::max(0.0, 1 - share * share));
    });
  }
  return figure;
}

ExitCode run(const PointContactCommandOptions& options) {
  const auto from_file = case_of(options.contact.case_file());
  const config::UnitSystem units = options.output.units(from_file);
  require_folder_of("--field", options.field_file);
  const PointContactInput input = options.contact.read(from_file);
  const SolvedPointContact solved = solve(input);
  const Result result{
      .quantities = quantities_of(input, solved, units),
      .closed_form = input.closed_form ? input.closed_form->name : "",
      .details = details_of(input, solved),
      .tables = {nodes_of(solved, options.output.is_csv() || !options.field_file.empty())},
      .notes = notes_of(input, solved, units),
      .warnings = validity_warnings(input, solved),
      .script = "point-contact",
      .figure = [&] { return point_contact_figure(input, solved, units); }};
  require_finite(result);
  if (!options.field_file.empty()) {
    sys::write_file_atomically(options.field_file, csv_text(result.tables.front()));
  }
  return options.output.print(result);
}

}  // namespace

void add_point_contact_command(CLI::App& program, ExitCode& exit_code) {
  add_command<PointContactCommandOptions>(
      program, "point-contact",
      "Two bodies pressed together at a point: pressure and gap on a plane of nodes", exit_code,
      run);
}

}  // namespace app
