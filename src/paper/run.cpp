// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "block/solution.hpp"
#include "paper/conventions.hpp"
#include "paper/load_fit.hpp"

namespace paper {
namespace {

using block::MeasureEstimate;
using block::RefinedSolution;
using block::Support;

// --- The body

void claim_mass(Document& document, const BlockCase& b, const UnitSystem& units,
                const PrintedData& printed) {
  const block::MassProperties mass = block::mass_properties(b.rectangle, b.density);
  const std::map<std::string, double> by_name = {{"mass", mass.mass},
                                                 {"centre_y", mass.centre_y},
                                                 {"ixx_about_origin", mass.about_origin.ixx},
                                                 {"iyy_about_origin", mass.about_origin.iyy},
                                                 {"izz_about_origin", mass.about_origin.izz},
                                                 {"ixx_about_centre", mass.about_centre.ixx},
                                                 {"iyy_about_centre", mass.about_centre.iyy},
                                                 {"izz_about_centre", mass.about_centre.izz}};
  std::vector<Criterion> properties;
  for (const auto& [name, value] : by_name) {
    const PrintedNumber& number = printed.appendix2.mass_properties.at(name);
    properties.push_back(Criterion::at_most(
        "difference",
        Value(std::abs(value - number.value()) / number.last_place(), significant(2)).as_is(),
        Limit(1, LimitKind::data,
              "half a unit for the rounding of the number, and half for that of the printed mass, "
              "which gives the density")));
  }
  document.value("mass.n", Value(std::ssize(properties), integer()));
  document.value("block.density", Value(b.density, significant(4), units.density).as_is());
  document.claim("mass-properties",
                 {.route = "closed forms for a plane rectangle of the block's size and mass; at "
                           "most five of the eight numbers are independent",
                  .expected = Verdict::holds,
                  .criteria = {Criterion::in_each("difference in units of the last printed place",
                                                  "properties", properties)}});
}

// σ_zz = ν(σ_xx + σ_yy) in plane strain, in the axes of the run.
void claim_plane_strain(Document& document, const HalfSpaceCase& h, const PrintedData& printed) {
  const auto stress = [&](const char* name) { return as_estimate(measure(printed, name)); };
  const Estimate ratio =
      stress("max_stress_zz") / (stress("max_stress_xx") + stress("max_stress_yy"));
  document.value("appendix2.poisson", Value(ratio, fixed(3)));
  document.claim(
      "plane-strain",
      {.route = "the largest printed stresses: in plane strain the one out of the plane "
                "is $\\nu$ times the sum of those in it",
       .expected = Verdict::holds,
       .criteria = {Criterion::agrees(
           "that ratio", Value(ratio, fixed(6)), Value(h.material.poisson(), exact()),
           Limit(1e-6, LimitKind::data, "the stresses are printed with seven digits"))}});
}

// --- The level

// Compares a block twice as large in both directions under the same load, in shape and level.
void claim_size(Document& document, const HalfSpaceCase& h, const UnitSystem& units,
                const BlockStudy& study) {
  const RefinedSolution larger = study.enlarged(2);
  const auto change = [&](double x) {
    return larger.displacement_z(x, 0) - study.under_triangle().displacement_z(x, 0);
  };
  const Estimate middle = study.under_triangle().displacement_z(0, 0);
  const Estimate level = change(0);
  Estimate shape;
  for (const double x : h.points) shape = max(shape, abs(change(x) - level));
  document.value("block.larger.level", Value(level, scientific(3), units.length));
  document.value("block.larger.shape", Value(shape, scientific(1).rounded_up(), units.length));
  document.value("block.larger.share", Value(level / middle, percent(1)));
  const Limit unaffected =
      Limit(1e-2, LimitKind::choice, "a tenth of the convergence set for the run");
  document.claim(
      "geometry-large-enough",
      {.route = "the block by finite elements under the triangle, in its size and twice as wide "
                "and high; the change of displacements over the largest one",
       .expected = Verdict::holds_in_part,
       .criteria = {
           Criterion::at_most("level: the change at $x = 0$",
                              Value(abs(level) / middle, percent(1)), unaffected),
           Criterion::at_most("shape: how much the change varies over the points",
                              Value(shape / middle, percent(2).rounded_up()), unaffected)}});
}

// --- The difference of the printed columns

// The datum's contribution, half-space minus block under the triangle, and the load's, block under
// the triangle minus block under the inferred load.
void register_shares(Document& document, const Case& from, const BlockStudy& study,
                     const RefinedSolution& under_inferred) {
  const HalfSpaceCase& h = from.half_space;
  const PrintedFigure5& printed = from.printed_data->figure5;
  const std::string& unit = from.units.length;
  const auto datum = [&](double x) { return study.level(study.under_triangle(), x).value; };
  const auto load = [&](double x) {
    return (study.under_triangle().displacement_z(x, 0) - under_inferred.displacement_z(x, 0))
        .value;
  };
  const auto sum = [&](double x) { return datum(x) + load(x); };
  const double end = h.farthest_point();
  const auto value = [&](const char* key, double number, int n_digits) {
    document.value(key, Value(number, scientific(n_digits), unit).as_is());
  };
  value("shares.datum", datum(0), 3);
  value("shares.first.load", std::abs(load(0)), 3);
  value("shares.last.load", std::abs(load(end)), 3);
  value("shares.first.sum", sum(0), 2);
  value("shares.last.sum", sum(end), 3);

  const auto part = [&](const char* heading) { return Column(heading, fixed(2), unit).scaled(-7); };
  literate::Table table("budget", {column_of_points(h.points, unit), part("datum"), part("load"),
                                   part("datum + load"), part("printed difference")});
  for (std::size_t i = 0; i < h.points.size(); i += 2) {
    const double x = h.points[i];
    table.add_row({x, as_it_is(datum(x)), as_it_is(load(x)), as_it_is(sum(x)),
                   as_estimate(printed.analytical[i]) - as_estimate(printed.fea_z[i])});
  }
  document.table(table);

  std::vector<double> x, half_space, stated, fitted;
  constexpr int n = 240;
  for (int i = 0; i <= n; ++i) {
    x.push_back(end * i / n);
    half_space.push_back(displacement(h, x.back()).value);
    stated.push_back(study.under_triangle().displacement_z(x.back(), 0).value);
    fitted.push_back(under_inferred.displacement_z(x.back(), 0).value);
  }
  document.figure("like-with-like", {.width_cm = 15.4,
                                     .height_cm = 4.8,
                                     .data = {{"curves",
                                               {{"x", x},
                                                {"half_space", half_space},
                                                {"block_stated", stated},
                                                {"block_fitted", fitted}}},
                                              {"printed",
                                               {{"x", values_of(printed.x)},
                                                {"analytical", values_of(printed.analytical)},
                                                {"u_z", values_of(printed.fea_z)}}}},
                                     .numbers = {{"half_width", h.load.half_width()}},
                                     .texts = {{"unit", unit}}});
}

bool is_under_load(const HalfSpaceCase& h, double x) {
  return std::abs(x) <= h.load.half_width() * (1 + 1e-9);
}

void claim_comparison(Document& document, const HalfSpaceCase& h, const PrintedFigure5& printed) {
  Estimate largest;
  std::vector<Criterion> growth;
  for (std::size_t i = 0; i < h.points.size(); ++i) {
    const double x = h.points[i];
    if (is_under_load(h, x)) {
      const Estimate fea = as_estimate(printed.fea_z[i]);
      largest = max(largest, abs(displacement(h, x) - fea) / fea);
      continue;
    }
    const Estimate step = as_estimate(printed.error[i]) - as_estimate(printed.error[i - 1]);
    growth.push_back(
        Criterion::at_least("step", Value(step / printed.error[i].last_place(), significant(2)),
                            Limit(1, LimitKind::data, "an increase that the print shows")));
  }
  document.claim(
      "nearly-identical-under-load",
      {.route =
           "under the load, eq.~(3) minus the printed FEA $z$, over the latter; outside it, the "
           "printed error column",
       .expected = Verdict::holds,
       .criteria = {Criterion::at_most("largest difference under the load",
                                       Value(largest, percent(1).rounded_up()), nearly_identical()),
                    Criterion::in_each("increase of the printed error from point to point outside "
                                       "the load, in units of its last place",
                                       "steps", growth)}});
}

// The relative excess of the printed finite-element displacements' fall from the first point to the
// i-th over that of the analytical ones. It is independent of the datum.
Estimate excess_of_fall(const PrintedFigure5& printed, std::size_t i) {
  const auto fall = [i](const std::vector<PrintedNumber>& column) {
    return as_estimate(column.front()) - as_estimate(column[i]);
  };
  return fall(printed.fea_z) / fall(printed.analytical) - 1;
}

// The least difference under the load between the analytical solution and a sound model of the
// block under the stated load, relative to the block's displacement.
Estimate least_apart(const HalfSpaceCase& h, const RefinedSolution& sound) {
  Estimate least{HUGE_VAL, 0};
  for (const double x : h.points) {
    if (!is_under_load(h, x)) continue;
    const Estimate u = sound.displacement_z(x, 0);
    const Estimate apart = abs(displacement(h, x) - u) / u;
    if (apart.value < least.value) least = apart;
  }
  return least;
}

// Does agreement under the load show that the model of the run was sound? No: a sound model of the
// same block under the stated load does not agree with the analytical solution.
void claim_run(Document& document, const HalfSpaceCase& h, const PrintedFigure5& printed,
               const RefinedSolution& clamped, const RefinedSolution& roller) {
  const Estimate falls_apart = excess_of_fall(printed, printed.x.size() - 1);
  document.value("block.fall-apart", Value(abs(falls_apart), percent(0)));
  const auto end = std::ranges::find_if(h.points, [&](double x) {
    return std::abs(x - h.load.half_width()) < 1e-9 * h.load.half_width();
  });
  document.value(
      "block.fall-apart-under-load",
      Value(abs(excess_of_fall(printed, static_cast<std::size_t>(end - h.points.begin()))),
            percent(1)));
  std::vector<Criterion> supports;
  Estimate least{HUGE_VAL, 0};
  for (const RefinedSolution* sound : {&clamped, &roller}) {
    const Estimate apart = least_apart(h, *sound);
    if (apart.value < least.value) least = apart;
    supports.push_back(
        Criterion::at_most("difference", Value(apart, percent(1)), nearly_identical()));
  }
  document.value("block.sound-model-apart", Value(least, percent(1)));
  document.claim(
      "robust-model",
      {.route = "the inference, not the run: how far the two printed columns fall from the first "
                "point to the last, whatever the datum; and sound models of the block under the "
                "stated load, with the bottom clamped and the sides clamped or on rollers",
       .expected = Verdict::fails,
       .criteria = {Criterion::at_most("difference of the two falls, over that of the analytical "
                                       "column",
                                       Value(abs(falls_apart), percent(1)), nearly_identical()),
                    Criterion::in_each("least difference under the load from the analytical "
                                       "solution, over the displacement of the block",
                                       "supports", supports)}});
}

// --- The printed measures

// The meaning of a printed name, in the axes of the run.
std::string description_of(const std::string& name) {
  static const std::map<std::string, const char*> descriptions = {
      {"resultant_load_y", "resultant of the load"},
      {"strain_energy", "strain energy"},
      {"max_disp_x", "$u_x$, largest in magnitude"},
      {"max_stress_vm", "largest von Mises stress"},
      {"max_stress_xx", "$\\sigma_{xx}$, largest in magnitude"},
      {"max_stress_xy", "$\\sigma_{xy}$, largest in magnitude"},
      {"max_stress_yy", "$\\sigma_{yy}$, largest in magnitude"},
      {"max_stress_zz", "$\\sigma_{zz}$, largest in magnitude"}};
  return descriptions.at(name);
}

std::string unit_of(const std::string& measure, const UnitSystem& units) {
  if (measure == "resultant_load_y") return units.line_load;
  if (measure == "strain_energy") return units.force;
  return measure == "max_disp_x" ? units.length : units.stress;
}

Estimate named(const std::vector<MeasureEstimate>& measures, const std::string& name) {
  return std::ranges::find(measures, name, &MeasureEstimate::name)->value;
}

void tabulate_measures(Document& document, const Case& from, const BlockStudy& study,
                       const RefinedSolution& under_inferred) {
  const PrintedData& printed = *from.printed_data;
  const auto stated = study.under_triangle().measures();
  const auto inferred = under_inferred.measures();
  const char* const group = "deviation from the printed value";
  literate::Table table("appendix2", {Column::text("measure"), Column::text("printed value"),
                                      Column("convergence (\\%)", fixed(1)).exact(),
                                      Column("triangle (\\%)", fixed(1)).under(group),
                                      Column("inferred load (\\%)", fixed(2)).under(group)});
  for (const char* name : {"resultant_load_y", "strain_energy", "max_disp_x", "max_stress_yy",
                           "max_stress_xx", "max_stress_zz", "max_stress_vm", "max_stress_xy"}) {
    const PrintedNumber number = measure(printed, name);
    const Value value = Value(number.value(), significant(4), unit_of(name, from.units)).as_is();
    const bool converges = printed.appendix2.convergence.contains(name);
    table.add_row({Cell::latex(description_of(name)), Cell::latex(value.latex()),
                   converges ? quoted(printed.appendix2.convergence.at(name)) : Cell(),
                   percent_off(named(stated, name), number),
                   percent_off(named(inferred, name), number)});
  }
  document.table(table);
  const auto off = [&](const char* name) {
    return abs(named(inferred, name) / as_estimate(measure(printed, name)) - 1);
  };
  document.value("fit.predicts.energy", Value(off("strain_energy"), percent(2)));
  document.value("fit.predicts.resultant", Value(off("resultant_load_y"), percent(2)));
}

// The largest tension on the surface beside the load, from one half-width beyond it to 0.9 of the
// distance to the corner.
double tension_beside(const HalfSpaceCase& h, const BlockCase& b, const RefinedSolution& solution) {
  const double begin = 2 * h.load.half_width();
  const double end = 0.9 * b.rectangle.right();
  constexpr int n = 200;
  double largest = -HUGE_VAL;
  for (int i = 0; i <= n; ++i) {
    const double x = begin + (end - begin) * i / n;
    largest = std::max(largest, solution.fine().at(x, 0).stress.xx);
  }
  return largest;
}

// Under normal pressure alone, a half-space has no tension at its surface and this block hardly
// any.
void claim_tension(Document& document, const Case& from, const RefinedSolution& under_inferred) {
  const UnitSystem& units = from.units;
  const PrintedData& printed = *from.printed_data;
  const Estimate tension = as_estimate(measure(printed, "max_stress_prin"));
  const double ours = tension_beside(from.half_space, *from.block, under_inferred);
  const auto& middle = under_inferred.fine().at(0, 0).stress;
  document.value("appendix2.tension", Value(tension, significant(3), units.stress));
  document.value("block.tension", Value(ours, significant(1), units.stress).as_is());
  document.value("appendix2.tension-error", Value(tension - ours, significant(2), units.stress));
  document.value(
      "appendix2.tension-over-stress-error",
      Value((tension - ours) / printed.appendix2.stress_error.rms.value(), significant(2)));
  document.value(
      "fit.stress-gap",
      Value(std::abs(middle.zz) - std::abs(middle.xx), significant(1), units.stress).as_is());
  document.value("appendix2.stress-gap",
                 Value(abs(as_estimate(measure(printed, "max_stress_yy"))) -
                           abs(as_estimate(measure(printed, "max_stress_xx"))),
                       fixed(1), units.stress));
  document.claim(
      "tension-is-error",
      {.route = "the largest tension on the surface of the block beside the inferred load, by "
                "finite elements; a half-space has none under any pressure",
       .expected = Verdict::holds,
       .criteria = {Criterion::at_least(
           "printed tension over ours", Value(tension / ours, significant(2)),
           Limit(2, LimitKind::choice, "half of the printed stress, or more, is then error"))}});
}

}  // namespace

void describe_run(Document& document, const Case& from, const BlockStudy& study) {
  const HalfSpaceCase& h = from.half_space;
  const PrintedData& printed = *from.printed_data;
  claim_mass(document, *from.block, from.units, printed);
  claim_plane_strain(document, h, printed);

  // The assumed supports come first.
  std::vector<Level> levels = {study.level("clamped", study.own())};
  const block::SupportedBlock on_rollers = study.on(block::with_sides(Support::roller));
  levels.push_back(study.level("roller", on_rollers));
  levels.push_back(study.level("free", study.on(block::with_sides(Support::free))));
  for (const Support sides : {Support::clamped, Support::roller}) {
    levels.push_back(
        study.level(name_of(sides) + "-on-rollers",
                    study.on({.left = sides, .right = sides, .bottom = Support::roller})));
  }
  const double load = h.load.line_load();
  for (const Level& level : levels) {
    if (level.supports == "clamped-on-rollers") continue;  // only in the table of loads
    document.value(
        "shares.datum." + level.supports,
        Value(load * level.triangle.in_the_middle, scientific(4), from.units.length).as_is());
  }
  document.value("block.equivalent-datum.free",
                 Value(equivalent_datum(h, {load * levels[2].triangle.in_the_middle, 0}),
                       significant(2), from.units.length));
  claim_size(document, h, from.units, study);
  claim_comparison(document, h, printed.figure5);
  claim_run(document, h, printed.figure5, study.under_triangle(), on_rollers.solve(h.load));

  const FallingPressure inferred = infer_load(document, from, study, levels);
  const RefinedSolution under_inferred = study.own().solve(inferred.load());
  register_shares(document, from, study, under_inferred);
  tabulate_measures(document, from, study, under_inferred);
  claim_tension(document, from, under_inferred);
}

}  // namespace paper
