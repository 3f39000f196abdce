// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bodies.hpp"
#include "app/contact.hpp"
#include "elasticity/stress.hpp"

namespace app {
namespace {

using elasticity::Stress;

struct StressOptions {
  CLI::App& command;
  LoadFlags load{command, "--shape", Shapes::of_finite_width};
  ContactFlags contact{command};
  Flag x{command, "--x", "LENGTH", "Points", "Positions along the surface, a list or a range [0]"};
  Flag z{command, "--z", "LENGTH", "Points",
         "Depths, a list or a range, combined with every x [to twice the half-width]"};
  Output output{command, "[contact], or [half_space] with --shape"};
};

// The stresses beneath a load or a contact, as functions of (x, z).
struct Pressed {
  std::function<Stress(double, double)> stress, mcewen;  // McEwen's for cylinders alone
  double half_width;
  double peak_pressure;
  Material material;
  std::vector<std::string> notes = {}, warnings = {};
};

Pressed pressed_by_load(const StressOptions& options, const Given& given) {
  std::optional<parameters::HalfSpaceCase> from_case;
  if (given.file) from_case = given.file->half_space();
  const ContactFlags& contact = options.contact;
  const auto& [_, both, body1, body2] = contact.materials;
  refuse_given({&contact.load, &contact.datum, &contact.radius1, &contact.radius2, &body1.young,
                &body1.poisson, &body2.young, &body2.poisson, &contact.profile, &contact.nodes,
                &contact.domain, &contact.element, &contact.method, &contact.tolerance},
               options.load.name());
  const ChosenLoad load =
      options.load.read(of_case(from_case, &parameters::HalfSpaceCase::load), given.units);
  std::vector<std::string> assumed;
  const Material material =
      material_of({&both}, of_case(from_case, &parameters::HalfSpaceCase::material),
                  given.units.stress, assumed);
  const auto [least, greatest] = std::ranges::minmax(load.pressure);
  const auto stress = [load](double x, double z) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (z == 0 && load.jump_at(x) != 0) return Stress{none, none, none};
    return elasticity::stress_beneath(load.x, load.pressure, x, z);
  };
  return {stress, {}, load.reach(), std::max(-least, greatest), material, note_of(assumed)};
}

Pressed pressed_by_contact(const StressOptions& options, const Given& given) {
  const LoadFlags& load = options.load;
  refuse_given({&load.peak_pressure, &load.half_width}, "a contact; a pressure needs --shape");
  refuse_given({&options.contact.datum}, "stresses");
  if (options.contact.element.text_or("triangular") != "triangular") {
    options.contact.element.refuse("stresses need triangular elements");
  }
  const SolvedContact solved = options.contact.solve(given);
  Pressed pressed{
      [s = solved.solution](double x, double z) { return line_contact::stress_beneath(s, x, z); },
      {},
      solved.half_width(),
      solved.solution.peak_pressure(),
      solved.material,
      solved.notes,
      solved.warnings};
  if (solved.hertz) {
    pressed.mcewen = [mcewen = line_contact::McEwen(*solved.hertz)](double x, double z) {
      return mcewen.stress(x, z);
    };
  }
  return pressed;
}

struct Point {
  double x, z;
  Stress stress;
  double mcewen;  // McEwen's greatest in-plane shear
};

std::vector<Point> points_of(const StressOptions& options, const Pressed& pressed,
                             const std::string& length) {
  constexpr int n = 20;
  std::vector<double> x = options.x.quantities(length), z = options.z.quantities(length);
  if (x.empty()) x = {0};
  if (z.empty()) {
    const double step = parse_number("", fmt::format("{:.1e}", 2 * pressed.half_width / n));
    z = evenly_spaced(0, step, n + 1);
  }
  std::vector<Point> points;
  for (const double depth : z) {
    if (!(depth >= 0)) options.z.refuse("depths must be 0 or greater");
    for (const double at : x) {
      points.push_back({at, depth, pressed.stress(at, depth),
                        pressed.mcewen ? pressed.mcewen(at, depth).max_shear() : 0});
    }
  }
  return points;
}

Table table_of(const std::vector<Point>& points, const Pressed& pressed,
               const config::UnitSystem& units) {
  const double nu = pressed.material.poisson();
  const auto column = [&](const auto& of_point) {
    std::vector<double> numbers(points.size());
    std::ranges::transform(points, numbers.begin(), of_point);
    return numbers;
  };
  Table table = {column_of_places("x", units.length, column([](const Point& p) { return p.x; })),
                 column_of_places("z", units.length, column([](const Point& p) { return p.z; }))};
  const auto add = [&](const char* key, const char* head, const char* second,
                       const auto& of_stress) {
    constexpr int digits = 5;
    table.push_back(aligned_column(key, {head, second}, units.stress,
                                   column([&](const Point& p) { return of_stress(p.stress); }),
                                   pressed.peak_pressure, digits));
  };
  add("stress_xx", "stress", "xx", [](const Stress& s) { return s.xx; });
  add("stress_zz", "stress", "zz", [](const Stress& s) { return s.zz; });
  add("stress_xz", "stress", "xz", [](const Stress& s) { return s.xz; });
  add("max_shear", "in-plane", "max shear", [](const Stress& s) { return s.max_shear(); });
  add("largest_shear", "largest", "shear", [&](const Stress& s) { return s.largest_shear(nu); });
  add("von_mises", "von", "Mises", [&](const Stress& s) { return s.von_mises(nu); });
  table.push_back(
      {.key = "stress_yy", .numbers = column([&](const Point& p) { return p.stress.yy(nu); })});
  if (pressed.mcewen) {
    table.push_back(
        {.key = "mcewen_max_shear", .numbers = column([](const Point& p) { return p.mcewen; })});
  }
  return table;
}

void add_notes(std::vector<std::string>& notes, const std::vector<Point>& points,
               const Pressed& pressed) {
  notes.emplace_back("largest shear: over all planes (Tresca); tension is positive");
  if (!pressed.mcewen) return;
  double difference = 0;
  for (const Point& p : points) {
    difference = std::max(difference, std::abs(p.stress.max_shear() - p.mcewen));
  }
  notes.push_back(
      fmt::format("in-plane shear differs from McEwen's by at most {:.1g} % of the peak pressure",
                  100 * difference / pressed.peak_pressure));
}

// Plots the stresses over the depth, one curve per x; over x if all points have the same depth.
Picture picture_of(const std::vector<Point>& points, double nu, const config::UnitSystem& units) {
  const bool is_along_x = points.size() > 1 && points.front().z == points.back().z;
  std::map<double, std::vector<Point>> curves;
  for (const Point& point : points) curves[is_along_x ? point.z : point.x].push_back(point);
  Curve shear{"largest shear", true, {}, {}}, von_mises{"von Mises", true, {}, {}};
  const auto add = [&](double at, double largest_shear, double mises) {
    shear.x.push_back(at);
    shear.y.push_back(largest_shear);
    von_mises.x.push_back(at);
    von_mises.y.push_back(mises);
  };
  for (const auto& [_, curve] : curves) {
    for (const Point& p : curve) {
      add(is_along_x ? p.x : p.z, p.stress.largest_shear(nu), p.stress.von_mises(nu));
    }
    add(std::nan(""), std::nan(""), std::nan(""));  // breaks the line before the next
  }
  return {fmt::format("{} ({})", is_along_x ? "x" : "depth z", units.length),
          fmt::format("stress ({})", units.stress),
          {shear, von_mises}};
}

void run(const StressOptions& options) {
  const Given given = options.output.given();
  const config::UnitSystem& units = given.units;
  const Pressed pressed = options.load.shape.is_given() ? pressed_by_load(options, given)
                                                        : pressed_by_contact(options, given);
  const std::vector<Point> points = points_of(options, pressed, units.length);
  Result result{.table = table_of(points, pressed, units),
                .units = {{"x", units.length}, {"z", units.length}, {"stress", units.stress}},
                .notes = pressed.notes,
                .warnings = pressed.warnings};
  add_notes(result.notes, points, pressed);
  options.output.print(result,
                       [&] { return picture_of(points, pressed.material.poisson(), units); });
}

}  // namespace

void add_stress_command(CLI::App& program) {
  add_command<StressOptions>(
      program, "stress",
      "Stresses beneath a line contact, or beneath a strip load or any other pressure",
      R"(Plane strain, z into the body. With --shape the pressure is given; without it
two bodies are pressed together as in 'halfspace contact', and the stresses are
those in body 1. Beneath cylinders the shear is compared with McEwen's closed
form.

Examples:
  On the axis beneath a steel cylinder on a plane, to twice the half-width:
    halfspace stress --radius1 10 --load 100 --plot -
  Beneath a strip load of 100 MPa on |x| <= 1 mm:
    halfspace stress --shape uniform --peak-pressure 100 --half-width 1 \
      --z 0:3:0.25
  Across the contact at one depth, as JSON:
    halfspace stress --radius1 10 --load 100 --x -0.2:0.2:0.01 --z 0.08 \
      --format json)",
      run);
}

}  // namespace app
