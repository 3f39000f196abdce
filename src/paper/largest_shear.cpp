// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "block/measures.hpp"
#include "paper/block_claims.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"

namespace paper {
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

}  // namespace paper
