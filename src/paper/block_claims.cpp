// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "elasticity/stress_beneath.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/prelude.hpp"
#include "paper/printed_data.hpp"

namespace paper {
namespace {

using block::MeasureEstimate;

Estimate named(const std::vector<MeasureEstimate>& measures, const std::string& name) {
  return std::ranges::find(measures, name, &MeasureEstimate::name)->value;
}

void claim_body(Document& document, const HalfSpaceCase& half_space, const BlockCase& block_case,
                const PrintedData& printed_data, const BlockStudy& study) {
  const auto& printed = printed_data.appendix2.measures;
  const double nu = half_space.material.poisson();
  const Estimate in_plane =
      as_estimate(printed.at("max_stress_xx")) + as_estimate(printed.at("max_stress_yy"));
  const Estimate ratio = as_estimate(printed.at("max_stress_zz")) / in_plane;
  document.claim("plane-strain",
                 {.route = "the printed largest stresses: in plane strain the one out of the plane "
                           "is ν times the sum of those in it",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::agrees(
                      "that ratio", Value(ratio, fixed(6)), Value(nu, exact()),
                      {LimitKind::data, 1e-6, "the stresses are printed with seven digits"})}});
  const block::Rectangle& r = block_case.rectangle;
  const Estimate middle = study.under_triangle().displacement_z(0, 0);
  std::vector<Criterion> depths;
  for (const double share : {0.25, 0.5, 0.75}) {
    const Estimate below = study.under_triangle().displacement_z(0, share * r.height());
    depths.push_back(Criterion::at_least(
        "displacement", Value(below / middle, percent(1)),
        {LimitKind::choice, 0.1, "a tenth, which a plot of contours would show"}));
  }
  document.claim("felt-throughout",
                 {.route = "the block by finite elements of high degree under the triangle, on the "
                           "supports assumed",
                  .expected = Verdict::partly,
                  .criteria = {Criterion::in_each(
                      "displacement a quarter, a half and three quarters of the way down, over the "
                      "largest",
                      "depths", depths)}});
}

void claim_mass(Document& document, const BlockCase& block_case, const UnitSystem& units,
                const PrintedData& printed_data) {
  const auto& printed = printed_data.appendix2.mass_properties;
  std::vector<Criterion> properties;
  for (const auto& [name, value] : mass_by_name(block_case)) {
    const PrintedNumber& number = printed.at(name);
    const double apart = std::abs(value - number.value()) / number.last_place();
    properties.push_back(Criterion::at_most(
        "difference", Value({apart, rounded(value) / number.last_place()}, significant(2)),
        {LimitKind::data, 1.0,
         "half a unit for the rounding of the number, and half for that of the printed mass, which "
         "gives the density"}));
  }
  document.value("mass.n", Value(std::ssize(properties), integer()));
  document.value(
      "block.density",
      Value(block_case.density, significant(4), units.density).within(rounded(block_case.density)));
  document.claim("mass-properties",
                 {.route = "closed forms for a plane rectangle of the block's size and mass; at "
                           "most five of the eight numbers are independent",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::in_each("difference in units of the last printed place",
                                                  "properties", properties)}});
}

// A block twice as large in both directions under the same load: the shape, and the level.
void claim_size(Document& document, const HalfSpaceCase& half_space, const BlockCase& block_case,
                const UnitSystem& units, const BlockStudy& study) {
  constexpr double factor = 2;
  const block::RefinedSolution larger =
      study.enlarged(factor, block_case.sides).solve(half_space.load);
  const auto change = [&](double x) {
    return larger.displacement_z(x, 0) - study.under_triangle().displacement_z(x, 0);
  };
  const Estimate middle = study.under_triangle().displacement_z(0, 0);
  const Estimate level = change(0);
  Estimate shape;
  for (const double x : half_space.points) shape = max(shape, abs(change(x) - level));
  const Limit unaffected(LimitKind::choice, 1e-2,
                         "a tenth of the convergence that the run asks for");
  document.value("block.larger.level", Value(level, scientific(3), units.length));
  document.value("block.larger.shape", Value(shape, scientific(1).rounded_up(), units.length));
  document.value("block.larger.share", Value(level / middle, percent(1)));
  document.claim(
      "geometry-large-enough",
      {.route = "the block by finite elements under the triangle, in its size and twice as wide "
                "and high; the change of displacements over the largest one",
       .expected = Verdict::partly,
       .criteria = {
           Criterion::at_most("level: the change at 𝑥 = 0", Value(abs(level) / middle, percent(1)),
                              unaffected),
           Criterion::at_most("shape: how much the change varies over the points",
                              Value(shape / middle, percent(2).rounded_up()), unaffected)}});
}

void claim_comparison(Document& document, const HalfSpaceCase& half_space,
                      const PrintedData& printed_data, const SharesOnBothMeshes& shares) {
  const auto& printed = printed_data.figure5;
  const double a = half_space.load.half_width();
  Estimate whole;  // the largest under the load, over the printed displacement there
  std::size_t middle = 0;
  std::vector<Criterion> growth;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (std::abs(shares.x(i)) < std::abs(shares.x(middle))) middle = i;
    if (shares.x(i) <= a * (1 + 1e-12)) {
      const Estimate share = abs(shares.part(&Share::whole, i)) / as_estimate(printed.fea_z[i]);
      if (share.value > whole.value) whole = share;
    } else {
      const Estimate step = as_estimate(printed.error[i]) - as_estimate(printed.error[i - 1]);
      growth.push_back(Criterion::at_least(
          "step", Value(1 / printed.error[i].last_place() * step, significant(2)),
          {LimitKind::data, 1.0, "an increase that the print shows"}));
    }
  }
  document.claim(
      "nearly-identical-under-load",
      {.route = "under the load eq. (3) less the printed FEA (𝑧), over the latter; outside it the "
                "printed error column",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_most("largest difference under the load",
                                       Value(whole, percent(1).rounded_up()), nearly_identical()),
                    Criterion::in_each("increase of the printed error from point to point outside "
                                       "the load, in units of the last place",
                                       "steps", growth)}});
}

// How far the analytical column is at least, under the load, from the block on these sides under
// the load that the paper states, over the displacement of the block.
Estimate least_apart(const HalfSpaceCase& half_space, const BlockStudy& study,
                     block::Support sides) {
  const block::RefinedSolution solution = study.on(sides).solve(half_space.load);
  const double a = half_space.load.half_width();
  Estimate least{HUGE_VAL, 0};
  for (const double x : half_space.points) {
    if (std::abs(x) > a * (1 + 1e-12)) continue;
    const Estimate sound = solution.displacement_z(x, 0);
    const Estimate apart = abs(displacement(half_space, x) - sound) / sound;
    if (apart.value < least.value) least = apart;
  }
  return least;
}

// By how much more the printed finite-element displacements fall from the middle to the point i
// than the analytical ones do, over the latter; no datum changes this.
Estimate excess_of_fall(const PrintedData& printed_data, std::size_t i) {
  const auto fall = [i](const std::vector<PrintedNumber>& column) {
    return as_estimate(column.front()) - as_estimate(column[i]);
  };
  return fall(printed_data.figure5.fea_z) / fall(printed_data.figure5.analytical) - Estimate{1, 0};
}

// Whether agreement under the load tells of a sound model. The columns fall by different amounts,
// whatever their datums, and sound models of this block, under the load that the paper states and
// on the supports, of those tried, on which a linear pressure meets the displacements of the run,
// do not.
void claim_run(Document& document, const HalfSpaceCase& half_space, const PrintedData& printed_data,
               const BlockStudy& study) {
  const std::vector<double>& points = half_space.points;
  const Estimate falls_apart = excess_of_fall(printed_data, points.size() - 1);
  const double a = half_space.load.half_width();
  const auto end =
      std::ranges::find_if(points, [a](double x) { return std::abs(x - a) < 1e-9 * a; });
  if (end != points.end()) {
    const auto i = static_cast<std::size_t>(end - points.begin());
    document.value("block.fall-apart-under-load",
                   Value(abs(excess_of_fall(printed_data, i)), percent(1)));
  }
  document.value("block.fall-apart", Value(abs(falls_apart), percent(0)));
  std::vector<Criterion> on_supports;
  Estimate smallest{HUGE_VAL, 0};
  for (const block::Support sides : {block::Support::clamped, block::Support::roller}) {
    const Estimate least = least_apart(half_space, study, sides);
    if (least.value < smallest.value) smallest = least;
    on_supports.push_back(
        Criterion::at_most("difference", Value(least, percent(1)), nearly_identical()));
  }
  document.value("block.sound-model-apart", Value(smallest, percent(1)));
  document.claim(
      "robust-model",
      {.route =
           "the inference, not the run, which may have been sound: the fall of the two printed "
           "columns from the first point to the last, which no datum changes; and sound "
           "finite-element models of the block under the load "
           "that the paper states, on the supports on which a linear "
           "pressure meets the run's displacements, a clamped bottom with clamped sides or sides "
           "on rollers; were the agreement an indicator, the analytical column would agree with "
           "them, too",
       .expected = Verdict::refuted,
       .criteria = {Criterion::at_most("difference of the two falls, over that of the "
                                       "analytical column",
                                       Value(abs(falls_apart), percent(1)), nearly_identical()),
                    Criterion::in_each("least difference under the load from the analytical "
                                       "solution, over the displacement of the block",
                                       "supports", on_supports)}});
}

// The largest principal stress of a half-space at points around the ends of the fitted load, on
// small arcs, over its peak.
double largest_tension_beside_ends(const block::LinearFit& fit, double a) {
  const double peak = fit.peak.value();
  const double edge = fit.edge.value();
  double largest = -HUGE_VAL;
  for (const double radius : {1e-3, 1e-2, 1e-1}) {
    for (int i = 1; i < 36; ++i) {
      const double angle = i * std::numbers::pi / 36;
      const double x = a + radius * a * std::cos(angle);
      const double z = radius * a * std::sin(angle);
      const auto stress = elasticity::stress_beneath(std::array{-a, 0.0, a},
                                                     std::array{edge, peak, edge}, x, z);
      largest = std::max(largest, (stress.xx + stress.zz) / 2 + stress.max_shear());
    }
  }
  return largest / peak;
}

// Where the run's maxima are, and whether they have converged.
void claim_maxima(Document& document, const HalfSpaceCase& half_space, const UnitSystem& units,
                  const BlockStudy& study, const PrintedData& printed_data,
                  const std::vector<MeasureEstimate>& fitted) {
  const auto& printed = printed_data.appendix2;
  const double half_width = half_space.load.half_width();
  const block::LinearFit& fit = *study.fit();
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
                          {LimitKind::choice, 1e-9, "the same solution at the same point"}),
       Criterion::at_most("difference in print, in units of the last place",
                          Value(apart, fixed(0)).as_is(),
                          {LimitKind::data, 0.0, "the same digits"})},
      "the largest normal displacement is that of the middle, in print and under the fitted load");
  const PrintedNumber& tension = printed.measures.at("max_stress_prin");
  document.value("appendix2.tension", Value(as_estimate(tension), significant(3), units.stress));
  document.check(
      "tension-only-in-the-block",
      {Criterion::at_most(
          "largest principal stress of a half-space beside the ends of "
          "the fitted load, over its peak",
          Value(largest_tension_beside_ends(fit, half_width), scientific(1)).within(1e-14),
          {LimitKind::choice, 1e-9, "a pressure makes no tension"})},
      "a half-space has no tension beside the ends of the fitted load");
}

}  // namespace

void claim_block(Document& document, const HalfSpaceCase& half_space, const BlockCase& block_case,
                 const UnitSystem& units, const PrintedData& printed_data, const BlockStudy& study,
                 const std::vector<MeasureEstimate>& fitted, const SharesOnBothMeshes& shares) {
  claim_body(document, half_space, block_case, printed_data, study);
  claim_mass(document, block_case, units, printed_data);
  claim_run(document, half_space, printed_data, study);
  claim_maxima(document, half_space, units, study, printed_data, fitted);
  claim_size(document, half_space, block_case, units, study);
  claim_comparison(document, half_space, printed_data, shares);
}

}  // namespace paper
