// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/json_text.hpp"
#include "app/options.hpp"
#include "app/output_format.hpp"
#include "block/analysis.hpp"
#include "block/calculix_deck.hpp"
#include "block/load_shapes.hpp"
#include "block/supports.hpp"
#include "block/vtu.hpp"
#include "literate/files.hpp"
#include "numerics/require.hpp"
#include "parameters/case.hpp"

namespace app {
namespace {

using block::Support;

struct BlockOptions {
  explicit BlockOptions(CLI::App& command)
      : width(command, "--width", "Width of the block"),
        height(command, "--height", "Height of the block"),
        order(command, "--order", "Polynomial order of the elements, 2 to 10"),
        refine(command, "--refine", "Level of grading, 0 to 6") {
    add_required_text(command, "--case", case_file, "FILE",
                      "Case file; flags override what it says");
    add_text(command, "--load", load, "SHAPE",
             "triangular, uniform, elliptic, or linear:EDGE_FRACTION");
    add_choice(command, "--sides", sides, {"", "clamped", "roller", "free"},
               "How left and right are held");
    add_text(command, "--ccx", ccx_file, "FILE", "Write the model as a CalculiX deck");
    add_text(command, "--vtu", vtu_file, "FILE",
             "Write mesh, displacements, stresses for ParaView");
    output.add_to(command);
  }

  NumberOption width, height, order, refine;
  std::string case_file, load = "triangular", sides, ccx_file, vtu_file;
  OutputOptions output;
};

elasticity::Load load_of(const std::string& shape, double peak, double half_width) {
  if (shape == "triangular") return block::linear_fall(peak, 0, half_width);
  if (shape == "uniform") return block::linear_fall(peak, 1, half_width);
  if (shape == "elliptic") return block::elliptic(peak, half_width);
  const std::string prefix = "linear:";
  if (shape.starts_with(prefix)) {
    const double edge_fraction = parse_number("--load linear", shape.substr(prefix.size()));
    return block::linear_fall(peak, edge_fraction, half_width);
  }
  throw InputError("--load: \"" + shape +
                   "\" must be triangular, uniform, elliptic or linear:EDGE_FRACTION");
}

Support sides_of(const std::string& name, Support from_case) {
  if (name == "clamped") return Support::clamped;
  if (name == "roller") return Support::roller;
  return name == "free" ? Support::free : from_case;
}

// What one run of the command computes.
struct Run {
  parameters::Case from_file;
  block::Rectangle rectangle;
  block::Discretization discretization;
  elasticity::Load load;
  block::Supports supports;
};

Run run_of(const BlockOptions& options) {
  parameters::Case c = parameters::read_case(options.case_file);
  if (!c.block) throw InputError(options.case_file + ": has no [block]");
  const parameters::HalfSpaceCase& h = c.half_space;
  block::Discretization discretization = c.block->discretization;
  if (const auto order = options.order.integer()) discretization.order = static_cast<int>(*order);
  if (const auto refine = options.refine.integer())
    discretization.refine = static_cast<int>(*refine);
  const block::Rectangle rectangle(options.width.number_or(c.block->rectangle.width()),
                                   options.height.number_or(c.block->rectangle.height()));
  elasticity::Load load = load_of(options.load, h.load.peak_pressure(), h.load.half_width());
  const block::Supports supports = block::with_sides(sides_of(options.sides, c.block->sides));
  return {std::move(c), rectangle, discretization, std::move(load), supports};
}

void write_files(const BlockOptions& options, const Run& run, const block::Analysis& analysis,
                 const block::RefinedSolution& solution) {
  const parameters::HalfSpaceCase& h = run.from_file.half_space;
  if (!options.ccx_file.empty()) {
    std::ostringstream deck;
    block::write_calculix_deck(deck, block::calculix_mesh(analysis.fine()->mesh(), h.points),
                               h.material, run.supports, run.load, h.points);
    literate::write_file_atomically(options.ccx_file, deck.str());
  }
  if (!options.vtu_file.empty()) {
    std::ostringstream vtu;
    block::write_vtu(vtu, solution.fine());
    literate::write_file_atomically(options.vtu_file, vtu.str());
  }
}

using Measures = std::vector<block::MeasureEstimate>;

std::string block_json(const Measures& measures, const block::Analysis& analysis,
                       const block::SupportedBlock& supported, double solution_seconds) {
  nlohmann::ordered_json json;
  for (const block::MeasureEstimate& m : measures) {
    json["measures"][m.name] = {{"value", m.value.value}, {"abs_error", m.value.abs_error}};
  }
  const block::Factorization& fine = supported.fine();
  json["order"] = analysis.fine()->mesh().order();
  json["elements"] = analysis.fine()->mesh().n_elements();
  json["unknowns"] = fine.n_unknowns();
  json["condensed_unknowns"] = fine.n_condensed_unknowns();
  json["seconds"] = {{"elements", analysis.fine()->seconds()},
                     {"assembly", fine.assembly_seconds()},
                     {"factorization", fine.factorization_seconds()},
                     {"solution", solution_seconds}};
  return json_text(json);
}

std::string block_csv(const Measures& measures) {
  std::string text = "measure,value,abs_error\n";
  for (const block::MeasureEstimate& m : measures) {
    text += fmt::format("{},{},{}\n", m.name, m.value.value, m.value.abs_error);
  }
  return text;
}

std::string block_text(const Measures& measures, const block::SupportedBlock& supported) {
  std::string text = fmt::format("{:<24}{:>18}  {:>9}\n", "measure", "value", "error");
  for (const block::MeasureEstimate& m : measures) {
    text += fmt::format("{:<24}{:>18.9e}  {:>9.1e}\n", m.name, m.value.value, m.value.abs_error);
  }
  return text + fmt::format("{} unknowns, {} after condensation\n", supported.fine().n_unknowns(),
                            supported.fine().n_condensed_unknowns());
}

ExitCode run(const BlockOptions& options) {
  const Run run = run_of(options);
  const block::Analysis analysis(run.rectangle, run.from_file.half_space.material, {run.load},
                                 run.discretization);
  const block::SupportedBlock supported = analysis.on(run.supports);
  const auto begin = std::chrono::steady_clock::now();
  const block::RefinedSolution solution = supported.solve(run.load);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  block::MeasureOptions measure_options;
  measure_options.surface_points = run.from_file.half_space.points;
  const Measures measures = solution.measures(measure_options);
  write_files(options, run, analysis, solution);
  switch (options.output.format()) {
    case OutputFormat::csv:
      fmt::print("{}", block_csv(measures));
      break;
    case OutputFormat::json:
      fmt::print("{}", block_json(measures, analysis, supported, seconds.count()));
      break;
    case OutputFormat::table:
      fmt::print("{}", block_text(measures, supported));
      break;
  }
  return ExitCode::success;
}

}  // namespace

void add_block_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "block", "The finite block of Appendix 2 by plane-strain finite elements",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<BlockOptions>(command);
                return [options] { return run(*options); };
              });
}

}  // namespace app
