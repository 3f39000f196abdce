// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "paper/block_claims.hpp"
#include "paper/block_study.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"
#include "paper/printed_data.hpp"

namespace paper {
namespace {

using block::MeasureEstimate;

constexpr int budget_exponent = -7;  // of the unit of the budget of the printed errors

// Names of measures hold underscores, which LaTeX would take for subscripts.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '_' ? std::string("\\_") : std::string(1, c);
  return text;
}

void register_block(Document& document, const HalfSpaceCase& half_space, const BlockCase& b,
                    const UnitSystem& units, const BlockStudy& study) {
  document.value("block.width", Value(b.rectangle.width(), exact(), units.length));
  document.value("block.height", Value(b.rectangle.height(), exact(), units.length));
  document.value("block.order", Value(b.discretization.order, integer()));
  document.value("block.sides", Value::text(name_of(b.sides)));
  document.flag("block.sides-clamped", b.sides == block::Support::clamped);
  const block::Factorization& fine = study.on(b.sides).fine();
  document.value("block.unknowns", Value(fine.n_unknowns(), integer()));
  document.value("block.elements", Value(fine.model()->mesh().n_elements(), integer()));
  double largest_error = 0;
  const double middle = study.under_triangle().displacement_z(0, 0).value;
  for (const double x : half_space.points) {
    const Estimate u_z = study.under_triangle().displacement_z(x, 0);
    largest_error = std::max(largest_error, u_z.abs_error / middle);
  }
  document.value("block.displacement-error",
                 Value(largest_error, scientific(1).rounded_up()).as_is());
  document.check(
      "block-discretisation",
      {Criterion::at_most("largest change, over the displacement in the middle",
                          Value(largest_error, scientific(1).rounded_up()).as_is(),
                          {LimitKind::choice, 2e-4, "far less than what is read from them"})},
      "refinement changes the displacements of the block by little; a higher block.order or "
      "block.refine leaves less");
}

// Where clamped sides meet the free surface stresses are infinite, and beside the ends of a
// pressure that drops in a step polynomials overshoot the stress by an amount that no refinement
// takes away: the largest tension is that of the mesh.
bool has_limit(const MeasureEstimate& measure) {
  return measure.name != "max_stress_prin";
}

// What a printed name means.
Cell description_of(const std::string& name) {
  static const std::map<std::string, const char*> descriptions = {
      {"resultant_load_y", "resultant of the load"},
      {"max_disp_x", "$u_x$, largest in magnitude"},
      {"max_stress_prin", "largest principal stress"},
      {"max_stress_vm", "largest von Mises stress"},
      {"max_stress_xx", "$\\sigma_{xx}$, largest in magnitude"},
      {"max_stress_xy", "$\\sigma_{xy}$, largest in magnitude"},
      {"max_stress_yy", "$\\sigma_{yy}$, largest in magnitude"},
      {"max_stress_zz", "$\\sigma_{zz}$, largest in magnitude"},
      {"strain_energy", "strain energy"}};
  if (const auto found = descriptions.find(name); found != descriptions.end()) {
    return Cell::latex(found->second);
  }
  return Cell::latex("\\code{" + escaped(name) + "}");
}

// A printed measure with four digits, and its unit with the power of ten of a small one.
struct Shortened {
  Cell number;
  Cell unit;
};

Shortened shortened(const PrintedNumber& number, const std::string& unit) {
  constexpr double least_plain = 1e-2;
  constexpr int n_digits = 4;
  const int decade = static_cast<int>(std::floor(std::log10(std::abs(number.value()))));
  const int power = std::abs(number.value()) < least_plain ? decade : 0;
  const int place = decade - power - n_digits + 1;
  const double rounded_number =
      std::round(number.value() * std::pow(10.0, -power - place)) * std::pow(10.0, place);
  return {Cell::quoted(rounded_number, place),
          Cell::latex(power == 0 ? unit : fmt::format("$10^{{{}}}$\\,{}", power, unit))};
}

std::string unit_of(const std::string& measure, const UnitSystem& units) {
  if (measure == "resultant_load_y") return units.line_load;
  if (measure == "strain_energy") return units.force;
  return measure == "max_disp_x" ? units.length : units.stress;
}

// The displacements at the points of the case, measure1, measure2, …, in one row: those that are
// farthest from the printed ones under either load.
void add_displacements(literate::Table& table, const PrintedData& printed_data,
                       const std::vector<MeasureEstimate>& stated,
                       const std::vector<MeasureEstimate>& fitted) {
  Estimate worst_stated, worst_fitted;
  double least_convergence = HUGE_VAL, most_convergence = 0;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    if (!fitted[i].name.starts_with("measure")) continue;
    const PrintedNumber& printed = printed_data.appendix2.measures.at(fitted[i].name);
    const auto worse = [&](Estimate known, const MeasureEstimate& measure) {
      const Estimate off = percent_off(measure.value, printed);
      return std::abs(off.value) > std::abs(known.value) ? off : known;
    };
    worst_stated = worse(worst_stated, stated[i]);
    worst_fitted = worse(worst_fitted, fitted[i]);
    const auto converged = printed_data.appendix2.convergence.find(fitted[i].name);
    if (converged == printed_data.appendix2.convergence.end()) continue;
    least_convergence = std::min(least_convergence, converged->second.value());
    most_convergence = std::max(most_convergence, converged->second.value());
  }
  const auto text = [](double percent) { return Value(percent, fixed(1)).latex(); };
  table.add_row({"displacements at the points", "", "",
                 Cell::latex(text(least_convergence) + "--" + text(most_convergence)), worst_stated,
                 worst_fitted});
}

// Every printed measure beside the computed one, under the stated load and under the inferred one.
void tabulate_measures(Document& document, const UnitSystem& units, const PrintedData& printed_data,
                       const BlockStudy& study, const std::vector<MeasureEstimate>& fitted) {
  const auto& printed = printed_data.appendix2.measures;
  const auto stated = study.under_triangle().measures(study.measure_options());
  const char* const group = "deviation from the printed value";
  literate::Table table("appendix2",
                        {Column::text("measure"), Column("value", fixed(0)).under("printed"),
                         Column::text("unit").under("printed"),
                         Column("convergence (\\%)", fixed(1)).under("printed"),
                         Column("triangle (\\%)", fixed(1)).under(group),
                         Column("inferred load (\\%)", fixed(2)).under(group)});
  long n_beyond = 0;
  Estimate most_beyond;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const std::string& name = fitted[i].name;
    if (name == "measure1") add_displacements(table, printed_data, stated, fitted);
    const auto found = printed.find(name);
    const bool is_repeated = name == "max_disp_mag" || name == "max_disp_y" ||
                             name == "max_prin_mag" || name == "min_stress_prin" ||
                             name.starts_with("measure");
    if (found == printed.end() || found->second.value() == 0 || is_repeated) continue;
    const auto converged = printed_data.appendix2.convergence.find(name);
    const bool is_told = converged != printed_data.appendix2.convergence.end();
    const auto off = [&](Estimate computed) -> Cell {
      if (!has_limit(fitted[i])) return "–";
      return percent_off(computed, found->second);
    };
    const Estimate by = abs(percent_off(fitted[i].value, found->second));
    const bool is_beyond =
        is_told && has_limit(fitted[i]) && by.value - by.abs_error > converged->second.value();
    n_beyond += is_beyond ? 1 : 0;
    if (is_beyond && name != "max_stress_xy" && by.value > most_beyond.value) most_beyond = by;
    const Cell deviation = off(fitted[i].value);
    const Shortened value = shortened(found->second, unit_of(name, units));
    table.add_row({description_of(name), value.number, value.unit,
                   is_told ? quoted(converged->second) : Cell(), off(stated[i].value),
                   is_beyond ? deviation.marked("*") : deviation});
  }
  if (n_beyond > 0)
    table.note("*",
               "More than the printed convergence, even allowing for the error of the deviation.");
  table.note(
      "A dash: this tension depends on the mesh. Four measures that repeat another are left out.");
  document.table(table);
  document.value("fit.n-beyond", Value(n_beyond, integer()));
  document.value("fit.most-beyond", Value(1e-2 * most_beyond, percent(1)));

  const auto value_of = [&](const std::string& name) {
    return std::ranges::find(fitted, name, &MeasureEstimate::name)->value;
  };
  const auto off = [&](const std::string& name) {
    return value_of(name) / as_estimate(printed.at(name)) - 1;
  };
  const std::map<std::string, std::string> predicted = {{"resultant_load_y", "resultant"},
                                                        {"strain_energy", "energy"}};
  for (const auto& [measure, key] : predicted) {
    document.value("fit.predicts." + key, Value(abs(off(measure)), percent(2)));
  }
  // σ_zz = ν(σ_xx + σ_yy) in plane strain; the printed maxima are all taken under the load's
  // middle.
  const Estimate in_plane =
      as_estimate(printed.at("max_stress_xx")) + as_estimate(printed.at("max_stress_yy"));
  document.value("appendix2.poisson",
                 Value(as_estimate(printed.at("max_stress_zz")) / in_plane, fixed(3)));
  // The resultant and the energy are claims.
  const auto predicts = [&](const std::string& name, double limit) {
    return Criterion::at_most(name + ", off by", Value(abs(off(name)), percent(2).rounded_up()),
                              {LimitKind::choice, limit, "what was found, with a margin"});
  };
  document.check("fit-predicts", {predicts("max_disp_x", 6e-3), predicts("max_stress_vm", 1.2e-2)},
                 "the fit predicts the largest tangential displacement and the von Mises stress");
}

// On one of the two meshes.
std::vector<Share> like_with_like(const HalfSpaceCase& h, const BlockStudy& study,
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
    shares.push_back({x, half_space(x) - printed.u_z.value(), datum,
                      half_space(x) - stated(x) - datum, stated(x) - fitted(x),
                      fitted(x) - printed.u_z.value()});
  }
  return shares;
}

// The datum at which the half-space would have the block's displacement in the middle: each factor
// e moves the half-space by 2(1−ν²)P/(πE), and the part of the datum is what the block is below it.
Estimate equivalent_datum(const HalfSpaceCase& h, Estimate part_of_datum) {
  const double per_e = 2 * (1 - h.material.poisson() * h.material.poisson()) * h.load.line_load() /
                       (std::numbers::pi * h.material.young());
  const double datum = h.datum * std::exp(-part_of_datum.value / per_e);
  return {datum, datum * std::expm1(part_of_datum.abs_error / per_e) + rounded(datum)};
}

// The parts at every other point and their sum, beside the difference of the printed columns.
void tabulate_budget(Document& document, const HalfSpaceCase& half_space, const UnitSystem& units,
                     const PrintedData& printed_data, const SharesOnBothMeshes& shares) {
  const auto part = [&](const char* heading) {
    return Column(heading, fixed(2), units.length).scaled(budget_exponent);
  };
  literate::Table table(
      "budget", {Column("$x$", fixed(decimals_of(half_space.points)), units.length).exact(),
                 part("datum"), part("load"), part("datum + load"), part("printed difference")});
  for (std::size_t i = 0; i < shares.size(); i += 2) {
    const Estimate datum = shares.part(&Share::datum, i) + shares.part(&Share::body, i);
    const Estimate load = shares.part(&Share::load, i);
    const Estimate difference = as_estimate(printed_data.figure5.analytical[i]) -
                                as_estimate(printed_data.figure5.fea_z[i]);
    table.add_row({shares.x(i), datum, load, datum + load, difference});
  }
  document.table(table);
}

// The part of the datum depends on how the block is held: in the middle, for each kind of sides.
void register_datum_of_sides(Document& document, const HalfSpaceCase& half_space,
                             const UnitSystem& units, const BlockStudy& study) {
  for (const block::Support sides :
       {block::Support::clamped, block::Support::roller, block::Support::free}) {
    const Estimate middle = study.on(sides).solve(half_space.load).displacement_z(0, 0);
    const Estimate part = displacement(half_space, 0) - middle;
    document.value("shares.datum." + name_of(sides), Value(part, scientific(3), units.length));
    if (sides != block::Support::free) continue;
    document.value("block.equivalent-datum.free",
                   Value(equivalent_datum(half_space, part), significant(2), units.length));
  }
}

void register_shares(Document& document, const HalfSpaceCase& half_space,
                     const BlockCase& block_case, const UnitSystem& units,
                     const SharesOnBothMeshes& shares) {
  double largest_gap = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Share& s = shares.fine()[i];
    largest_gap = std::max(largest_gap, std::abs(s.datum + s.body + s.load + s.rest - s.whole));
  }
  const std::string& unit = units.length;
  const std::size_t last = shares.size() - 1;
  const Estimate datum = shares.part(&Share::datum, 0);
  const Estimate first_load = shares.part(&Share::load, 0);
  const Estimate last_load = shares.part(&Share::load, last);
  const Estimate last_body = shares.part(&Share::body, last);
  document.value("shares.datum", Value(datum, scientific(3), unit));
  document.value("block.equivalent-datum",
                 Value(equivalent_datum(half_space, datum), significant(2), unit));
  document.flag("block.holds-datum", half_space.datum <= block_case.rectangle.right());
  const Estimate first_sum = datum + first_load + shares.part(&Share::body, 0);
  const Estimate last_sum = datum + last_load + last_body;
  document.value("last-point", Value(closed_form(half_space.farthest_point()),
                                     fixed(decimals_of(half_space.points)), unit));
  document.value("shares.first.sum", Value(first_sum, scientific(2), unit));
  document.value("shares.last.sum", Value(last_sum, scientific(3), unit));
  document.value("shares.first.load", Value(abs(first_load), scientific(3), unit));
  document.value("shares.last.load", Value(abs(last_load), scientific(3), unit));
  document.value("shares.last.body", Value(abs(last_body), scientific(2), unit));
  document.check("shares-add-up",
                 {Criterion::at_most(
                     "largest gap, over the part of the datum",
                     Value(largest_gap / std::abs(datum.value), scientific(1).rounded_up()).as_is(),
                     {LimitKind::choice, 1e-12, "the parts are differences of one another"})},
                 "the parts of the difference add up to the whole");
}

}  // namespace

void compute_finite_block(Document& document, const Case& from) {
  if (!from.block) return;
  const HalfSpaceCase& half_space = from.half_space;
  const BlockCase& block_case = *from.block;
  const UnitSystem& units = from.units;
  const std::optional<PrintedData>& printed_data = from.printed_data;
  const BlockStudy study(half_space, block_case,
                         printed_data ? observed_in(half_space, *printed_data)
                                      : std::vector<block::SurfaceDisplacement>{});
  register_block(document, half_space, block_case, units, study);
  register_block_figures(document, half_space, block_case, units, study, printed_data);
  if (!printed_data) return;

  const std::vector<MeasureEstimate> fitted = study.under_fit().measures(study.measure_options());
  tabulate_measures(document, units, *printed_data, study, fitted);
  infer_load(document, half_space, block_case.sides, units, *printed_data, study);
  // The half-space's error is there twice, in differences of points.
  const SharesOnBothMeshes shares(
      like_with_like(half_space, study, &block::RefinedSolution::fine),
      like_with_like(half_space, study, &block::RefinedSolution::coarse),
      2 * displacement(half_space, 0).abs_error);
  register_shares(document, half_space, block_case, units, shares);
  tabulate_budget(document, half_space, units, *printed_data, shares);
  register_datum_of_sides(document, half_space, units, study);
  claim_block(document, half_space, block_case, units, *printed_data, study, fitted, shares);
}

}  // namespace paper
