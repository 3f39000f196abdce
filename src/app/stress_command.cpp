// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "app/commands.hpp"
#include "app/contact_options.hpp"
#include "app/csv_files.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/solution.hpp"

namespace app {
namespace {

struct StressCommandOptions {
  explicit StressCommandOptions(CLI::App& command) : contact(command) {
    add_text(command, "--x", x, "LIST", "Positions along the surface, as 0,0.01");
    add_text(command, "--z", z, "LIST", "Depths; every x is taken with every z");
    add_text(command, "--points", points, "FILE", "Or a CSV file with the columns x,z");
    add_choice(command, "--body", body, {"1", "2"}, "Which of the two bodies");
    output.add_to(command);
  }

  ContactOptions contact;
  std::string x, z, points;
  std::string body = "1";
  Output output;
};

struct Point {
  double x;
  double z;
  elasticity::Stress stress;
  std::optional<elasticity::Stress> mcewen;
};

std::vector<Point> points_of(const StressCommandOptions& options) {
  std::vector<Point> points;
  const bool is_list = !options.x.empty() || !options.z.empty();
  refuse_if(is_list == !options.points.empty(), "give either --x and --z, or --points");
  refuse_if(is_list && options.x.empty(), "--x is missing");
  refuse_if(is_list && options.z.empty(), "--z is missing");
  if (!options.points.empty()) {
    const CsvColumns columns = read_columns(options.points, "x", "z");
    for (std::size_t i = 0; i < columns.first.size(); ++i) {
      points.push_back({columns.first[i], columns.second[i], {}, {}});
    }
    return points;
  }
  for (const double z : parse_numbers("--z", options.z)) {
    for (const double x : parse_numbers("--x", options.x)) points.push_back({x, z, {}, {}});
  }
  return points;
}

void compute(std::vector<Point>& points, const ContactInput& input, const SolvedContact& solved) {
  std::optional<line_contact::McEwen> mcewen;
  if (input.hertz) mcewen.emplace(*input.hertz);
  for (Point& point : points) {
    point.stress = line_contact::stress_beneath(solved.solution, point.x, point.z);
    if (mcewen) point.mcewen = mcewen->stress(point.x, point.z);
  }
}

Table table_of(const std::vector<Point>& points, double poisson, const config::UnitSystem& units) {
  const std::string length = fmt::format("[{}]", units.length);
  const std::string stress = fmt::format("[{}]", units.stress);
  Table table;
  const auto add = [&](const char* key, std::vector<std::string> heads, int width,
                       const auto& of_point) {
    table.columns.push_back(column_of(points, key, std::move(heads), width, "{:.6g}", of_point));
  };
  add("x", {"x", length}, 12, [](const Point& p) { return p.x; });
  add("z", {"z", length}, 12, [](const Point& p) { return p.z; });
  add("stress_xx", {"stress xx", stress}, 14, [](const Point& p) { return p.stress.xx; });
  add("stress_zz", {"stress zz", stress}, 14, [](const Point& p) { return p.stress.zz; });
  add("stress_xz", {"stress xz", stress}, 14, [](const Point& p) { return p.stress.xz; });
  add("max_shear", {"max shear", stress}, 14, [](const Point& p) { return p.stress.max_shear(); });
  add("von_mises", {"von Mises", stress}, 14,
      [&](const Point& p) { return p.stress.von_mises(poisson); });
  if (!points.empty() && points.front().mcewen) {
    add("mcewen_max_shear", {"McEwen", "max shear"}, 14,
        [](const Point& p) { return p.mcewen->max_shear(); });
  }
  return table;
}

// Against the depth, a curve for each x; if all points lie at one depth, along x. A NaN parts the
// curves.
literate::Figure stress_figure(std::vector<Point> points, double poisson,
                               const config::UnitSystem& units) {
  const bool is_along_x =
      points.size() > 1 && std::ranges::all_of(points, [z = points.front().z](const Point& point) {
        return point.z == z;
      });
  const auto curve = [&](const Point& point) { return is_along_x ? point.z : point.x; };
  const auto place = [&](const Point& point) { return is_along_x ? point.x : point.z; };
  std::stable_sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    return curve(a) < curve(b) || (curve(a) == curve(b) && place(a) < place(b));
  });
  std::vector<double> places, shear, von_mises, mcewen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& point = points[i];
    if (i > 0 && curve(point) != curve(points[i - 1])) {
      for (std::vector<double>* column : {&places, &shear, &von_mises, &mcewen}) {
        column->push_back(literate::gap);
      }
    }
    places.push_back(place(point));
    shear.push_back(point.stress.max_shear());
    von_mises.push_back(point.stress.von_mises(poisson));
    mcewen.push_back(point.mcewen ? point.mcewen->max_shear() : literate::gap);
  }
  literate::Figure figure{
      .width_cm = 14,
      .height_cm = 9,
      .data = {{"points", {{"place", places}, {"max_shear", shear}, {"von_mises", von_mises}}}},
      .texts = {{"axis", is_along_x ? "x" : "z"},
                {"length_unit", units.length},
                {"stress_unit", units.stress}}};
  if (points.front().mcewen) figure.data["mcewen"] = {{"place", places}, {"max_shear", mcewen}};
  return figure;
}

ExitCode run(const StressCommandOptions& options) {
  const auto from_file = case_of(options.contact.case_file());
  const config::UnitSystem units = options.output.units(from_file);
  std::vector<Point> points = points_of(options);
  const ContactInput input = options.contact.read(from_file);
  const bool is_second = options.body == "2";
  const SolvedContact solved = solve(input);
  compute(points, input, solved);
  const double poisson = (is_second ? input.material2 : input.material1).poisson();
  return options.output.print({.tables = {table_of(points, poisson, units)},
                               .warnings = validity_warnings(input, solved),
                               .script = "stress",
                               .figure = [&] { return stress_figure(points, poisson, units); }});
}

}  // namespace

void add_stress_command(CLI::App& program, ExitCode& exit_code) {
  add_command<StressCommandOptions>(
      program, "stress", "Stresses inside one of two bodies pressed together", exit_code, run);
}

}  // namespace app
