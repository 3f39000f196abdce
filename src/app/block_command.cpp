// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/load_choices.hpp"
#include "block/analysis.hpp"
#include "block/rectangle.hpp"
#include "command_line/stage.hpp"
#include "system/require.hpp"

namespace app {
namespace {

using block::Support;

struct BlockOptions {
  explicit BlockOptions(CLI::App& command)
      : width(command, "--width", "Width of the block (default: the case's)"),
        height(command, "--height", "Height of the block (default: the case's)"),
        order(command, "--order",
              "Polynomial order of the elements, 2 to 10 (default: the case's)"),
        refine(command, "--refine", "Level of refinement, 0 to 6 (default: the case's)"),
        load(command, "--load", "triangular", "Shape of the load, with the case's peak and width",
             choices_of(wide_load_choices())) {
    add_required_text(command, "--case", case_file, "FILE",
                      "Case file; flags override what it says");
    add_choice(command, "--sides", sides, {"", "clamped", "roller", "free"},
               "How left and right are held (default: the case's)");
    output.add_to(command);
  }

  NumberOption width, height, order, refine;
  ChoiceOption load;
  std::string case_file, sides;
  Output output;
};

Support sides_of(const std::string& name, Support from_case) {
  if (name == "clamped") return Support::clamped;
  if (name == "roller") return Support::roller;
  return name == "free" ? Support::free : from_case;
}

// Everything that one run of the command computes.
struct Problem {
  parameters::Case from_file;
  block::Rectangle rectangle;
  block::Discretization discretization;
  elasticity::Load load;
  block::Supports supports;
};

Problem problem_of(const BlockOptions& options) {
  parameters::Case c = parameters::read_case(options.case_file);
  if (!c.block) throw sys::InputError(options.case_file + ": has no [block]");
  block::Discretization discretization = c.block->discretization;
  if (const auto order = options.order.integer()) discretization.order = static_cast<int>(*order);
  if (const auto refine = options.refine.integer())
    discretization.refine = static_cast<int>(*refine);
  const block::Rectangle rectangle(options.width.number_or(c.block->rectangle.width()),
                                   options.height.number_or(c.block->rectangle.height()));
  elasticity::Load load = wide_load_choices()[options.load.row()]
                              .make(options.load, numbers_of(c.half_space.load))
                              .load;
  const block::Supports supports = block::with_sides(sides_of(options.sides, c.block->sides));
  return {std::move(c), rectangle, discretization, std::move(load), supports};
}

using Measures = std::vector<block::MeasureEstimate>;

struct Seconds {
  double elements, assembly, factorization, solution;
};

nlohmann::ordered_json details_of(const block::Analysis& analysis,
                                  const block::SupportedBlock& supported, const Seconds& seconds) {
  return {{"order", analysis.fine()->mesh().order()},
          {"elements", analysis.fine()->mesh().n_elements()},
          {"unknowns", supported.fine().n_unknowns()},
          {"condensed_unknowns", supported.fine().n_condensed_unknowns()},
          {"seconds",
           {{"elements", seconds.elements},
            {"assembly", seconds.assembly},
            {"factorization", seconds.factorization},
            {"solution", seconds.solution}}}};
}

std::string unit_of(const std::string& measure, const config::UnitSystem& units) {
  if (measure.starts_with("max_disp") || measure.starts_with("measure")) return units.length;
  if (measure.starts_with("resultant")) return units.line_load;
  if (measure.starts_with("max_rot")) return units.unit(config::Dimension::none);
  return measure == "strain_energy" ? units.force : units.stress;
}

Table table_of(const Measures& measures, const config::UnitSystem& units) {
  Column names{.key = "measure", .heads = {"measure"}, .width = -24};
  Column values{.key = "value", .heads = {"value"}, .width = 18, .format = "{:.9e}"};
  Column errors{.key = "abs_error", .heads = {"error"}, .width = 11, .format = "{:.1e}"};
  Column of_units{.key = "", .heads = {"  unit"}};
  for (const block::MeasureEstimate& m : measures) {
    names.texts.push_back(m.name);
    values.numbers.push_back(m.value.value);
    errors.numbers.push_back(m.value.abs_error);
    of_units.texts.push_back("  " + unit_of(m.name, units));
  }
  return {{names, values, errors, of_units}, InJson::by_text, "measures"};
}

std::string notes_of(const block::SupportedBlock& supported, const Seconds& seconds) {
  return fmt::format(
      "{} unknowns, {} after condensation\n"
      "seconds: elements {:.3f}, assembly {:.3f}, factorisation {:.3f}, solution {:.3f}\n",
      supported.fine().n_unknowns(), supported.fine().n_condensed_unknowns(), seconds.elements,
      seconds.assembly, seconds.factorization, seconds.solution);
}

// u_z along the loaded side, z = 0, at the points of its elements.
literate::Figure block_figure(const block::Solution& solution, const config::UnitSystem& units) {
  const block::Mesh& mesh = solution.model().mesh();
  const Eigen::VectorXd points = Eigen::VectorXd::LinSpaced(mesh.order() + 1, -1, 1);
  std::map<double, double> displacements;
  for (Eigen::Index e = 0; e < mesh.n_elements(); ++e) {
    for (const block::PointState& state : solution.sample(e, points)) {
      if (state.position.y() == 0) displacements[state.position.x()] = state.displacement.y();
    }
  }
  std::vector<double> x, u;
  for (const auto& [at, displacement] : displacements) {
    x.push_back(at);
    u.push_back(displacement);
  }
  return {.width_cm = 14,
          .height_cm = 9,
          .data = {{"surface", {{"x", x}, {"u_z", u}}}},
          .texts = {{"unit", units.length}}};
}

ExitCode run(const BlockOptions& options) {
  const Problem problem = problem_of(options);
  const config::UnitSystem units = options.output.units(problem.from_file);
  const block::Analysis analysis(problem.rectangle, problem.from_file.half_space.material,
                                 {problem.load}, problem.discretization);
  const block::SupportedBlock supported = analysis.on(problem.supports);
  const Stopwatch stopwatch;
  const block::RefinedSolution solution = supported.solve(problem.load);
  const double solving = stopwatch.seconds();
  const Seconds seconds = {analysis.fine()->seconds(), supported.fine().assembly_seconds(),
                           supported.fine().factorization_seconds(), solving};
  block::MeasureOptions measure_options;
  measure_options.surface_points = problem.from_file.half_space.points;
  const Measures measures = solution.measures(measure_options);
  const Result result{.details = details_of(analysis, supported, seconds),
                      .tables = {table_of(measures, units)},
                      .notes = notes_of(supported, seconds),
                      .script = "block",
                      .figure = [&] { return block_figure(solution.fine(), units); }};
  return options.output.print(result);
}

}  // namespace

void add_block_command(CLI::App& program, ExitCode& exit_code) {
  add_command<BlockOptions>(program, "block",
                            "The finite block of Appendix 2 by plane-strain finite elements",
                            exit_code, run);
}

}  // namespace app
