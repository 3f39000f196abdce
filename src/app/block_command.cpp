// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "app/bodies.hpp"
#include "app/output.hpp"
#include "block/analysis.hpp"
#include "block/rectangle.hpp"
#include "block/solution.hpp"
#include "command_line/stopwatch.hpp"
#include "system/error.hpp"

namespace app {
namespace {

using block::Support;
using parameters::BlockCase;
using parameters::HalfSpaceCase;

struct BlockOptions {
  CLI::App& command;
  LoadFlags load{command, "--shape,--load", Shapes::named};
  MaterialFlags material{command};
  Flag width{command, "--width", "LENGTH", "Block", "Width; the load is in the middle of the top"};
  Flag height{command, "--height", "LENGTH", "Block", "Height"};
  Choice sides{command,
               "--sides",
               {"clamped", "roller", "free"},
               "Block",
               "Supports on the left and right; the bottom is clamped [clamped, or the case's]"};
  Flag x{command, "--x", "LENGTH", "Block",
         "Points on the top whose displacements are measure1, measure2, ... [the case's]"};
  Flag order{command, "--order", "COUNT", "Solution",
             "Polynomial order of the elements, 4 to 10 [7, or the case's]"};
  Flag refine{command, "--refine", "COUNT", "Solution",
              "Level of refinement, 1 to 4 [1, or the case's]"};
  Output output{command, "[half_space] and [block]"};
};

std::string unit_of(const std::string& measure, const config::UnitSystem& units) {
  if (measure.starts_with("max_disp") || measure.starts_with("measure")) return units.length;
  if (measure.starts_with("resultant")) return units.line_load;
  return measure == "strain_energy" ? units.force : units.stress;
}

// The value with as many digits as its error supports.
std::string earned(const numerics::Estimate& estimate) {
  constexpr int most = 10;
  const int digits = earned_digits(estimate.abs_error / std::abs(estimate.value), most);
  return fmt::format("{:.{}g}", estimate.value, digits);
}

void add_measures(Result& result, const std::vector<block::MeasureEstimate>& measures,
                  const config::UnitSystem& units, bool with_table) {
  Column names{.key = "measure", .heads = {"measure"}};
  Column values{.key = "value", .heads = {"value"}};
  Column errors{.key = "abs_error", .heads = {"error"}};
  Column of_units{.key = "unit", .heads = {"unit"}};
  for (const auto& [name, estimate] : measures) {
    const std::string unit = unit_of(name, units);
    names.cells.push_back(name);
    values.numbers.push_back(estimate.value);
    values.cells.push_back(earned(estimate));
    errors.numbers.push_back(estimate.abs_error);
    errors.cells.push_back(fmt::format("{:.2g}", estimate.abs_error));
    of_units.cells.push_back(unit);
    result.details["measures"][name] = {
        {"value", values.numbers.back()}, {"abs_error", estimate.abs_error}, {"unit", unit}};
  }
  if (with_table) result.table = {names, values, errors, of_units};
}

// Lists the discs that the maxima exclude, because stresses have no limit there.
void add_left_out(Result& result, const std::vector<block::Disc>& discs, const std::string& unit) {
  result.details["left_out"] = Json::array();
  for (const block::Disc& disc : discs) {
    result.details["left_out"].push_back(
        {{"x", disc.x}, {"y", -disc.z}, {"radius", disc.radius}, {"unit", unit}});
    result.notes.push_back(
        fmt::format("stresses exclude {:.3g} {} about ({:.6g}, {:.6g}), where they have no limit",
                    disc.radius, unit, disc.x, 0 - disc.z));
  }
}

void run(const BlockOptions& options) {
  const Given given = options.output.given();
  const config::UnitSystem& units = given.units;
  std::optional<HalfSpaceCase> half_space;
  std::optional<BlockCase> from_case;
  if (given.file) half_space = given.file->half_space();
  if (given.file) from_case = given.file->block();
  std::vector<std::string> assumed;
  const Material material = material_of(
      {&options.material}, of_case(half_space, &HalfSpaceCase::material), units.stress, assumed);
  const ChosenLoad load = options.load.read(of_case(half_space, &HalfSpaceCase::load), units);
  const auto rectangle_of_case = of_case(from_case, &BlockCase::rectangle);
  const auto size_of_case = [&](double (block::Rectangle::*size)() const) {
    return rectangle_of_case ? std::optional(((*rectangle_of_case).*size)()) : std::nullopt;
  };
  const auto sizes =
      read({{options.width, units.length, size_of_case(&block::Rectangle::width)},
            {options.height, units.length, size_of_case(&block::Rectangle::height)}});
  if (sizes[0] < 2 * load.reach()) {
    throw sys::InputError(fmt::format("--width = {}: must be at least {} {}, the width of the load",
                                      options.width.text_or(rounded(sizes[0]) + " " + units.length),
                                      rounded(2 * load.reach()), units.length));
  }
  const block::Rectangle rectangle(sizes[0], sizes[1]);
  const std::map<std::string, Support> supports = {
      {"clamped", Support::clamped}, {"roller", Support::roller}, {"free", Support::free}};
  const Support sides = options.sides.is_given()
                            ? supports.at(options.sides.text())
                            : of_case(from_case, &BlockCase::sides).value_or(Support::clamped);
  block::Discretization discretization;
  if (from_case) discretization = from_case->discretization;
  discretization.order =
      static_cast<int>(options.order.count(4, 10).value_or(discretization.order));
  discretization.refine =
      static_cast<int>(options.refine.count(1, 4).value_or(discretization.refine));
  std::vector<double> points = options.x.quantities(units.length);
  if (points.empty() && half_space) points = half_space->points;

  const command_line::Stopwatch stopwatch;
  const block::Analysis analysis(rectangle, material, {load.load}, discretization);
  const block::SupportedBlock supported = analysis.on(block::with_sides(sides));
  const block::RefinedSolution solution = supported.solve(load.load);
  const auto measures = solution.measures(points);
  Result result{.notes = note_of(assumed)};
  result.details = {{"order", discretization.order},
                    {"elements", analysis.fine()->mesh().n_elements()},
                    {"unknowns", supported.fine().n_unknowns()},
                    {"seconds", stopwatch.seconds()}};
  result.notes.push_back(
      fmt::format("{} unknowns; x along the top, y upwards", supported.fine().n_unknowns()));
  add_measures(result, measures, units, options.output.format() != "json");
  add_left_out(result, solution.left_out(), units.length);
  options.output.print(result, [&] {
    return Picture{fmt::format("x ({})", units.length),
                   fmt::format("u_z ({})", units.length),
                   {line("u_z of the top", rectangle.left(), rectangle.right(),
                         [&](double x) { return solution.displacement_z(x, 0).value; })}};
  });
}

}  // namespace

void add_block_command(CLI::App& program) {
  add_command<BlockOptions>(
      program, "block",
      "A finite block under a strip load or a triangular load, by finite elements in plane strain",
      R"(Displacements, strain energy and the greatest stresses are named as in
Ruggiero's Appendix 2, each with its error.

Examples:
  A steel block of 50 by 25 mm on a rigid base, 100 MPa on |x| <= 1 mm:
    halfspace block --width 50 --height 25 --shape uniform --peak-pressure 100 \
      --half-width 1 --sides free
  The same on rollers, with displacements at points on the top, plotted below:
    halfspace block --width 50 --height 25 --shape uniform --peak-pressure 100 \
      --half-width 1 --sides roller --x 0:10:1 --plot -
  The block of a case file, as JSON:
    halfspace block --case report/ruggiero2001.toml --format json)",
      run);
}

}  // namespace app
