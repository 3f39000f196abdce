// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "block/measures.hpp"
#include "elasticity/load_shapes.hpp"
#include "numerics/least_squares.hpp"
#include "paper/block_claims.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"

namespace paper {
namespace {

constexpr double of_resultant = 1e-12;  // relative, as elasticity::normal_resultant states

// The largest vertical stress of the run with the error that it estimates of its stresses.
Measured largest_stress(const PrintedData& printed_data) {
  const PrintedAppendix2& printed = printed_data.appendix2;
  return {std::abs(printed.measures.at("max_stress_yy").value()), printed.stress_error.rms.value(),
          "stress error"};
}

// How far a peak is from the largest printed stress, in the standard uncertainty of both.
Estimate off_stress(const Measured& peak, const PrintedData& printed_data) {
  const Measured difference = peak - largest_stress(printed_data);
  return 1 / difference.standard() * abs(difference.bounded());
}

// A number of a fitted load's solution, as wrong as the fit on the coarser mesh has it otherwise.
template <typename Number>
Estimate of_refitted(const Contestant& contestant, Number&& number) {
  const double fine = number(contestant.refitted.fine());
  const double coarse = number(contestant.refitted.coarse());
  return {fine, std::abs(fine - coarse) + of_resultant * std::abs(fine)};
}

Estimate energy_of(const Contestant& contestant) {
  return of_refitted(contestant, [](const block::Solution& s) { return s.strain_energy(); });
}

Estimate resultant_of(const Contestant& contestant) {
  return of_refitted(contestant, [](const block::Solution& s) { return -s.applied().force.y(); });
}

// The sum p_m + p_e of a linear fall, of which ∫(p_m (1 − |x|/a) + p_e |x|/a) dx = a (p_m + p_e)
// is the resultant, for the printed resultant.
double printed_sum_of(const PrintedData& printed_data, double a) {
  return std::abs(printed_data.appendix2.measures.at("resultant_load_y").value()) / a;
}

// The fitted peak if the sum p_m + p_e is known to be this one.
Measured peak_given(const block::LinearFit& fit, double sum) {
  return numerics::given(fit.peak, fit.peak + fit.edge, sum);
}

// The largest share of a convergence by which the linear fall with the printed resultant misses a
// displacement, refitted on these sides.
Estimate share_with_resultant(const BlockStudy& study, const PrintedData& printed_data, double a,
                              block::Support sides) {
  const double sum = printed_sum_of(printed_data, a);
  const double peak = peak_given(study.fit_on(sides), sum).value();
  const elasticity::Load load = elasticity::LinearFall(peak, (sum - peak) / peak, a);
  return unfitted(study, "", load, peak, sides).misfit.largest_share;
}

// The linear fall from the displacements alone, with the resultant held, and with the stress too.
void register_fit(Document& document, const HalfSpaceCase& half_space, const UnitSystem& units,
                  const PrintedData& printed_data, const BlockStudy& study) {
  const block::LinearFit& fit = *study.fit();
  const auto pressure = [&](const char* key, const Measured& number) {
    document.value(key, Value(number, uncertain(), units.stress));
  };
  double least_convergence = HUGE_VAL, most_convergence = 0;
  for (const Measured& one : block::relative(study.observed())) {
    least_convergence = std::min(least_convergence, one.standard());
    most_convergence = std::max(most_convergence, one.standard());
  }
  document.value("fit.least-convergence", Value(least_convergence, percent(1)).as_is());
  document.value("fit.most-convergence", Value(most_convergence, percent(1)).as_is());
  // Of the pressures of the load that the report calls inferred.
  document.value("fit.correlation",
                 Value(numerics::correlation(fit.peak, fit.edge), fixed(4)).as_is());
  const double a = half_space.load.half_width();
  const Measured sum = fit.peak + fit.edge;
  pressure("fit.sum", sum);
  const double printed_sum = printed_sum_of(printed_data, a);
  const Measured held = peak_given(fit, printed_sum);
  const auto with_stress =
      numerics::fit_linear(Eigen::MatrixXd::Ones(2, 1), {held, largest_stress(printed_data)});
  const Measured peak_of_all = with_stress.coefficients.front();
  const auto column = [&](const char* heading, const std::string& unit) {
    return Column(heading, uncertain(), unit);
  };
  literate::Table table(
      "linear-fits",
      {Column::text("fitted to"), column("$p_{\\mathrm m}$", units.stress),
       column("$p_{\\mathrm e}$", units.stress), column("resultant", units.line_load)});
  table.add_row({"the displacements", fit.peak, fit.edge, a * sum});
  table.add_row({"the same, with the printed resultant", held, printed_sum - held, "held"});
  table.add_row({"the same, with resultant and largest vertical stress", peak_of_all,
                 printed_sum - peak_of_all, "held"});
  document.table(table);

  Estimate least{HUGE_VAL, 0}, most;
  for (std::size_t i = 0; i < study.observed().size(); ++i) {
    const Estimate computed = study.under_triangle().displacement_z(study.observed()[i].x, 0);
    const Estimate below = 1 - computed / as_estimate(printed_data.figure5.fea_z[i]);
    if (below.value < least.value) least = below;
    if (below.value > most.value) most = below;
  }
  document.value("fit.triangle.least", Value(least, percent(0)));
  document.value("fit.triangle.most", Value(most, percent(0)));
  document.value("fit.misfit",
                 Value(Estimate{fit.fit.max_misfit, study.misfit_error()}, percent(2)));
}

// |σ_zz| − |σ_xx| in the middle of a load. At the surface of a half-space both are the pressure,
// whatever its shape, so that in the block this depends on little but the resultant and the
// supports.
Estimate stress_gap(const block::RefinedSolution& solution) {
  const auto on = [](const block::Solution& of_mesh) {
    const block::Stress stress = of_mesh.at(0, 0).stress;
    return std::abs(stress.zz) - std::abs(stress.xx);
  };
  const double gap = on(solution.fine());
  return {gap, std::abs(gap - on(solution.coarse()))};
}

// How well the fit is fitted, and what its uncertainty would be if the residuals told it.
void register_quality(Document& document, const UnitSystem& units, const PrintedData& printed_data,
                      const BlockStudy& study, const Contestant& linear) {
  const auto n_degrees = static_cast<double>(std::ssize(study.observed()) - 2);
  const Estimate chi_squared = linear.misfit.chi_squared;
  document.value("fit.chi-squared", Value(chi_squared, significant(2)));
  const auto largest = [&](const char* name) {
    return abs(as_estimate(printed_data.appendix2.measures.at(name)));
  };
  document.value("appendix2.stress-gap", Value(largest("max_stress_yy") - largest("max_stress_xx"),
                                               fixed(1), units.stress));
  document.value("fit.stress-gap", Value(stress_gap(linear.refitted), fixed(1), units.stress));
  document.value("fit.degrees", Value(std::ssize(study.observed()) - 2, integer()));
  document.value("fit.scaled",
                 Value(study.fit()->peak.standard() * sqrt(1 / n_degrees * chi_squared),
                       significant(1), units.stress));
}

// What speaks for the load of round numbers, which has nothing fitted, and what against it.
void register_round(Document& document, const UnitSystem& units, const PrintedData& printed_data,
                    const BlockStudy& study, const Contestant& round) {
  const auto& printed = printed_data.appendix2;
  const Measured stress = largest_stress(printed_data);
  const Estimate energy =
      abs(energy_of(round) / as_estimate(printed.measures.at("strain_energy")) - 1);
  document.value("fit.round-edge", Value(closed_form(round_edge_share * round.peak.value()),
                                         significant(3), units.stress));
  document.value("fit.round-resultant",
                 Value(abs(resultant_of(round)), significant(7), units.line_load));
  document.value("fit.round-misfit", Value(round.misfit.largest, percent(2)));
  document.value("fit.round-share", Value(round.misfit.largest_share, significant(2)));
  document.value("fit.round-chi-squared", Value(round.misfit.chi_squared, significant(2)));
  document.value("fit.round-energy", Value(energy, percent(2)));
  document.value("appendix2.largest-pressure",
                 Value(stress.bounded(), significant(4), units.stress));
  document.value("appendix2.stress-error",
                 Value(as_estimate(printed.stress_error.rms), significant(3), units.stress));
  document.value(
      "appendix2.stress-error-share",
      Value(as_estimate(printed.stress_error.rms) / as_estimate(printed.stress_error.of_largest),
            percent(1)));
  document.value("fit.round-stress",
                 Value(1 - 1 / round.peak.value() * stress.bounded(), percent(2)));
  const auto measures = round.refitted.measures(study.measure_options());
  const auto sideways = std::ranges::find(measures, "max_stress_xx", &block::MeasureEstimate::name);
  document.value(
      "fit.round-stress-sideways",
      Value(1 - as_estimate(printed.measures.at("max_stress_xx")) / sideways->value, percent(1)));
  document.value("fit.round-off", Value(off_stress(round.peak, printed_data), significant(2)));

  const Estimate printed_energy = abs(as_estimate(printed.measures.at("strain_energy")));
  document.claim(
      "round-load-fits",
      {.route =
           "the block by finite elements under this load, not fitted, on the supports assumed, "
           "against what the run prints of its displacements and energy",
       .expected = Verdict::confirmed,
       .criteria = {
           Criterion::at_most(
               "largest misfit of a displacement, over its printed convergence",
               Value(round.misfit.largest_share, significant(2)),
               {LimitKind::data, 1.0, "the convergence as it is printed, with one decimal"}),
           Criterion::agrees_relatively(
               "strain energy", Value(energy_of(round), scientific(4), units.force),
               Value(printed_energy, significant(7), units.force),
               {LimitKind::data, printed.convergence.at("strain_energy").value() / 100,
                "the convergence of the energy as it is printed, with one decimal"})}});
}

// A load in few words: on other supports than the case's, these.
std::string label_of(const Contestant& c, const block::Supports& own) {
  if (c.supports == own) return c.shape;
  return name_of(c.supports.left) + " sides, " + name_of(c.supports.bottom) + " bottom";
}

constexpr const char* on_uniform = "uniform + ";
constexpr const char* inferred = "uniform + triangle";

// What is added to the uniform pressure, with t = |x|/a; empty for a load of another kind.
std::string added_shape(const std::string& load) {
  static const std::map<std::string, const char*> formulas = {{"triangle", "$1-t$ (inferred load)"},
                                                              {"narrower triangle", "$1-t/0.9$"},
                                                              {"step", "1 for $t<0.5$"},
                                                              {"parabola", "$1-t^2$"},
                                                              {"root", "$1-t^{1/2}$"}};
  if (!load.starts_with(on_uniform)) return "";
  const std::string shape = load.substr(std::string(on_uniform).size());
  return fmt::format("\\quad {}, {}", shape, formulas.at(shape));
}

void tabulate(Document& document, const PrintedData& printed_data, const UnitSystem& units,
              const std::vector<Contestant>& contestants) {
  const auto& printed = printed_data.appendix2.measures;
  const char* const misfit = "misfit of displacements";
  const char* const height = "peak";
  const char* const deviation = "deviation (\\%)";
  literate::Table table(
      "load-contest",
      {Column::text("load"), Column("largest (\\%)", fixed(2)).under(misfit),
       Column("over conv.", fixed(2)).under(misfit), Column("$\\chi^2$", fixed(1)).under(misfit),
       Column("pressure", uncertain(), units.stress).under(height),
       Column("from $\\sigma_{yy}$", fixed(1)).under(height),
       Column("resultant", fixed(2)).under(deviation),
       Column("energy", fixed(2)).under(deviation)});
  const block::Supports own = contestants.front().supports;
  const auto head_of_rows = [&](const char* head) {
    table.add_row({Cell::latex(head), Cell(), Cell(), Cell(), Cell(), Cell(), Cell(), Cell()});
  };
  bool is_on_uniform = false;
  bool is_of_own = true;
  for (const Contestant& c : contestants) {
    const bool is_peaked = c.n_free == 2 || c.n_free == 0;
    const Cell peak = c.n_free == 0 ? Cell::quoted(c.peak.value(), 0) : Cell(c.peak);
    const std::string added = c.supports == own ? added_shape(c.shape) : "";
    if (!is_on_uniform && !added.empty()) head_of_rows("\\emph{uniform, and besides}");
    if (is_of_own && c.supports != own) head_of_rows("\\emph{linear, on other supports}");
    is_on_uniform = is_on_uniform || !added.empty();
    is_of_own = c.supports == own;
    const Cell label = !added.empty()      ? Cell::latex(added)
                       : c.supports == own ? Cell(c.shape)
                                           : Cell::latex("\\quad " + label_of(c, own));
    table.add_row({label, 100 * c.misfit.largest, c.misfit.largest_share, c.misfit.chi_squared,
                   peak, is_peaked ? Cell(off_stress(c.peak, printed_data)) : Cell("–"),
                   percent_off(resultant_of(c), printed.at("resultant_load_y")),
                   percent_off(energy_of(c), printed.at("strain_energy"))});
  }
  table.note("A dash: not compared; these loads have only one fitted number.");
  document.table(table);
}

// What the displacements leave open, and what the largest stress adds.
void claim_shape(Document& document, const PrintedData& printed_data, const UnitSystem& units,
                 const std::vector<Contestant>& contestants) {
  const block::Supports own = contestants.front().supports;
  std::vector<const Contestant*> meets;
  const Contestant* nearest = nullptr;
  long n_near_stress = 0, n_shapes = 0;
  for (const Contestant& c : contestants) {
    if (c.supports != own || c.n_free != 2) continue;
    ++n_shapes;
    if (off_stress(c.peak, printed_data).value <= 2) ++n_near_stress;
    if (!nearest || c.misfit.largest_share.value < nearest->misfit.largest_share.value)
      nearest = &c;
    if (c.misfit.largest_share.value <= 1) meets.push_back(&c);
  }
  const auto n_met = std::ssize(meets);
  if (meets.empty()) meets.push_back(nearest);  // whose peak is told beside a claim that fails
  const auto [least, most] =
      std::ranges::minmax_element(meets, {}, [](const Contestant* c) { return c->peak.value(); });
  const Measured lowest = (*least)->peak, highest = (*most)->peak;
  document.value("contest.n-shapes", Value(n_shapes, integer()));
  document.value("contest.n-met", Value(n_met, integer()));
  document.value("contest.n-near-stress", Value(n_near_stress, integer()));
  document.value("contest.lowest-peak", Value(lowest, uncertain(), units.stress));
  document.value("contest.highest-peak", Value(highest, uncertain(), units.stress));
  const Limit apart(LimitKind::choice, 0.05, "ten times the run's own stress error");
  document.claim(
      "shape-undecided",
      {.route = "two numbers fitted for each shape, on the supports assumed; the shapes that meet "
                "every displacement to within its printed convergence",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_least("their number", Value(n_met, integer()),
                                        {LimitKind::data, 2,
                                         "a single shape would mean that the load is determined"}),
                    Criterion::at_least("the largest of their peaks over the smallest, less 1",
                                        Value(highest / lowest - 1, uncertain().in_percent()),
                                        apart.counting(2))}});
}

}  // namespace

void infer_load(Document& document, const HalfSpaceCase& half_space, block::Support sides,
                const UnitSystem& units, const PrintedData& printed_data, const BlockStudy& study) {
  register_fit(document, half_space, units, printed_data, study);
  std::vector<Contestant> contestants = contest(study, half_space, sides);
  const double a = half_space.load.half_width();
  const double peak = half_space.load.peak_pressure();
  const Contestant round =
      unfitted(study, "linear, round numbers", round_load(half_space), peak, sides);
  document.value("fit.held-share",
                 Value(share_with_resultant(study, printed_data, a, sides), significant(2)));
  document.value(
      "fit.held-share-on-rollers",
      Value(share_with_resultant(study, printed_data, a, block::Support::roller), significant(2)));
  register_quality(document, units, printed_data, study,
                   *std::ranges::find(contestants, inferred, &Contestant::shape));
  register_round(document, units, printed_data, study, round);
  const auto after_own = std::ranges::find_if(
      contestants, [&](const Contestant& c) { return c.supports != contestants.front().supports; });
  contestants.insert(after_own, round);
  tabulate(document, printed_data, units, contestants);
  claim_shape(document, printed_data, units, contestants);

  constexpr double of_convergence = 1;
  std::vector<const Contestant*> meets;
  for (const Contestant& c : contestants) {
    const bool is_met = c.misfit.largest_share.value <= of_convergence;
    if (is_met && c.supports == round.supports) meets.push_back(&c);
  }
  claim_shear(document, study, printed_data, units, meets);
}

}  // namespace paper
