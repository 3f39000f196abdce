// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_claims.hpp"

#include <algorithm>
#include <cmath>

#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/quoted.hpp"

namespace paper {
namespace {

using block::MeasureEstimate;
using config::PrintedNumber;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::Limit;
using literate::LimitKind;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::uncertain;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;

Estimate named(const std::vector<MeasureEstimate>& measures, const std::string& name) {
  return std::ranges::find(measures, name, &MeasureEstimate::name)->value;
}

void claim_body(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                const parameters::BlockCase& block_case, const PrintedData& printed_data,
                const BlockStudy& study) {
  const auto& printed = printed_data.appendix2.measures;
  const double nu = half_space.material.poisson();
  const Estimate in_plane =
      as_estimate(printed.at("max_stress_xx")) + as_estimate(printed.at("max_stress_yy"));
  const Estimate ratio = quotient(as_estimate(printed.at("max_stress_zz")), in_plane);
  document.claim("plane-strain",
                 {.route = "the printed largest stresses: in plane strain the one out of the plane "
                           "over the sum of those in it is ν",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::agrees(
                      "that ratio", Value(ratio, fixed(6)), Value(nu, exact()).within(0),
                      {LimitKind::printed, 1e-6, "the stresses are printed with seven digits"})}});
  const block::Rectangle& r = block_case.rectangle;
  const Estimate middle = study.under_triangle().displacement_z(0, 0);
  std::vector<Criterion> depths;
  for (const double share : {0.25, 0.5, 0.75}) {
    const Estimate below = study.under_triangle().displacement_z(0, share * r.height());
    depths.push_back(Criterion::at_least(
        "displacement", Value(quotient(below, middle), percent(1)),
        {LimitKind::convention, 0.1, "one of ten shades of the paper's Fig. 3"}));
  }
  document.claim("felt-throughout",
                 {.route = "the block by finite elements of high order",
                  .expected = Verdict::partly,
                  .criteria = {Criterion::in_each(
                      "displacement a quarter, a half and three quarters of the way down, over the "
                      "largest",
                      "depths", depths)}});
}

void claim_mass(literate::Document& document, const parameters::BlockCase& block_case,
                const PrintedData& printed_data) {
  const auto& printed = printed_data.appendix2.mass_properties;
  std::vector<Criterion> properties;
  for (const auto& [name, value] : mass_by_name(block_case)) {
    const PrintedNumber& number = printed.at(name);
    const double apart = std::abs(value - number.value()) / number.last_place();
    properties.push_back(Criterion::at_most(
        "difference", Value({apart, rounded(value) / number.last_place()}, significant(2)),
        {LimitKind::printed, 1.0,
         "the density that they come from has no more digits than they have"}));
  }
  document.claim("mass-properties",
                 {.route = "closed forms for a rectangle of the case's size and density; at most "
                           "five of the eight are independent",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::in_each("difference in units of the last printed place",
                                                  "properties", properties)}});
}

// Half-space against block under one and the same load: the shape, and the level.
void claim_size(literate::Document& document, const SharesOnBothMeshes& shares, Estimate middle) {
  Estimate shape;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Estimate body = magnitude(shares.part(&Share::body, i));
    shape.value = std::max(shape.value, body.value);
    shape.abs_error = std::max(shape.abs_error, body.abs_error);
  }
  const Estimate level = magnitude(shares.part(&Share::datum, 0));
  const Limit unaffected(LimitKind::convention, 1e-2,
                         "a tenth of the convergence that the run asks for");
  document.claim(
      "geometry-large-enough",
      {.route = "eq. (3) less the block by finite elements under the same triangle, over the "
                "block's largest displacement",
       .expected = Verdict::partly,
       .criteria = {
           Criterion::at_most("shape: how much that varies over the points",
                              Value(quotient(shape, middle), percent(2).rounded_up()), unaffected),
           Criterion::at_most("level: at x = 0", Value(quotient(level, middle), percent(0)),
                              unaffected)}});
}

void claim_comparison(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                      const PrintedData& printed_data, const SharesOnBothMeshes& shares) {
  const auto& printed = printed_data.figure5;
  const double a = half_space.load.half_width();
  Estimate whole, datum, load;  // the largest under the load, over the printed displacement there
  std::vector<Criterion> growth;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const auto larger = [&](Estimate known, double Share::*which) {
      const Estimate share =
          quotient(magnitude(shares.part(which, i)), as_estimate(printed.fea_z[i]));
      return share.value > known.value ? share : known;
    };
    if (shares.x(i) <= a * (1 + 1e-12)) {
      whole = larger(whole, &Share::whole);
      datum = larger(datum, &Share::datum);
      load = larger(load, &Share::load);
    } else {
      const Estimate step = as_estimate(printed.error[i]) - as_estimate(printed.error[i - 1]);
      growth.push_back(Criterion::at_least(
          "step", Value(1 / printed.error[i].last_place() * step, significant(2)),
          {LimitKind::printed, 1.0, "an increase that the print shows"}));
    }
  }
  document.claim(
      "nearly-identical-under-load",
      {.route = "eq. (3) less the printed FEA (z), over the latter, at the points under the load",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_most("largest difference", Value(whole, percent(1).rounded_up()),
                                       nearly_identical())}});
  document.claim(
      "error-grows",
      {.route = "the printed error column outside the load",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::in_each("increase from point to point, in units of the last place",
                                       "steps", growth)}});

  const std::size_t last = shares.size() - 1;
  const Estimate left =
      quotient(magnitude(shares.part(&Share::body, last) + shares.part(&Share::rest, last)),
               magnitude(shares.part(&Share::whole, last)));
  const Limit cancelled(LimitKind::convention, 10,
                        "an order of magnitude: what is left is the chance of the case");
  document.claim(
      "datum-and-load-make-the-error",
      {.route = "the difference taken apart by the block, under the triangle and under the fitted "
                "load",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_least("part of the datum over the whole, under the load",
                                        Value(quotient(datum, whole), significant(2)), cancelled),
                    Criterion::at_least("part of the load over the whole, under the load",
                                        Value(quotient(load, whole), significant(2)), cancelled),
                    Criterion::at_most("what is left of the last difference without both",
                                       Value(left, percent(1)), less_than_a_plot_shows())}});
}

// The run's own measures against the block under the fitted load.
void claim_run(literate::Document& document, const config::UnitSystem& units,
               const PrintedData& printed_data, const BlockStudy& study,
               const std::vector<MeasureEstimate>& fitted) {
  const auto& printed = printed_data.appendix2.measures;
  const block::LinearFit& fit = *study.fit();
  Estimate least{HUGE_VAL, 0};
  for (std::size_t i = 0; i < study.observed().size(); ++i) {
    const Estimate computed = study.under_triangle().displacement_z(study.observed()[i].x, 0);
    const Estimate below =
        Estimate{1, 0} - quotient(computed, as_estimate(printed_data.figure5.fea_z[i]));
    if (below.value < least.value) least = below;
  }
  document.claim("robust-model",
                 {.route = "the block by finite elements under the load that the paper states",
                  .expected = Verdict::refuted,
                  .criteria = {Criterion::at_most(
                      "how far its displacements are below the printed ones, at least",
                      Value(least, percent(0)),
                      {LimitKind::convention, 0.1, "the convergence that the run asks for"})}});
  PrintedNumber convergence("0.1");  // percent; the least that the run reports, if it does
  for (const auto& [name, number] : printed_data.appendix2.convergence) {
    if (name.starts_with("measure") && number.value() < convergence.value()) convergence = number;
  }
  const double misfit = convergence.value() / 100;
  document.claim(
      "fit-explains-all",
      {.route = "least squares for two numbers on eleven displacements of the block",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_most(
           "largest misfit",
           Value(Estimate{fit.fit.max_misfit, study.misfit_error()}, percent(2).rounded_up()),
           {LimitKind::printed, misfit,
            "the least convergence that the run reports for any displacement"})}});
  const auto agrees = [&](const char* what, const std::string& name, Value computed,
                          const std::string& unit, double allowed, const char* reason) {
    const PrintedNumber& number = printed.at(name);
    return Criterion::agrees_relatively(what, std::move(computed),
                                        quoted_value(number, unit).within(number.last_place() / 2),
                                        {LimitKind::convention, allowed, reason});
  };
  document.claim(
      "fit-predicts",
      {.route = "resultant and energy of the block under the load that was fitted to the printed "
                "displacements alone",
       .expected = Verdict::confirmed,
       .criteria = {
           agrees("resultant", "resultant_load_y",
                  Value(named(fitted, "resultant_load_y"), significant(4), units.line_load),
                  units.line_load, 2 * misfit,
                  "twice the misfit that is allowed to the displacements"),
           agrees("strain energy", "strain_energy",
                  Value(named(fitted, "strain_energy"), scientific(4), units.force), units.force,
                  5 * misfit,
                  "five times the misfit that is allowed to the displacements: energy is a product "
                  "of two, with a convergence of its own")}});
}

// Where the run's maxima are, and whether they have converged.
void claim_maxima(literate::Document& document, const config::UnitSystem& units,
                  const PrintedData& printed_data, const std::vector<MeasureEstimate>& fitted) {
  const auto& printed = printed_data.appendix2;
  const PrintedNumber& maximum = printed.measures.at("max_disp_y");
  const PrintedNumber& first = printed.measures.at("measure1");
  const double unit = std::min(maximum.last_place(), first.last_place());
  const double apart = std::round(std::abs(maximum.value() - first.value()) / unit);
  const double excess =
      std::abs(named(fitted, "max_disp_y").value / named(fitted, "measure1").value - 1);
  document.check(
      "largest-in-the-middle",
      {Criterion::at_most("relative difference of the largest from that of the middle",
                          Value(Estimate{excess, rounded(1)}, scientific(1).rounded_up()),
                          {LimitKind::rounding, 1e-9, "the same solution at the same point"}),
       Criterion::at_most("difference in print, in units of the last place",
                          Value(apart, fixed(0)).within(0),
                          {LimitKind::printed, 0.0, "the same digits"})},
      "the largest normal displacement is that of the middle, in print and under the fitted load");
  const PrintedNumber& tension = printed.measures.at("max_stress_prin");
  document.claim(
      "tension-converged",
      {.route = "the block under the fitted load, with the points beside the step of the pressure "
                "and in the corners, as the run has them; there stresses have no limit, and what "
                "is found depends on the mesh",
       .expected = Verdict::undecided,
       .criteria = {Criterion::agrees_relatively(
           "largest principal stress",
           Value(named(fitted, "max_stress_prin"), uncertain(), units.stress),
           quoted_value(tension, units.stress).within(tension.last_place() / 2),
           {LimitKind::printed, printed.convergence.at("max_stress_prin").value() / 100,
            "the convergence that is printed, if it is meant to bound the error"})}});
  const PrintedNumber& shear = printed.measures.at("max_stress_xy");
  const Estimate beyond =
      quotient(as_estimate(shear), named(fitted, "max_stress_xy")) - Estimate{1, 0};
  document.claim(
      "convergence-is-no-bound",
      {.route = "the block under the fitted load, where the largest shear lies inside the body and "
                "has a limit",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_least(
           "how far the printed shear is beyond that of the block", Value(beyond, percent(0)),
           {LimitKind::convention, 3 * printed.convergence.at("max_stress_xy").value() / 100,
            "three times the convergence that is printed: the load is fitted, and the grids on "
            "which the maxima are taken differ"})}});
}

}  // namespace

void claim_block(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                 const parameters::BlockCase& block_case, const config::UnitSystem& units,
                 const PrintedData& printed_data, const BlockStudy& study,
                 const std::vector<MeasureEstimate>& fitted, const SharesOnBothMeshes& shares) {
  claim_body(document, half_space, block_case, printed_data, study);
  claim_mass(document, block_case, printed_data);
  claim_run(document, units, printed_data, study, fitted);
  claim_maxima(document, units, printed_data, fitted);
  claim_size(document, shares, study.under_triangle().displacement_z(0, 0));
  claim_comparison(document, half_space, printed_data, shares);
}

}  // namespace paper
