// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "paper/conventions.hpp"
#include "paper/load_fit.hpp"

namespace paper {
namespace {

using Eigen::VectorXd;

const Shape triangle{"triangle", [](double t) { return 1 - t; }};
const Shape uniform{"uniform", [](double) { return 1; }};
const Shape parabola{"parabola", [](double t) { return 1 - t * t; }};
const Shape ellipse{"ellipse", [](double t) { return std::sqrt(1 - t * t); }};
const Shape root{"root", [](double t) { return 1 - std::sqrt(t); }};

// A linear fall from the middle to the end of the strip.
FallingPressure linear_fall(double middle, double end, double half_width) {
  return {triangle.f, middle, end, half_width};
}

Estimate printed_magnitude(const PrintedData& printed, const char* name) {
  return abs(as_estimate(measure(printed, name)));
}

// The numbers of the run that this file needs.
struct Run {
  const Case& from;
  const PrintedData& printed = *from.printed_data;
  const HalfSpaceCase& h = from.half_space;
  const UnitSystem& units = from.units;
  double a = h.load.half_width();
  double resultant = printed_magnitude(printed, "resultant_load_y").value;
  double energy = printed_magnitude(printed, "strain_energy").value;
  double shear = printed_magnitude(printed, "max_stress_xy").value;
};

// A row of the table of loads.
struct Candidate {
  std::string label;  // LaTeX
  FittedLoad load;
  double energy;
  bool is_on_supports_assumed = true;

  bool is_fitted() const { return load.numbers.size() > 0; }
};

// --- The linear fall

// The middle of a linear fall with its standard uncertainty, given the sum of middle and end.
struct HeldFall {
  double middle, standard;
};
HeldFall held_to(const FittedLoad& fall, double sum) {
  // The middle is the sum of both fitted numbers, the end is the first: cov(middle, middle + end).
  const VectorXd of_middle = VectorXd::Ones(2);
  const VectorXd of_sum = of_middle + VectorXd::Unit(2, 0);
  const double with_sum = of_middle.dot(fall.covariance * of_sum);
  const double of_both = of_sum.dot(fall.covariance * of_sum);
  const double excess = of_sum.dot(fall.numbers) - sum;
  const double variance = of_middle.dot(fall.covariance * of_middle);
  return {fall.numbers.sum() - with_sum / of_both * excess,
          std::sqrt(variance - with_sum * with_sum / of_both)};
}

// Tabulates the linear fall fitted to the displacements alone, with the resultant held, with the
// largest vertical stress as a further observation, and with its half-width fitted.
void tabulate_linear_fits(Document& document, const Run& run, const FittedLoad& fall,
                          const FittedLoad& any_width) {
  const auto& [from, printed, h, units, a, resultant, energy, shear] = run;
  const auto column = [&](const char* heading, const std::string& unit) {
    return Column(heading, uncertain(), unit);
  };
  literate::Table table(
      "linear-fits", {Column::text("fitted to"), column("$p_{\\mathrm m}$", units.stress),
                      column("$p_{\\mathrm e}$", units.stress), column("half-width", units.length),
                      column("resultant", units.line_load)});
  const auto end = [](const FittedLoad& f) {
    return number_with(f.numbers[0], std::sqrt(f.covariance(0, 0)));
  };
  const auto resultant_of = [](const FittedLoad& f) {
    // a(p_m + p_e) = a(2 p_u + p_s)
    const double width = f.pressure.half_width();
    VectorXd derivative(f.numbers.size());
    derivative.head(2) << 2 * width, width;
    if (derivative.size() > 2) derivative[2] = 2 * f.numbers[0] + f.numbers[1];
    return number_with(f.pressure.line_load(),
                       std::sqrt(derivative.dot(f.covariance * derivative)));
  };
  const double sum = resultant / a;
  const HeldFall held = held_to(fall, sum);
  // The largest vertical stress, with the run's own stress error as its uncertainty.
  const double stress = printed_magnitude(printed, "max_stress_yy").value;
  const double of_held = 1 / (held.standard * held.standard);
  const double of_stress = std::pow(printed.appendix2.stress_error.rms.value(), -2);
  const double both = (of_held * held.middle + of_stress * stress) / (of_held + of_stress);
  const double of_both = 1 / std::sqrt(of_held + of_stress);
  table.add_row({"the displacements", fall.peak, end(fall), "held", resultant_of(fall)});
  table.add_row({"the same, with the printed resultant", number_with(held.middle, held.standard),
                 number_with(sum - held.middle, held.standard), "held", "held"});
  table.add_row({"the same, with the largest vertical stress, too", number_with(both, of_both),
                 number_with(sum - both, of_both), "held", "held"});
  table.add_row({"the displacements, half-width too", any_width.peak, end(any_width),
                 any_width.half_width, resultant_of(any_width)});
  document.table(table);

  const VectorXd of_sum = VectorXd::Ones(2) + VectorXd::Unit(2, 0);
  document.value("fit.sum", Value(number_with(of_sum.dot(fall.numbers),
                                              std::sqrt(of_sum.dot(fall.covariance * of_sum))),
                                  uncertain(), units.stress));
  const double with_end = fall.covariance.row(0).sum();
  document.value(
      "fit.correlation",
      Value(with_end / (fall.peak.standard * std::sqrt(fall.covariance(0, 0))), fixed(4)).as_is());
  const long n_degrees = fall.residuals.size() - 2;
  document.value("fit.degrees", Value(n_degrees, integer()));
  document.value("fit.chi-squared", Value(fall.chi_squared(), significant(1)).as_is());
  document.value("fit.scaled", Value(fall.peak.standard * std::sqrt(fall.chi_squared() /
                                                                    static_cast<double>(n_degrees)),
                                     significant(1), units.stress)
                                   .as_is());
  document.value("fit.misfit", Value(fall.largest_residual(), percent(2)).as_is());
  document.value("fit.half-width", Value(any_width.half_width, uncertain(), units.length));
  document.value("fit.zero-at", Value(a * fall.peak.value / (fall.peak.value - fall.numbers[0]),
                                      significant(3), units.length)
                                    .as_is());
  document.claim(
      "load-width",
      {.route = "a linear fall with both pressures and the half-width fitted to the printed "
                "displacements",
       .expected = Verdict::holds,
       .criteria = {Criterion::agrees_relatively(
           "half-width", Value(any_width.half_width, uncertain(), units.length),
           Value(a, exact(), units.length),
           Limit(0.05, LimitKind::choice, "a twentieth, which a mistyped width would exceed")
               .counting(2))}});
}

// --- Round numbers

// A linear fall from the stated peak, with the ends that the printed resultant requires.
FallingPressure round_load(const Run& run) {
  const double peak = run.h.load.peak_pressure();
  return linear_fall(peak, run.resultant / run.a - peak, run.a);
}

// Eq. (4) with a larger half-width, cut off at the stated one.
FallingPressure cut_off(const Run& run, double half_width) {
  const double peak = run.h.load.peak_pressure();
  return linear_fall(peak, peak * (1 - run.a / half_width), run.a);
}

void describe_round_load(Document& document, const Run& run, const LoadFitting& fitting) {
  const auto& [from, printed, h, units, a, resultant, energy, shear] = run;
  const FallingPressure load = round_load(run);
  const FittedLoad round = fitting.unfitted(load);
  const double peak = h.load.peak_pressure();
  const double end = resultant / a - peak;
  const double stress = printed_magnitude(printed, "max_stress_yy").value;
  document.value("fit.round-edge", Value(end, significant(3), units.stress).as_is());
  document.value("fit.round-misfit", Value(round.largest_residual(), percent(2)).as_is());
  document.value("fit.round-share", Value(round.largest_share(), significant(2)).as_is());
  document.value("fit.round-energy",
                 Value(std::abs(fitting.energy(load) / energy - 1), percent(2)).as_is());
  document.value("fit.round-stress", Value(1 - stress / peak, percent(2)).as_is());
  document.value(
      "fit.round-off",
      Value((peak - stress) / printed.appendix2.stress_error.rms.value(), significant(2)).as_is());

  const double width = a * peak / (peak - end);
  const double step = 1e-3;  // a unit of the last place of the printed half-width
  const auto share = [&](double w) { return fitting.unfitted(cut_off(run, w)).largest_share(); };
  document.value("fit.cut-half-width", Value(width, significant(2), units.length).as_is());
  document.value("fit.cut-narrower", Value(width - step, significant(2), units.length).as_is());
  document.value("fit.cut-wider", Value(width + step, significant(2), units.length).as_is());
  document.value("fit.cut-share-beside",
                 Value(std::min(share(width - step), share(width + step)), significant(2)).as_is());

  document.claim(
      "round-load-fits",
      {.route = "the block under this load, not fitted, on the assumed supports",
       .expected = Verdict::holds,
       .criteria = {
           Criterion::at_most(
               "largest misfit of a displacement, over its printed convergence",
               Value(round.largest_share(), significant(2)).as_is(),
               Limit(1, LimitKind::data, "the convergence as printed, with one decimal")),
           Criterion::agrees_relatively(
               "strain energy", Value(fitting.energy(load), scientific(4), units.force).as_is(),
               Value(printed_magnitude(printed, "strain_energy"), significant(7), units.force),
               Limit(convergence(printed, "strain_energy"), LimitKind::data,
                     "the convergence of the energy as printed, with one decimal"))}});
}

// --- Other loads

std::vector<Candidate> candidates(const Run& run, const LoadFitting& fitting,
                                  const std::vector<Level>& levels) {
  std::vector<Candidate> rows;
  const auto add = [&](const std::string& label, FittedLoad load) {
    const double energy = fitting.energy(load.pressure);
    rows.push_back({label, std::move(load), energy});
  };
  for (const Shape* shape : {&triangle, &uniform, &parabola, &ellipse}) {
    add(shape->name, fitting.fit(*shape, true, run.a, Width::held));
    add("", fitting.fit(*shape, true, run.a, Width::fitted));
  }
  for (const auto& [name, shape] :
       {std::pair{"linear fall", &triangle}, std::pair{"root", &root}}) {
    add(name, fitting.fit(*shape, false, run.a, Width::held));
    add("", fitting.fit(*shape, false, run.a, Width::fitted));
  }
  const double peak = run.h.load.peak_pressure();
  add("triangle", fitting.unfitted(linear_fall(peak, 0, run.resultant / peak)));
  add("linear fall", fitting.unfitted(round_load(run)));
  const std::pair<const char*, const char*> names[] = {{"roller", "sides on rollers"},
                                                       {"free", "free sides"},
                                                       {"clamped-on-rollers", "bottom on rollers"},
                                                       {"roller-on-rollers", "both on rollers"}};
  for (const auto& [name, label] : names) {
    const auto found = std::ranges::find(levels, name, &Level::supports);
    const LoadFitting on(run.h, run.printed, *found);
    FittedLoad load = on.fit(triangle, false, run.a, Width::held);
    const double energy = on.energy(load.pressure);
    rows.push_back({label, std::move(load), energy, false});
  }
  return rows;
}

void tabulate_loads(Document& document, const Run& run, const std::vector<Candidate>& rows) {
  const char* const misfit = "largest misfit";
  const char* const deviation = "deviation (\\%)";
  literate::Table table(
      "loads",
      {Column::text("load"), Column("half-width", uncertain(), run.units.length),
       Column("peak", uncertain(), run.units.stress), Column("(\\%)", fixed(2)).under(misfit),
       Column("over conv.", fixed(2)).under(misfit), Column("resultant", fixed(2)).under(deviation),
       Column("energy", fixed(2)).under(deviation), Column("shear", fixed(1), run.units.stress)});
  const auto add = [&](const char* label, const auto& is_wanted) {
    table.add_row({Cell::latex(label), Cell(), Cell(), Cell(), Cell(), Cell(), Cell(), Cell()});
    for (const Candidate& row : rows) {
      if (!is_wanted(row)) continue;
      const FittedLoad& load = row.load;
      table.add_row({Cell::latex("\\quad " + row.label), load.half_width,
                     row.is_fitted() ? load.peak : number_with(run.h.load.peak_pressure(), 0),
                     as_it_is(100 * load.largest_residual()), as_it_is(load.largest_share()),
                     Estimate{100 * (load.pressure.line_load() / run.resultant - 1), 1e-9},
                     as_it_is(100 * (row.energy / run.energy - 1)),
                     as_it_is(load.pressure.largest_shear())});
    }
  };
  add("\\emph{fitted}",
      [](const Candidate& row) { return row.is_fitted() && row.is_on_supports_assumed; });
  add("\\emph{not fitted}", [](const Candidate& row) { return !row.is_fitted(); });
  add("\\emph{linear fall on other supports}",
      [](const Candidate& row) { return !row.is_on_supports_assumed; });
  document.table(table);
}

// All loads that match every displacement: of the five shapes, alone or with a non-negative uniform
// pressure, with half-widths in steps of a hundredth of the stated one.
struct MeetingLoads {
  std::vector<FittedLoad> loads;
  double least_width = HUGE_VAL, most_width = 0;
};
MeetingLoads loads_that_meet(const Run& run, const LoadFitting& fitting) {
  MeetingLoads meeting;
  constexpr int least = 80, most = 140;  // hundredths of the stated half-width
  for (const Shape* shape : {&triangle, &uniform, &parabola, &ellipse, &root}) {
    for (const bool alone : {true, false}) {
      if (shape == &uniform && !alone) continue;
      for (int k = least; k <= most; ++k) {
        FittedLoad load = fitting.fit(*shape, alone, run.a * k / 100, Width::held);
        if (!load.meets_all() || load.numbers.minCoeff() < 0) continue;
        meeting.least_width = std::min(meeting.least_width, load.half_width.value);
        meeting.most_width = std::max(meeting.most_width, load.half_width.value);
        meeting.loads.push_back(std::move(load));
      }
    }
  }
  if (meeting.loads.empty()) {  // print the best fit instead
    meeting = {{fitting.fit(triangle, false, run.a, Width::held)}, run.a, run.a};
  }
  return meeting;
}

// The range of loads that the displacements cannot distinguish.
void claim_shape(Document& document, const Run& run, const LoadFitting& fitting,
                 const std::vector<Candidate>& rows) {
  const UnitSystem& units = run.units;
  const MeetingLoads meeting = loads_that_meet(run, fitting);
  double least = HUGE_VAL, most = 0;
  for (const FittedLoad& load : meeting.loads) {
    const double excess = run.shear / load.pressure.largest_shear() - 1;
    least = std::min(least, excess);
    most = std::max(most, excess);
  }
  document.value("loads.least-shear-excess", Value(least, percent(1)).as_is());
  document.value("loads.most-shear-excess", Value(most, percent(1)).as_is());
  document.value("loads.least-half-width",
                 Value(meeting.least_width, significant(2), units.length).as_is());
  document.value("loads.most-half-width",
                 Value(meeting.most_width, significant(3), units.length).as_is());

  std::vector<const Candidate*> met;
  for (const Candidate& row : rows) {
    if (row.is_on_supports_assumed && row.is_fitted() && row.load.meets_all()) {
      met.push_back(&row);
    }
  }
  document.value("loads.n-met", Value(std::ssize(met), integer()));
  const Criterion several = Criterion::at_least(
      "number of fitted loads that match all displacements", Value(std::ssize(met), integer()),
      Limit(2, LimitKind::data, "a single one would mean that the load is known"));
  if (met.empty()) met.push_back(&*std::ranges::find_if(rows, &Candidate::is_fitted));
  const auto [lowest, highest] = std::ranges::minmax_element(
      met, {}, [](const Candidate* row) { return row->load.peak.value; });
  const Number low = (*lowest)->load.peak, high = (*highest)->load.peak;
  const double ratio = high.value / low.value;
  const double standard = ratio * std::hypot(high.standard / high.value, low.standard / low.value);
  document.value("loads.lowest-peak", Value(low, uncertain(), units.stress));
  document.value("loads.highest-peak", Value(high, uncertain(), units.stress));
  document.claim(
      "shape-undecided",
      {.route = "the pressures fitted for each shape, with the half-width held and fitted, on the "
                "assumed supports",
       .expected = Verdict::holds,
       .criteria = {several,
                    Criterion::at_least(
                        "the largest of their peaks over the smallest, minus 1",
                        Value(number_with(ratio - 1, standard), uncertain().in_percent()),
                        Limit(0.05, LimitKind::choice, "ten times the run's own stress error")
                            .counting(2))}});
}

void describe_run_numbers(Document& document, const Run& run, const BlockStudy& study,
                          const LoadFitting& fitting) {
  const auto& [from, printed, h, units, a, resultant, energy, shear] = run;
  const auto [least, most] = std::ranges::minmax(fitting.convergences());
  document.value("fit.least-convergence", Value(least, percent(1)).as_is());
  document.value("fit.most-convergence", Value(most, percent(1)).as_is());
  const PrintedStressError& error = printed.appendix2.stress_error;
  document.value("appendix2.stress-error",
                 Value(as_estimate(error.rms), significant(3), units.stress));
  document.value("appendix2.stress-error-share",
                 Value(as_estimate(error.rms) / as_estimate(error.of_largest), percent(1)));
  document.value("appendix2.largest-pressure",
                 Value(printed_magnitude(printed, "max_stress_yy"), significant(4), units.stress));
  document.value("appendix2.shear",
                 Value(printed_magnitude(printed, "max_stress_xy"), significant(3), units.stress));
  document.value("appendix2.shear-convergence",
                 Value(convergence(printed, "max_stress_xy"), exact().in_percent()));
  Estimate low{HUGE_VAL, 0}, high;
  for (std::size_t i = 0; i < h.points.size(); ++i) {
    const Estimate below = 1 - study.under_triangle().displacement_z(h.points[i], 0) /
                                   as_estimate(printed.figure5.fea_z[i]);
    if (below.value < low.value) low = below;
    if (below.value > high.value) high = below;
  }
  document.value("fit.triangle.least", Value(low, percent(0)));
  document.value("fit.triangle.most", Value(high, percent(0)));
}

// Compares the finite-element displacements under the inferred load with those from the level.
void check_level(Document& document, const Run& run, const BlockStudy& study,
                 const FittedLoad& fall) {
  const block::RefinedSolution solution = study.own().solve(fall.pressure.load());
  double largest = 0;
  for (std::size_t i = 0; i < run.h.points.size(); ++i) {
    const double observed = run.printed.figure5.fea_z[i].value();
    const double by_level = (1 + fall.residuals[static_cast<Eigen::Index>(i)]) * observed;
    largest = std::max(largest,
                       std::abs(solution.displacement_z(run.h.points[i], 0).value / by_level - 1));
  }
  document.value("fit.by-level", Value(largest, scientific(1).rounded_up()).as_is());
  document.check(
      "level-carries-the-load",
      {Criterion::at_most(
          "largest relative difference of a displacement",
          Value(largest, scientific(1).rounded_up()).as_is(),
          Limit(1e-4, LimitKind::choice, "a tenth of the least printed convergence"))},
      "under the inferred load, the finite-element displacements of the block are those of the "
      "half-space minus the level");
}

}  // namespace

FallingPressure infer_load(Document& document, const Case& from, const BlockStudy& study,
                           const std::vector<Level>& levels) {
  const Run run{from};
  const LoadFitting fitting(run.h, run.printed, levels.front());
  describe_run_numbers(document, run, study, fitting);
  const FittedLoad fall = fitting.fit(triangle, false, run.a, Width::held);
  tabulate_linear_fits(document, run, fall, fitting.fit(triangle, false, run.a, Width::fitted));
  check_level(document, run, study, fall);
  describe_round_load(document, run, fitting);

  const std::vector<Candidate> rows = candidates(run, fitting, levels);
  tabulate_loads(document, run, rows);
  claim_shape(document, run, fitting, rows);
  const double wide = run.resultant / run.h.load.peak_pressure();
  document.value("loads.wide-triangle.half-width",
                 Value(wide, significant(2), run.units.length).as_is());
  document.value(
      "loads.wide-triangle.share",
      Value(fitting.unfitted(linear_fall(run.h.load.peak_pressure(), 0, wide)).largest_share(),
            significant(3))
          .as_is());
  document.value(
      "loads.best-triangle.share",
      Value(fitting.fit(triangle, true, run.a, Width::fitted).largest_share(), significant(2))
          .as_is());

  // The greatest misfit of the linear fall with the printed resultant held.
  const auto held_share = [&](const Level& level) {
    const LoadFitting on(run.h, run.printed, level);
    const double sum = run.resultant / run.a;
    const double middle = held_to(on.fit(triangle, false, run.a, Width::held), sum).middle;
    return on.unfitted(linear_fall(middle, sum - middle, run.a)).largest_share();
  };
  document.value("fit.held-share", Value(held_share(levels[0]), significant(2)).as_is());
  document.value("fit.held-share-on-rollers", Value(held_share(levels[1]), significant(2)).as_is());
  return fall.pressure;
}

}  // namespace paper
