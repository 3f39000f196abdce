// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "block/load_shapes.hpp"
#include "literate/document/document.hpp"
#include "paper/block_claims.hpp"
#include "paper/block_figures.hpp"
#include "paper/block_study.hpp"
#include "paper/bounds.hpp"
#include "paper/decimals.hpp"
#include "paper/printed_data.hpp"
#include "paper/quoted.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using block::MeasureEstimate;
using config::PrintedNumber;
using literate::Cell;
using literate::Column;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::LimitKind;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::uncertain;
using literate::Value;
using numerics::Estimate;

// Names of measures hold underscores, which LaTeX would take for subscripts.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '_' ? std::string("\\_") : std::string(1, c);
  return text;
}

void register_block(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                    const parameters::BlockCase& b, const config::UnitSystem& units,
                    const BlockStudy& study) {
  document.value("block.width", Value(b.rectangle.width(), exact(), units.length));
  document.value("block.height", Value(b.rectangle.height(), exact(), units.length));
  document.value("block.order", Value(b.discretization.order, integer()));
  document.value("block.sides", Value::text(name_of(b.sides)));
  const block::Factorization& fine = study.on(b.sides).fine();
  document.value("block.unknowns", Value(fine.n_unknowns(), integer()));
  document.value("block.condensed", Value(fine.n_condensed_unknowns(), integer()));
  document.value("block.elements", Value(fine.model()->mesh().n_elements(), integer()));
  double largest_error = 0;
  const double middle = study.under_triangle().displacement_z(0, 0).value;
  for (const double x : half_space.points) {
    const Estimate u_z = study.under_triangle().displacement_z(x, 0);
    largest_error = std::max(largest_error, u_z.abs_error / middle);
  }
  // It is an error bound itself, and has none.
  document.value("block.displacement-error", Value(largest_error, scientific(1).rounded_up()));
  document.check(
      "block-discretisation",
      {Criterion::at_most("largest change, over the displacement in the middle",
                          Value(largest_error, scientific(1).rounded_up()).within(0),
                          {LimitKind::convention, 2e-4, "far less than what is read from them"})},
      "refinement changes the displacements of the block by little; a higher block.order or "
      "block.refine leaves less");
}

// Where the load jumps and in clamped corners the stress is infinite, so that each mesh has another
// greatest one.
bool has_limit(const MeasureEstimate& measure) {
  return measure.name != "max_stress_prin";
}

// The computed measure, and how far it is off the printed one, in per cent.
std::pair<Cell, Cell> computed_cells(const MeasureEstimate& measure, const PrintedNumber& printed) {
  if (!has_limit(measure)) return {"–", "–"};
  return {measure.value, percent_off(measure.value, printed)};
}

// Every printed measure beside the computed one, under the stated load and under the fitted one.
void tabulate_measures(literate::Document& document, const config::UnitSystem& units,
                       const PrintedData& printed_data, const BlockStudy& study,
                       const std::vector<MeasureEstimate>& fitted) {
  const auto& printed = printed_data.appendix2.measures;
  const auto stated = study.under_triangle().measures(study.measure_options());
  literate::Table table("appendix2",
                        {Column::text("measure"), Column("value", scientific(7)).under("printed"),
                         Column("conv., \\%", fixed(1)).under("printed"),
                         Column("value", scientific(4)).under("triangle"),
                         Column("off, \\%", fixed(2)).under("triangle"),
                         Column("value", scientific(4)).under("fitted"),
                         Column("off, \\%", uncertain()).under("fitted")});
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const auto found = printed.find(fitted[i].name);
    if (found == printed.end() || found->second.value() == 0) continue;
    const auto converged = printed_data.appendix2.convergence.find(fitted[i].name);
    const Cell convergence =
        converged == printed_data.appendix2.convergence.end() ? Cell() : quoted(converged->second);
    const auto [stated_value, stated_off] = computed_cells(stated[i], found->second);
    const auto [fitted_value, fitted_off] = computed_cells(fitted[i], found->second);
    table.add_row({Cell::latex("\\code{" + escaped(fitted[i].name) + "}"), quoted(found->second),
                   convergence, stated_value, stated_off, fitted_value, fitted_off});
  }
  table.note(
      "A dash: the stress is infinite where the load jumps and in clamped corners, and no mesh "
      "tells "
      "its maximum.");
  document.table(table);

  const auto value_of = [&](const std::string& name) {
    return std::ranges::find(fitted, name, &MeasureEstimate::name)->value;
  };
  const auto off = [&](const std::string& name) {
    return quotient(value_of(name), as_estimate(printed.at(name))) - Estimate{1, 0};
  };
  const std::map<std::string, std::string> predicted = {{"resultant_load_y", "resultant"},
                                                        {"strain_energy", "energy"},
                                                        {"max_disp_x", "disp-x"},
                                                        {"max_stress_vm", "von-mises"},
                                                        {"max_stress_zz", "stress-zz"}};
  for (const auto& [measure, key] : predicted) {
    document.value("fit.predicts." + key, Value(magnitude(off(measure)), percent(2)));
  }
  document.value("fit.regular-tension",
                 Value(value_of("max_stress_prin_regular"), significant(1), units.stress));
  const Estimate shear =
      quotient(as_estimate(printed.at("max_stress_xy")), value_of("max_stress_xy"));
  document.value("fit.shear-excess", Value(shear - Estimate{1, 0}, percent(0)));
  // σ_zz = ν(σ_xx + σ_yy) in plane strain; the printed maxima are all taken under the load's
  // middle.
  const Estimate in_plane =
      as_estimate(printed.at("max_stress_xx")) + as_estimate(printed.at("max_stress_yy"));
  document.value("appendix2.poisson",
                 Value(quotient(as_estimate(printed.at("max_stress_zz")), in_plane), fixed(3)));
  document.value("appendix2.peak-stress", Value(magnitude(as_estimate(printed.at("max_stress_yy"))),
                                                significant(4), units.stress));
  // The resultant and the energy are claims.
  const auto predicts = [&](const std::string& name, double limit) {
    return Criterion::at_most(name + ", off by",
                              Value(magnitude(off(name)), percent(2).rounded_up()),
                              {LimitKind::regression, limit, "what was found, with a margin"});
  };
  document.check("fit-predicts", {predicts("max_disp_x", 6e-3), predicts("max_stress_vm", 1e-2)},
                 "the fit predicts the largest tangential displacement and the von Mises stress");
}

constexpr double of_resultant = 1e-12;  // relative, as block::normal_resultant states

void register_fit(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                  const config::UnitSystem& units, const PrintedData& printed_data,
                  const BlockStudy& study) {
  const block::LinearFit& fit = *study.fit();
  document.value("fit.peak", Value(fit.peak, significant(4), units.stress));
  document.value("fit.edge-fraction", Value(fit.edge_fraction, fixed(3)));
  // Peak and edge fraction err together: the resultant is taken of the fit on either mesh.
  const double resultant = block::normal_resultant(fit.load);
  const double coarse_resultant = study.under_fit().coarse().applied().force.y();
  document.value("fit.resultant",
                 Value(Estimate{resultant, std::abs(resultant - std::abs(coarse_resultant)) +
                                               of_resultant * resultant},
                       significant(4), units.line_load));
  const double a = half_space.load.half_width();
  constexpr double six_tenths = 0.6;
  const auto round = block::linear_fall(half_space.load.peak_pressure(), six_tenths, a);
  const double round_resultant = block::normal_resultant(round);
  document.value("fit.round-resultant", Value(round_resultant, significant(4), units.line_load)
                                            .within(of_resultant * round_resultant));
  document.value("fit.flat", Value(flat_fraction, exact()));
  Estimate least{HUGE_VAL, 0}, most;
  for (std::size_t i = 0; i < study.observed().size(); ++i) {
    const Estimate computed = study.under_triangle().displacement_z(study.observed()[i].x, 0);
    const Estimate below =
        Estimate{1, 0} - quotient(computed, as_estimate(printed_data.figure5.fea_z[i]));
    if (below.value < least.value) least = below;
    if (below.value > most.value) most = below;
  }
  document.value("fit.triangle.least", Value(least, percent(0)));
  document.value("fit.triangle.most", Value(most, percent(0)));
  document.value("fit.misfit",
                 Value(Estimate{fit.fit.max_misfit, study.misfit_error()}, percent(2)));
}

// A number of a fitted load's solution, as wrong as the fit on the coarser mesh has it otherwise.
template <typename Number>
Estimate of_refitted(const Candidate& candidate, Number&& number) {
  const double fine = number(candidate.refitted.fine());
  const double coarse = number(candidate.refitted.coarse());
  return {fine, std::abs(fine - coarse) + of_resultant * std::abs(fine)};
}

void tabulate_candidates(literate::Document& document, const PrintedData& printed_data,
                         const BlockStudy& study) {
  const auto& printed = printed_data.appendix2.measures;
  literate::Table table("fit-candidates",
                        {Column::text("load"), Column::text("sides"),
                         Column("largest, \\%", fixed(2)).under("misfit"),
                         Column("rms, \\%", fixed(2)).under("misfit"),
                         Column("resultant, \\%", fixed(2)).under("off the printed"),
                         Column("energy, \\%", fixed(2)).under("off the printed")});
  Estimate best_other{HUGE_VAL, 0};
  for (const Candidate& candidate : study.candidates()) {
    const Estimate force =
        of_refitted(candidate, [](const block::Solution& s) { return -s.applied().force.y(); });
    const Estimate energy =
        of_refitted(candidate, [](const block::Solution& s) { return s.strain_energy(); });
    table.add_row({candidate.shape, name_of(candidate.sides),
                   100 * Estimate{candidate.fit.max_misfit, candidate.misfit_error},
                   100 * Estimate{candidate.fit.rms_misfit, candidate.misfit_error},
                   percent_off(force, printed.at("resultant_load_y")),
                   percent_off(energy, printed.at("strain_energy"))});
    const Estimate misfit{candidate.fit.max_misfit, candidate.misfit_error};
    if (candidate.shape == "linear fall") {
      document.value("fit." + name_of(candidate.sides) + "-misfit", Value(misfit, percent(2)));
    } else if (misfit.value < best_other.value) {
      best_other = misfit;
    }
  }
  document.table(table);
  document.value("fit.best-other", Value(best_other, percent(1)));
  const Estimate own{study.fit()->fit.max_misfit, study.misfit_error()};
  document.check("fit-stands-out",
                 {Criterion::at_least("least misfit of another shape over that of the linear fall",
                                      Value(quotient(best_other, own), significant(2)),
                                      {LimitKind::convention, 10.0, "an order of magnitude"})},
                 "every other shape that was tried misses the printed displacements by far more");
}

// On one of the two meshes.
std::vector<Share> like_with_like(const parameters::HalfSpaceCase& h, const BlockStudy& study,
                                  const block::Solution& (block::RefinedSolution::*mesh)() const) {
  const auto half_space = [&](double x) {
    return normal_displacement(h.material, h.load, x, h.datum);
  };
  const auto stated = [&](double x) {
    return (study.under_triangle().*mesh)().displacement(x, 0).y();
  };
  const auto fitted = [&](double x) { return (study.under_fit().*mesh)().displacement(x, 0).y(); };
  const double datum = half_space(0) - stated(0);  // a shift of the whole curve
  std::vector<Share> shares;
  for (const block::SurfaceDisplacement& printed : study.observed()) {
    const double x = printed.x;
    shares.push_back({x, half_space(x) - printed.u_z, datum, half_space(x) - stated(x) - datum,
                      stated(x) - fitted(x), fitted(x) - printed.u_z});
  }
  return shares;
}

void tabulate_shares(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                     const config::UnitSystem& units, const std::vector<PrintedNumber>& printed,
                     const SharesOnBothMeshes& shares) {
  const auto column = [&](const char* heading) {
    return Column(heading, fixed(3), units.length).scaled(-8);
  };
  literate::Table table(
      "like-with-like",
      {Column("$x$", fixed(decimals_of(half_space.points)), units.length).exact(), column("whole"),
       column("datum"), column("finite body"), column("load"), column("rest")});
  double largest_gap = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Share& s = shares.fine()[i];
    // The printed displacement is in the whole and in the rest.
    const Estimate print{0, as_estimate(printed[i]).abs_error};
    table.add_row({s.x, shares.part(&Share::whole, i) + print, shares.part(&Share::datum, i),
                   shares.part(&Share::body, i), shares.part(&Share::load, i),
                   shares.part(&Share::rest, i) + print});
    largest_gap = std::max(largest_gap, std::abs(s.datum + s.body + s.load + s.rest - s.whole));
  }
  document.table(table);
  const std::string& unit = units.length;
  const std::size_t last = shares.size() - 1;
  const Estimate datum = shares.part(&Share::datum, 0);
  const Estimate first_load = shares.part(&Share::load, 0);
  const Estimate last_load = shares.part(&Share::load, last);
  const Estimate last_body = shares.part(&Share::body, last);
  document.value("shares.datum", Value(datum, scientific(3), unit));
  document.value("shares.first.load", Value(magnitude(first_load), scientific(3), unit));
  document.value("shares.last.load", Value(magnitude(last_load), scientific(3), unit));
  document.value("shares.last.body", Value(magnitude(last_body), scientific(2).rounded_up(), unit));
  document.check(
      "shares-add-up",
      {Criterion::at_most(
          "largest gap, over the part of the datum",
          Value(largest_gap / std::abs(datum.value), scientific(1).rounded_up()).within(0),
          {LimitKind::rounding, 1e-12, "the parts are differences of one another"})},
      "the parts of the difference add up to the whole");
}

void tabulate_mass(literate::Document& document, const parameters::BlockCase& block_case,
                   const PrintedData& printed_data) {
  const auto& printed = printed_data.appendix2.mass_properties;
  literate::Table table(
      "mass-properties",
      {Column::text("property"), Column("printed", scientific(7)),
       Column("computed", scientific(7)), Column("digits that agree", integer())});
  for (const auto& [name, value] : mass_by_name(block_case)) {
    const PrintedNumber& number = printed.at(name);
    table.add_row({Cell::latex("\\code{" + escaped(name) + "}"), quoted(number), closed_form(value),
                   number.n_agreeing_digits(value)});
  }
  document.table(table);
}

}  // namespace

void compute_finite_block(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                          const parameters::BlockCase& block_case, const config::UnitSystem& units,
                          const std::optional<PrintedData>& printed_data) {
  const BlockStudy study(half_space, block_case,
                         printed_data ? observed_in(half_space, printed_data->figure5)
                                      : std::vector<block::SurfaceDisplacement>{});
  register_block(document, half_space, block_case, units, study);
  register_block_figures(document, half_space, block_case, units, study);
  if (!printed_data) return;

  register_fit(document, half_space, units, *printed_data, study);
  const std::vector<MeasureEstimate> fitted = study.under_fit().measures(study.measure_options());
  tabulate_measures(document, units, *printed_data, study, fitted);
  tabulate_candidates(document, *printed_data, study);
  // The half-space's error is there twice, in differences of points.
  const SharesOnBothMeshes shares(
      like_with_like(half_space, study, &block::RefinedSolution::fine),
      like_with_like(half_space, study, &block::RefinedSolution::coarse),
      2 * displacement(half_space, 0).abs_error);
  tabulate_shares(document, half_space, units, printed_data->figure5.fea_z, shares);
  tabulate_mass(document, block_case, *printed_data);
  claim_block(document, half_space, block_case, units, *printed_data, study, fitted, shares);
}

}  // namespace paper
