// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "app/commands.hpp"
#include "app/contact_options.hpp"
#include "app/contact_output.hpp"
#include "app/csv_columns.hpp"
#include "app/json_text.hpp"
#include "app/output_format.hpp"
#include "app/picture.hpp"
#include "app/validity.hpp"
#include "command_line/number_text.hpp"
#include "line_contact/mcewen.hpp"
#include "line_contact/traction.hpp"

namespace app {
namespace {

struct StressCommandOptions {
  explicit StressCommandOptions(CLI::App& command) : contact(command) {
    add_text(command, "--x", x, "LIST", "Positions along the surface, as 0,0.01");
    add_text(command, "--z", z, "LIST", "Depths; every x is taken with every z");
    add_text(command, "--points", points, "FILE", "Or a CSV file with the columns x,z");
    add_choice(command, "--body", body, {"1", "2"}, "Which of the two bodies");
    output.add_to(command);
    plot.add_to(command);
  }

  ContactOptions contact;
  std::string x, z, points;
  std::string body = "1";
  OutputOptions output;
  PlotOption plot;
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
  if (is_list == !options.points.empty()) {
    throw sys::InputError("give either --x and --z, or --points");
  }
  if (is_list && (options.x.empty() || options.z.empty())) {
    throw sys::InputError(options.x.empty() ? "--x is missing" : "--z is missing");
  }
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

void compute(std::vector<Point>& points, const ContactInput& input, const SolvedContact& solved,
             bool is_second) {
  const Eigen::VectorXd shear = solved.friction ? solved.friction->shear : Eigen::VectorXd();
  const auto traction = line_contact::traction_on(solved.solution, is_second ? -shear : shear);
  std::optional<line_contact::McEwen> mcewen;
  if (input.hertz && !solved.friction) mcewen.emplace(*input.hertz);
  for (Point& point : points) {
    const elasticity::Stress s = traction.stress(point.x, point.z);
    point.stress = {s.xx + 0.0, s.zz + 0.0, s.xz + 0.0};  // no -0
    if (mcewen) point.mcewen = mcewen->stress(point.x, point.z);
  }
}

std::string stress_json(const std::vector<Point>& points, double poisson) {
  auto json = nlohmann::ordered_json::array();
  for (const Point& point : points) {
    nlohmann::ordered_json entry = {{"x", point.x},
                                    {"z", point.z},
                                    {"stress_xx", point.stress.xx},
                                    {"stress_zz", point.stress.zz},
                                    {"stress_xz", point.stress.xz},
                                    {"max_shear", point.stress.max_shear()},
                                    {"von_mises", point.stress.von_mises(poisson)}};
    if (point.mcewen) entry["mcewen_max_shear"] = point.mcewen->max_shear();
    json.push_back(std::move(entry));
  }
  return json_text(json);
}

std::string stress_csv(const std::vector<Point>& points, double poisson) {
  std::string text = "x,z,stress_xx,stress_zz,stress_xz,max_shear,von_mises";
  const bool has_mcewen = !points.empty() && points.front().mcewen;
  text += has_mcewen ? ",mcewen_max_shear\n" : "\n";
  for (const Point& point : points) {
    const elasticity::Stress& s = point.stress;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "{},{},{},{},{},{},{}", point.x, point.z, s.xx, s.zz, s.xz, s.max_shear(),
                   s.von_mises(poisson));
    if (point.mcewen) fmt::format_to(out, ",{}", point.mcewen->max_shear());
    text += '\n';
  }
  return text;
}

std::string stress_text(const std::vector<Point>& points, double poisson,
                        const config::UnitSystem& units) {
  const std::string length = fmt::format("[{}]", units.length);
  const std::string stress = fmt::format("[{}]", units.stress);
  const bool has_mcewen = !points.empty() && points.front().mcewen;
  std::string text = fmt::format("{:>12}{:>12}{:>14}{:>14}{:>14}{:>14}{:>14}{}\n", "x", "z",
                                 "stress xx", "stress zz", "stress xz", "max shear", "von Mises",
                                 has_mcewen ? "        McEwen" : "");
  text += fmt::format("{:>12}{:>12}{:>14}{:>14}{:>14}{:>14}{:>14}{}\n", length, length, stress,
                      stress, stress, stress, stress, has_mcewen ? "     max shear" : "");
  for (const Point& point : points) {
    const elasticity::Stress& s = point.stress;
    text += fmt::format("{:>12.6g}{:>12.6g}{:>14.6g}{:>14.6g}{:>14.6g}{:>14.6g}{:>14.6g}", point.x,
                        point.z, s.xx, s.zz, s.xz, s.max_shear(), s.von_mises(poisson));
    if (point.mcewen) text += fmt::format("{:>14.6g}", point.mcewen->max_shear());
    text += '\n';
  }
  return text;
}

// Against the depth, a curve for each x; if all points lie at one depth, along x. A NaN parts the
// curves.
literate::Figure stress_figure(std::vector<Point> points, double poisson,
                               const config::UnitSystem& units) {
  const bool is_along_x =
      std::all_of(points.begin(), points.end(),
                  [&](const Point& point) { return point.z == points.front().z; }) &&
      points.size() > 1;
  const auto curve = [&](const Point& point) { return is_along_x ? point.z : point.x; };
  const auto place = [&](const Point& point) { return is_along_x ? point.x : point.z; };
  std::stable_sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    return curve(a) < curve(b) || (curve(a) == curve(b) && place(a) < place(b));
  });
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> places, shear, von_mises, mcewen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& point = points[i];
    if (i > 0 && curve(point) != curve(points[i - 1])) {
      for (std::vector<double>* column : {&places, &shear, &von_mises, &mcewen}) {
        column->push_back(gap);
      }
    }
    places.push_back(place(point));
    shear.push_back(point.stress.max_shear());
    von_mises.push_back(point.stress.von_mises(poisson));
    mcewen.push_back(point.mcewen ? point.mcewen->max_shear() : gap);
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
  std::optional<parameters::Case> from_file;
  if (!options.contact.case_file().empty()) {
    from_file = parameters::read_case(options.contact.case_file());
  }
  const config::UnitSystem units = options.output.units(from_file);
  options.plot.require_drawable(options.output);
  std::vector<Point> points = points_of(options);
  const ContactInput input = options.contact.read(from_file);
  const bool is_second = options.body == "2";
  const SolvedContact solved = solve(input);
  compute(points, input, solved, is_second);
  print_warnings(validity_warnings(input, solved));
  const double poisson = (is_second ? input.material2 : input.material1).poisson();
  for (const Point& point : points) {
    finite_result(fmt::format("stress at x = {}, z = {}", point.x, point.z),
                  point.stress.von_mises(poisson));
    if (point.mcewen) finite_result("McEwen's stress", point.mcewen->max_shear());
  }
  switch (options.output.format()) {
    case OutputFormat::csv:
      fmt::print("{}", stress_csv(points, poisson));
      break;
    case OutputFormat::json:
      fmt::print("{}", stress_json(points, poisson));
      break;
    case OutputFormat::table:
      fmt::print("{}", stress_text(points, poisson, units));
      break;
  }
  if (options.plot.is_given()) options.plot.draw("stress", stress_figure(points, poisson, units));
  return ExitCode::success;
}

}  // namespace

void add_stress_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "stress", "Stresses inside one of two bodies pressed together", exit_code,
              [](CLI::App& command) {
                auto options = std::make_shared<StressCommandOptions>(command);
                return [options] { return run(*options); };
              });
}

}  // namespace app
