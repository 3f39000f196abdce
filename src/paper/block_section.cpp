// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "paper/block_study.hpp"
#include "paper/conventions.hpp"
#include "paper/load_fit.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

// The largest discretisation error of the displacements at the points, divided by the displacement
// in the middle.
double discretisation_error(const HalfSpaceCase& h, const block::RefinedSolution& solution) {
  double largest = 0;
  for (const double x : h.points) {
    largest = std::max(largest, solution.displacement_z(x, 0).abs_error);
  }
  return largest / solution.displacement_z(0, 0).value;
}

}  // namespace

Estimate equivalent_datum(const HalfSpaceCase& h, Estimate level) {
  return h.datum * exp(-(level / displacement_scale(h)));
}

void compute_block(Document& document, const Case& from) {
  if (!from.block) return;
  const HalfSpaceCase& h = from.half_space;
  const BlockCase& b = *from.block;
  const std::string& unit = from.units.length;
  const BlockStudy study(h, b);
  document.value("block.width", Value(b.rectangle.width(), exact(), unit));
  document.value("block.height", Value(b.rectangle.height(), exact(), unit));
  document.value("block.order", Value(b.discretization.order, integer()));
  const block::Factorization& fine = study.own().fine();
  document.value("block.unknowns", Value(fine.n_unknowns(), integer()));
  document.value("block.elements", Value(fine.model()->mesh().n_elements(), integer()));
  const double error = discretisation_error(h, study.under_triangle());
  document.value("block.displacement-error", Value(error, scientific(1).rounded_up()).as_is());
  document.check(
      "block-discretisation",
      {Criterion::at_most("largest error over the displacement in the middle",
                          Value(error, scientific(1).rounded_up()).as_is(),
                          Limit(2e-4, LimitKind::choice, "far below the differences discussed"))},
      "the errors of the block's displacements are small; a higher block.order or block.refine "
      "reduces them");

  const Estimate level = study.level(study.under_triangle(), 0);
  const double end = h.farthest_point();
  document.value("block.level-varies-by",
                 Value(abs(study.level(study.under_triangle(), end) - level), scientific(1), unit));
  document.value("block.equivalent-datum", Value(equivalent_datum(h, level), significant(2), unit));
  document.value("block.sides", Value::text(name_of(b.sides)));
  document.value("block.level", Value(level, scientific(4), unit));
  if (from.printed_data) describe_run(document, from, study);
}

}  // namespace paper
