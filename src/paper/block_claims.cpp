// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_claims.hpp"
#include "paper/bounds.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "paper/quoted.hpp"

namespace paper {
namespace {

using block::MeasureEstimate;
using config::PrintedNumber;
using literate::confirmed_if;
using literate::exact;
using literate::fixed;
using literate::percent;
using literate::scientific;
using literate::significant;
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
                 {.sentence = "The body of the run is in plane strain, with the Poisson's ratio of "
                              "the analytical solution.",
                  .place = "paper, Numerical Solution, p. 6; Appendix 2, p. 13",
                  .stated = Value(nu, exact()),
                  .computed = Value(ratio, fixed(6)),
                  .route = "the printed largest stresses: in plane strain the one out of the plane "
                           "over the sum of those in it is ν",
                  .tolerance = "10⁻⁶: the stresses are printed with seven digits",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(std::abs(ratio.value - nu) < 1e-6)});
  const block::Rectangle& r = block_case.rectangle;
  const Estimate middle = study.under_triangle().displacement_z(0, 0);
  const Estimate half_way = study.under_triangle().displacement_z(0, r.height() / 2);
  document.claim("felt-throughout",
                 {.sentence = "The displacement effects of the load are apparent throughout the "
                              "body.",
                  .place = "paper, Numerical Solution, p. 7",
                  .computed = Value(quotient(half_way, middle), percent(0)),
                  .route = "the block by finite elements of high order: the displacement half way "
                           "down, over the largest",
                  .tolerance = "at least 10 %, one of ten shades of its Fig. 3",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(half_way.value > 0.1 * middle.value)});
}

void claim_mass(literate::Document& document, const parameters::BlockCase& block_case,
                const PrintedData& printed_data) {
  const auto& printed = printed_data.appendix2.mass_properties;
  const auto computed = mass_by_name(block_case);
  const long n = std::ssize(computed);
  const long n_agree = std::ranges::count_if(computed, [&](const auto& property) {
    const PrintedNumber& number = printed.at(property.first);
    return std::abs(property.second - number.value()) <= number.last_place();
  });
  document.claim("mass-properties",
                 {.sentence = "Mass, centre and moments of inertia of the run are those of one "
                              "rectangle.",
                  .place = "paper, Appendix 2, pp. 14–15",
                  .computed = Value::text(fmt::format("{} of {} properties", n_agree, n)),
                  .route = "closed forms for a rectangle of the case's size and density",
                  .tolerance = "one unit of the last printed place, six or seven digits: the "
                               "density has no more",
                  .expected = Verdict::confirmed,
                  .found = literate::confirmed_in(n_agree, n)});
}

// Half-space against block under one and the same load: the shape, and the level.
void claim_size(literate::Document& document, const std::vector<Share>& shares, double middle) {
  double shape = 0;
  for (const Share& s : shares) shape = std::max(shape, std::abs(s.body) / middle);
  const double level = std::abs(shares.front().datum) / middle;
  constexpr double unaffected = 1e-2;
  document.claim(
      "geometry-large-enough",
      {.sentence = "The geometry is sufficiently large compared to the loaded region and does not "
                   "affect the results.",
       .place = "paper, Numerical Solution, p. 7",
       .computed = Value::text(fmt::format("shape by {}, level by {}",
                                           Value(shape, percent(2).rounded_up()).printed(),
                                           Value(level, percent(0)).printed())),
       .route = "eq. (3) less the block by finite elements under the same triangle, over the "
                "largest displacement: how it varies over the points, and at x = 0",
       .tolerance = "1 % for each, a tenth of the convergence that the run asks for",
       .expected = Verdict::partly,
       .found = literate::confirmed_in((shape < unaffected) + (level < unaffected), 2)});
}

void claim_comparison(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                      const PrintedData& printed_data, const std::vector<Share>& shares) {
  const auto& printed = printed_data.figure5;
  const double a = half_space.load.half_width();
  double under = 0;
  double least_part = HUGE_VAL;
  bool grows = true;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Share& s = shares[i];
    if (s.x <= a * (1 + 1e-12)) {
      under = std::max(under, std::abs(s.whole) / printed.fea_z[i].value());
      least_part = std::min({least_part, std::abs(s.datum), std::abs(s.load)});
    } else {
      grows = grows && printed.error[i].value() > printed.error[i - 1].value();
    }
  }
  const double apart = least_part / printed.fea_z.front().value();
  constexpr double nearly = 3e-2;
  const bool by_chance = apart > 5 * nearly;
  const Verdict of_near = by_chance ? Verdict::partly : Verdict::confirmed;
  document.claim(
      "nearly-identical-under-load",
      {.sentence = "The displacements are nearly identical under the loaded region.",
       .place = "paper, Results, p. 8",
       .computed = Value(under, percent(1).rounded_up()),
       .route = "eq. (3) less the printed FEA (z), over the latter; and its parts by the block",
       .tolerance = "3 %, the height of two marks in its Fig. 4; but only by chance if datum and "
                    "load, taken one at a time, each part the columns by more than five times that",
       .expected = Verdict::partly,
       .found = under < nearly ? of_near : Verdict::refuted});

  const Share& last = shares.back();
  const double left = std::abs(last.body + last.rest) / std::abs(last.whole);
  const Verdict of_growth = left < 0.1 ? Verdict::partly : Verdict::confirmed;
  document.claim(
      "error-grows",
      {.sentence = "The error increases as the measure is taken further and further from the "
                   "loaded region.",
       .place = "paper, Results and Error Analysis, p. 8",
       .computed = Value(left, percent(1)),
       .route = "the printed error column outside the load; and what is left of the last error, as "
                "a share of it, when datum and load are alike",
       .tolerance = "the printed errors must grow from point to point; they are no error of the "
                    "method if less than a tenth is left",
       .expected = Verdict::partly,
       .found = grows ? of_growth : Verdict::refuted});
}

// The run's own measures against the block under the fitted load.
void claim_run(literate::Document& document, const config::UnitSystem& units,
               const PrintedData& printed_data, const BlockStudy& study,
               const std::vector<MeasureEstimate>& fitted) {
  const auto& printed = printed_data.appendix2.measures;
  const block::LinearFit& fit = *study.fit();
  const auto off = [&](const std::string& name) {
    return std::abs(named(fitted, name).value / printed.at(name).value() - 1);
  };
  const auto digits = [&](const std::string& name) {
    const PrintedNumber& number = printed.at(name);
    return fmt::format("{} of {} digits agree", number.n_agreeing_digits(named(fitted, name).value),
                       number.n_digits());
  };
  Estimate least{HUGE_VAL, 0};
  for (const block::SurfaceDisplacement& seen : study.observed()) {
    const Estimate computed = study.under_triangle().displacement_z(seen.x, 0);
    const Estimate below = Estimate{1, 0} - quotient(computed, {seen.u_z, 0});
    if (below.value < least.value) least = below;
  }
  document.claim("robust-model",
                 {.sentence = "The correlation is a good indicator that the FEA was performed on a "
                              "robust model.",
                  .place = "paper, Discussion, p. 9",
                  .computed = Value(least, percent(0)),
                  .route = "the block by finite elements under the load that the paper states: how "
                           "far its displacements are below the printed ones, at least",
                  .tolerance = "10 %, to which the run was converged",
                  .expected = Verdict::refuted,
                  .found = confirmed_if(least.value < 0.1)});
  PrintedNumber convergence("0.1");  // percent; the least that the run reports, if it does
  for (const auto& [name, number] : printed_data.appendix2.convergence) {
    if (name.starts_with("measure") && number.value() < convergence.value()) convergence = number;
  }
  const double misfit = convergence.value() / 100;
  document.claim(
      "fit-explains-all",
      {.sentence = "A pressure that falls linearly from its peak to a fraction of it at "
                   "the ends explains every printed displacement.",
       .place = "this report",
       .computed =
           Value(Estimate{fit.fit.max_misfit, study.misfit_error()}, percent(2).rounded_up()),
       .route = "least squares for two numbers on eleven displacements of the block; the "
                "value is the largest misfit",
       .tolerance = fmt::format("{} %, the least convergence that the run reports for any of them",
                                convergence.text()),
       .expected = Verdict::confirmed,
       .found = confirmed_if(fit.fit.max_misfit < misfit)});
  document.claim(
      "resultant",
      {.sentence = "The run reports its resultant load.",
       .place = "paper, Appendix 2, p. 15",
       .stated = quoted_value(printed.at("resultant_load_y"), units.line_load),
       .computed = Value(named(fitted, "resultant_load_y"), significant(4), units.line_load),
       .route = "the load fitted to the printed displacements, which knows nothing of it",
       .tolerance =
           "twice the misfit that is allowed to the displacements; " + digits("resultant_load_y"),
       .expected = Verdict::confirmed,
       .found = confirmed_if(off("resultant_load_y") < 2 * misfit)});
  document.claim(
      "strain-energy",
      {.sentence = "The run reports its strain energy.",
       .place = "paper, Appendix 2, p. 16",
       .stated = quoted_value(printed.at("strain_energy"), units.force),
       .computed = Value(named(fitted, "strain_energy"), scientific(4), units.force),
       .route = "the energy of the block under the fitted load",
       .tolerance = "five times the misfit that is allowed to the displacements: energy is a "
                    "product of two, with a convergence of its own; " +
                    digits("strain_energy"),
       .expected = Verdict::confirmed,
       .found = confirmed_if(off("strain_energy") < 5 * misfit)});
}

// Where the run's maxima are, and whether they have converged.
void claim_maxima(literate::Document& document, const config::UnitSystem& units,
                  const PrintedData& printed_data, const std::vector<MeasureEstimate>& fitted) {
  const auto& printed = printed_data.appendix2;
  const PrintedNumber& maximum = printed.measures.at("max_disp_y");
  const bool is_printed_so = maximum.agrees_with(printed.measures.at("measure1").value());
  const Estimate largest = named(fitted, "max_disp_y");
  const bool is_so = std::abs(largest.value / named(fitted, "measure1").value - 1) < 1e-9;
  document.claim("largest-in-the-middle",
                 {.sentence = "The largest normal displacement is that of the middle, measure1.",
                  .place = "paper, Appendix 2, pp. 15–16",
                  .stated = quoted_value(maximum, units.length),
                  .computed = Value(largest, scientific(4), units.length),
                  .route = "the largest on the plotting grid of the block under the fitted load",
                  .tolerance = "10⁻⁹ of the middle's own, by its plotting grid; the same digits in "
                               "print",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(is_so && is_printed_so)});
  const auto claim = [&](const char* id, const char* what, const std::string& name,
                         Estimate converged, int n_digits, const char* route,
                         literate::Document::Location location) {
    const PrintedNumber& number = printed.measures.at(name);
    const PrintedNumber& convergence = printed.convergence.at(name);
    const double allowed = 3 * convergence.value() / 100;
    document.claim(
        id,
        {.sentence = fmt::format("The {} converged to {} %.", what, convergence.text()),
         .place = "paper, Appendix 2, p. 15",
         .stated = quoted_value(number, units.stress),
         .computed = Value(converged, significant(n_digits), units.stress),
         .route = route,
         .tolerance = "three times the convergence that is printed: the load is fitted, and the "
                      "grids on which the maxima are taken differ",
         .expected = Verdict::refuted,
         .found = confirmed_if(std::abs(number.value() / converged.value - 1) < allowed)},
        location);
  };
  claim("tension-converged", "largest principal stress", "max_stress_prin",
        named(fitted, "max_stress_prin_regular"), 1,
        "the block under the fitted load, off the step of the pressure and the corners, where "
        "stresses have no limit",
        literate::Document::Location::current());
  claim("shear-converged", "largest shear stress", "max_stress_xy", named(fitted, "max_stress_xy"),
        3, "the block under the fitted load, where the largest shear lies inside the body",
        literate::Document::Location::current());
}

}  // namespace

void claim_block(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                 const parameters::BlockCase& block_case, const config::UnitSystem& units,
                 const PrintedData& printed_data, const BlockStudy& study,
                 const std::vector<MeasureEstimate>& fitted, const std::vector<Share>& shares) {
  claim_body(document, half_space, block_case, printed_data, study);
  claim_mass(document, block_case, printed_data);
  claim_run(document, units, printed_data, study, fitted);
  claim_maxima(document, units, printed_data, fitted);
  claim_size(document, shares, study.observed().front().u_z);
  claim_comparison(document, half_space, printed_data, shares);
}

}  // namespace paper
