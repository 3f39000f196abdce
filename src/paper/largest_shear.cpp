// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "block/factorization.hpp"
#include "block/measures.hpp"
#include "elasticity/load_shapes.hpp"
#include "paper/block_claims.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"

namespace paper {
namespace {

constexpr int low_order = 3;  // of the elements of the coarse mesh
constexpr int high_order = 9;

// As many elements as the run has, for the size of the paper: their sides are 1, 3, 10 and 30
// half-widths from the middle of the load, and as deep. Lines that the block does not reach are
// left out.
block::Mesh coarse_mesh(const block::Mesh& fine, double a, int order) {
  std::vector<double> x{0}, z{0};
  for (const double line : {a, 3 * a, 10 * a, 30 * a}) {
    if (line < fine.x_lines().back()) x.push_back(line);
    if (line < fine.z_lines().back()) z.push_back(line);
    if (-line > fine.x_lines().front()) x.insert(x.begin(), -line);
  }
  x.insert(x.begin(), fine.x_lines().front());
  x.push_back(fine.x_lines().back());
  z.push_back(fine.z_lines().back());
  return {order, x, z};
}

// The magnitude of a measure on the mesh that it was found on. What rounding leaves unbalanced in a
// solution is 1e-10 of the load (block/factorization.cpp); a stress may be wrong by ten times that.
Estimate found_in(const std::vector<block::Measure>& measures, const std::string& name) {
  constexpr double rounding = 1e-9;
  const double value = std::abs(std::ranges::find(measures, name, &block::Measure::name)->value);
  return {value, rounding * value};
}

}  // namespace

void claim_shear(Document& document, const BlockStudy& study, const PrintedData& printed_data,
                 const UnitSystem& units, const std::vector<const Contestant*>& meets) {
  const PrintedAppendix2& printed = printed_data.appendix2;
  const Estimate shear = abs(as_estimate(printed.measures.at("max_stress_xy")));
  const double convergence = printed.convergence.at("max_stress_xy").value() / 100;
  const Limit shown(LimitKind::choice, 3 * convergence,
                    "three times the convergence that is printed: the load is fitted, and the "
                    "grids on which the maxima are taken differ");
  std::vector<Criterion> beyond;
  Estimate least{HUGE_VAL, 0}, most;
  for (const Contestant* c : meets) {
    const auto measures = c->refitted.measures(study.measure_options());
    const auto found = std::ranges::find(measures, "max_stress_xy", &block::MeasureEstimate::name);
    const Estimate excess = shear / abs(found->value) - 1;
    if (excess.value < least.value) least = excess;
    if (excess.value > most.value) most = excess;
    beyond.push_back(Criterion::at_least("excess", Value(excess, percent(1)), shown));
  }
  document.value("appendix2.shear", Value(shear, significant(3), units.stress));
  document.value("appendix2.shear-convergence", Value(convergence, exact().in_percent()));
  document.value("contest.least-shear-excess", Value(least, percent(1)));
  document.value("contest.most-shear-excess", Value(most, percent(1)));
  document.claim(
      "convergence-is-no-bound",
      {.route = "the largest shear stress of the block, which is inside the body, under each load "
                "tried on the supports assumed that meets every displacement to its printed "
                "convergence",
       .expected = Verdict::confirmed,
       .criteria = {
           Criterion::in_each("excess of the printed shear over the block's", "loads", beyond)}});
}

void register_coarse_mesh(Document& document, const HalfSpaceCase& half_space, block::Support sides,
                          const PrintedData& printed_data, const BlockStudy& study,
                          const Contestant& round) {
  const double a = half_space.load.half_width();
  const block::MeasureOptions options = study.measure_options();
  const block::MeasureOptions as_the_run;  // with its plotting grid
  const block::Mesh& mesh = study.on(sides).fine().model()->mesh();
  const auto fine = block::measures(round.refitted.fine(), options);
  const auto coarse = block::measures(round.refitted.coarse(), options);
  const char* const shear = "max_stress_xy";
  const char* const vertical = "max_stress_yy";
  // The vertical stress is largest at the surface, where it is the pressure.
  const auto converged = [&](const std::string& name) {
    if (name == vertical) return closed_form(half_space.load.peak_pressure());
    const double value = found_in(fine, name).value;
    return Estimate{value, std::abs(value - found_in(coarse, name).value)};
  };
  const auto on_few_elements = [&](int order) {
    const auto model =
        std::make_shared<const block::Model>(coarse_mesh(mesh, a, order), half_space.material);
    const block::Solution solution =
        block::Factorization(model, block::with_sides(sides)).solve(round_load(half_space));
    return block::measures(solution, as_the_run);
  };
  const auto excess = [&](const std::vector<block::Measure>& few, const char* name) {
    return found_in(few, name) / converged(name) - 1;
  };
  document.value("coarse.plotting-grid", Value(as_the_run.plotting_grid, integer()));
  document.value("coarse.elements", Value(coarse_mesh(mesh, a, low_order).n_elements(), integer()));
  std::vector<Column> columns{Column::text("largest stress")};
  std::vector<Cell> of_shear{"shear"}, of_vertical{"vertical"};
  std::vector<std::vector<block::Measure>> found;
  Estimate least_change{HUGE_VAL, 0};  // of the vertical stress between two degrees
  for (int order = low_order; order <= high_order; ++order) {
    found.push_back(on_few_elements(order));
    if (order > low_order) {
      // The excess of both over one converged stress: its error enters by the difference alone.
      const Estimate change =
          (found_in(found.back(), vertical) - found_in(*(found.end() - 2), vertical)) /
          converged(vertical);
      if (abs(change).value < least_change.value) least_change = abs(change);
    }
    columns.push_back(Column(std::to_string(order), fixed(1))
                          .under("deviation (\\%) with elements of the degree"));
    of_shear.emplace_back(100 * excess(found.back(), shear));
    of_vertical.emplace_back(100 * excess(found.back(), vertical));
  }
  document.value("coarse.least-change", Value(least_change, percent(1)));
  const auto& low = found.front();
  const auto& high = found.back();
  const auto off_print = [&](const char* name) {
    const Estimate printed = abs(as_estimate(printed_data.appendix2.measures.at(name)));
    return 100 * (printed / converged(name) - 1);
  };
  columns.push_back(Column("run", fixed(1)));
  of_shear.emplace_back(off_print(shear));
  of_vertical.emplace_back(off_print(vertical));
  literate::Table table("coarse-mesh", columns);
  table.add_row(of_shear);
  table.add_row(of_vertical);
  document.table(std::move(table));
  const Estimate printed =
      abs(as_estimate(printed_data.appendix2.measures.at(shear))) / converged(shear) - 1;
  document.check("a-coarse-mesh-has-the-shear-of-the-run",
                 {Criterion::at_least("excess of the run over that of the highest degree",
                                      Value(printed / excess(high, shear), significant(2)),
                                      {LimitKind::data, 1.0, "less would be too little"}),
                  Criterion::at_most("excess of the run over that of the lowest degree",
                                     Value(printed / excess(low, shear), significant(2)),
                                     {LimitKind::data, 1.0, "more would be left to explain"})},
                 "the excess of the printed shear stress lies between those of a coarse mesh");
}

}  // namespace paper
