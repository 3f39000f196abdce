// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "contact/hertz.hpp"
#include "contact/matrix_inversion.hpp"
#include "literate/document/document.hpp"
#include "paper/bounds.hpp"
#include "paper/contact_m.hpp"
#include "paper/printed_data.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using contact::Hertz;
using literate::Column;
using literate::confirmed_if;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::scientific;
using literate::significant;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;

// The program with the defects mended up to one of them.
struct Row {
  std::string mended;
  ContactM program;
  double misfit;  // ∫|p − Hertz| over x ≥ 0, over P/2
};

// ∫|p − Hertz| dx over x ≥ 0 by the trapezoidal rule, over P/2.
double misfit(const ContactM& program, const Hertz& hertz, double line_load) {
  const double c = program.x[1];
  double sum = 0;
  for (std::size_t i = 0; i < program.x.size(); ++i) {
    const double difference = std::abs(program.pressure[i] - hertz.pressure(program.x[i]));
    sum += i == 0 ? difference / 2 : difference;
  }
  return 2 * c * sum / line_load;
}

// As printed; each repair with those before it; and the last on a grid four times as fine.
std::vector<Row> repair(const parameters::ContactCase& contact, ContactMInput input,
                        const Hertz& hertz) {
  std::vector<Row> rows;
  ContactMRepairs mended;
  const auto add = [&](const char* name) {
    ContactM program = run_contact_m(contact, input, mended);
    const double error = misfit(program, hertz, contact.line_load);
    rows.push_back({name, std::move(program), error});
  };
  add("as printed");
  const std::pair<const char*, bool ContactMRepairs::*> repairs[] = {
      {"limits at $0$ and $\\pm c$", &ContactMRepairs::limits},
      {"mirror images", &ContactMRepairs::mirror_images},
      {"both bodies", &ContactMRepairs::both_bodies},
      {"weight of equilibrium", &ContactMRepairs::weight_of_equilibrium},
      {"free edge", &ContactMRepairs::free_edge},
      {"load of Hertz", &ContactMRepairs::hertz_load}};
  for (const auto& [name, defect] : repairs) {
    mended.*defect = true;
    add(name);
  }
  input.n_nodes *= 4;
  input.spacing /= 4;
  add("a quarter of $c$");
  return rows;
}

// The rows by name.
enum : std::size_t { printed, limits, mirror_images, both_bodies, weight, free_edge, all, finer };

double peak(const ContactM& program) {
  return *std::ranges::max_element(program.pressure);
}

// Where the pressure becomes zero.
double edge(const ContactM& program) {
  return program.x[static_cast<std::size_t>(program.zero_node - 1)];
}

double pressure_beside_edge(const ContactM& program) {
  return program.pressure[static_cast<std::size_t>(program.zero_node - 2)];
}

// Its system of equations is as well conditioned as that of the report's own solver, with which it
// agrees to this part of the peak when it is mended: the check contact-m-is-matrix-inversion.
constexpr double of_system = 1e-10;

literate::Table repair_table(const std::vector<Row>& rows, const parameters::ContactCase& c,
                             const Hertz& hertz) {
  literate::Table table(
      "contact-m-repair",
      {Column("", integer()), Column::text("mended besides"), Column("load over $P$", fixed(3)),
       Column("edge over $a$", fixed(2)), Column("$p_0$", fixed(4)).under("peak over"),
       Column("its own $p_0$", fixed(4)).under("peak over"), Column("misfit", fixed(4))});
  // Loads and pressures are as wrong as the solved system, a misfit as twice its largest pressure.
  const double error = of_system + rounded(c, 1);
  const auto solved = [&](double x) { return Estimate{x, error * std::abs(x)}; };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ContactM& program = rows[i].program;
    const double share = edge(program) / hertz.half_width();
    table.add_row(
        {i, literate::Cell::latex(rows[i].mended), solved(program.line_load / c.line_load),
         Estimate{share, rounded(c, share)}, solved(peak(program) / hertz.peak_pressure()),
         solved(peak(program) / program.hertz_peak_pressure),
         Estimate{rows[i].misfit, 2 * share * error * peak(program) / hertz.peak_pressure()}});
  }
  return table;
}

// One panel for each row whose pressure or whose Hertz differs from the last.
literate::Figure repair_figure(const std::vector<Row>& rows, const Hertz& hertz) {
  literate::Figure figure{.width_cm = 15.2, .height_cm = 9.6};
  int number = 0;
  for (const std::size_t i : {printed, mirror_images, both_bodies, weight, free_edge, all}) {
    const ContactM& program = rows[i].program;
    std::vector<double> node_x, node_pressure;
    const auto add = [&](double x, double pressure) {
      node_x.push_back(x / hertz.half_width());
      node_pressure.push_back(pressure / hertz.peak_pressure());
    };
    const auto n = static_cast<std::size_t>(program.zero_node);
    for (std::size_t k = program.has_mirror_images ? n - 1 : 1; k > 0; --k) {
      add(-program.x[k], program.has_mirror_images ? program.pressure[k] : 0);
    }
    for (std::size_t k = 0; k < n; ++k) add(program.x[k], program.pressure[k]);
    const std::string panel = std::to_string(++number);
    figure.data["panel_" + panel] = {{"x", node_x}, {"pressure", node_pressure}};
    figure.texts["title_" + panel] = std::to_string(i) + "\\enspace " + rows[i].mended;
    figure.numbers["half_width_" + panel] = program.hertz_half_width / hertz.half_width();
    figure.numbers["p0_" + panel] = program.hertz_peak_pressure / hertz.peak_pressure();
  }
  figure.numbers["n_panels"] = number;

  // p/p₀ = √(1 − x²/a²), even in the angle, so that the steep ends have points enough.
  std::vector<double> hertz_x, hertz_pressure;
  constexpr int n = 200;
  for (int i = 0; i <= n; ++i) {
    const double angle = std::numbers::pi * i / n;
    hertz_x.push_back(-std::cos(angle));
    hertz_pressure.push_back(std::sin(angle));
  }
  figure.data["hertz"] = {{"x", hertz_x}, {"pressure", hertz_pressure}};
  return figure;
}

// The greatest difference between two pressures at the same nodes.
double largest_difference(std::span<const double> p, std::span<const double> other) {
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    largest = std::max(largest, std::abs(p[i] - other[i]));
  }
  return largest;
}

// What the listing says, and what it computes as it stands.
void describe_listing(literate::Document& document, const parameters::ContactCase& c,
                      const config::UnitSystem& units, const ContactMInput& input,
                      const ContactM& program, const Hertz& hertz) {
  const double load = c.line_load;
  const auto weight = static_cast<double>(input.zero_node - 2);
  document.value("contact-m.spacing", Value(input.spacing, exact(), units.length));
  document.value("contact-m.step", Value(input.step, exact(), units.length));
  document.value("contact-m.nodes", Value(input.n_nodes + 1, integer()));
  document.value("contact-m.zero-node", Value(input.zero_node, integer()));
  document.value("contact-m.weight", Value(weight, exact()));
  const double share = edge(program) / hertz.half_width();
  const Estimate carried{program.line_load, of_system * program.line_load};
  const double spike = program.pressure[0] / program.pressure[1];
  document.value("contact-m.edge", Value(closed_form(edge(program)), significant(2), units.length));
  document.value("contact-m.edge-share", Value(share, fixed(2)).within(rounded(c, share)));
  document.value("contact-m.load", Value(carried, significant(4), units.line_load));
  document.value("contact-m.load-share", Value(quotient({load, 0}, carried), fixed(2)));
  document.value("contact-m.hertz-half-width",
                 Value(program.hertz_half_width, significant(4), units.length)
                     .within(rounded(c, program.hertz_half_width)));
  document.value("contact-m.hertz-peak",
                 Value(program.hertz_peak_pressure, significant(4), units.stress)
                     .within(rounded(c, program.hertz_peak_pressure)));
  document.value("contact-m.spike", Value(spike, fixed(2)).within(2 * of_system * spike));
  document.check("contact-m-load", std::abs(program.line_load * weight / load - 1) < 1e-9,
                 "Contact.m as printed carries P/(aa - 2)");
}

// Where p >= 0 puts the edge: in the program as printed, mended, and under the load of its Hertz.
void find_edges(literate::Document& document, const parameters::ContactCase& contact,
                const ContactMInput& input, const ContactM& mended) {
  const ContactM unmended = run_contact_m(contact, input, {.free_edge = true});
  document.check("contact-m-typed-edge", unmended.zero_node == input.zero_node,
                 "p >= 0 in Contact.m as printed gives the node aa that is typed");
  parameters::ContactCase twice = contact;
  twice.line_load *= 2;
  const ContactM wider = run_contact_m(twice, input, {true, true, true, true, true, true});
  document.check("contact-m-grid-holds-the-contact",
                 mended.zero_node < input.n_nodes && wider.zero_node == input.n_nodes,
                 "the nodes of Contact.m hold the contact under P, and just that under 2P");
  document.value("contact-m.right-zero-node", Value(mended.zero_node, integer()));
  document.value("contact-m.twice-zero-node", Value(wider.zero_node, integer()));
}

// The mended program against this report's solver, and against Hertz.
void compare_mended(literate::Document& document, const parameters::ContactCase& contact,
                    const ContactMInput& input, const std::vector<Row>& rows, const Hertz& hertz) {
  const contact::Solution solution = contact::solve_by_matrix_inversion(
      {contact.cylinders.profile(),
       contact.cylinders.contact_modulus(),
       {.n_nodes = input.n_nodes, .spacing = input.spacing, .is_one_sided = true}},
      contact.line_load);
  const double p0 = hertz.peak_pressure();
  const double rounding =
      largest_difference(rows[all].program.pressure,
                         {solution.pressure.data(), rows[all].program.pressure.size()}) /
      p0;
  const auto peak_error = [&](const Row& row) { return std::abs(peak(row.program) / p0 - 1); };
  document.value("contact-m.rounding", Value(rounding, scientific(1).rounded_up()));
  document.value("contact-m.peak-error",
                 Value(Estimate{peak_error(rows[all]), of_system}, scientific(1).rounded_up()));
  document.value("contact-m.finer-peak-error",
                 Value(Estimate{peak_error(rows[finer]), of_system}, scientific(1).rounded_up()));
  document.check("contact-m-is-matrix-inversion", rounding < of_system,
                 "Contact.m with every repair is the matrix inversion on a one-sided grid");
  // As the solver's own errors: see cylinders-agree-with-hertz.
  const double square = std::pow(input.spacing / hertz.half_width(), 2);
  document.check("contact-m-agrees-with-hertz",
                 peak_error(rows[all]) < 0.25 * square &&
                     peak_error(rows[finer]) < 0.25 * square / 16 &&
                     rows[finer].misfit < rows[all].misfit / 4,
                 "Contact.m with every repair agrees with Hertz to second order in c");
}

// What the prose says of single rows.
void check_rows(literate::Document& document, const std::vector<Row>& rows, double p0) {
  const auto& before = rows[printed].program.pressure;
  const double step_effect = largest_difference(before, rows[limits].program.pressure) / p0;
  document.value("contact-m.step-effect",
                 Value(Estimate{step_effect, 2 * of_system}, scientific(1).rounded_up()));
  document.check("contact-m-step-is-harmless", step_effect < 1e-3,
                 "the step off 0 and c changes no pressure of Contact.m by a thousandth of p0");
  document.check("contact-m-falls-to-its-edge",
                 std::ranges::is_sorted(before, std::ranges::greater()),
                 "the pressure of Contact.m as printed falls from the centre to the edge");
  const auto rises = [&](std::size_t i) {
    return pressure_beside_edge(rows[i].program) > 1.5 * rows[i].program.pressure[0];
  };
  document.check("contact-m-rises-to-a-typed-edge", rises(both_bodies) && rises(weight),
                 "with both bodies the pressure rises towards the typed edge");
  document.check("contact-m-order-matters",
                 rows[both_bodies].misfit > rows[mirror_images].misfit &&
                     rows[weight].misfit > rows[both_bodies].misfit &&
                     rows[free_edge].misfit < 0.01,
                 "before the edge is free, mending both bodies and the load adds to the misfit");
}

constexpr double of_program = 1e-2;  // how near Contact.m's numbers must be to count as right
const char* const reason = "1 %, far below what the element width of the listing lets one expect";

// The program's pressures, its area and its edge.
void claim_program(literate::Document& document, const parameters::ContactCase& c,
                   const config::UnitSystem& units, const ContactMInput& input,
                   const std::vector<Row>& rows, const Hertz& hertz) {
  const double load = c.line_load;
  const double carried = rows[printed].program.line_load;
  document.claim("contact-m-load",
                 {.sentence = "Contact.m calculates the pressure distribution between two "
                              "cylinders.",
                  .place = "paper, Problem Description, p. 6; Appendix 3, p. 17",
                  .stated = Value(load, significant(4), units.line_load),
                  .computed = Value(carried, significant(4), units.line_load),
                  .route = "the listed program run as printed: the load that its triangles carry",
                  .tolerance = reason,
                  .expected = Verdict::refuted,
                  .found = confirmed_if(std::abs(carried / load - 1) < of_program)});
  const double area = input.spacing * static_cast<double>(input.zero_node - 2);
  const double half_width = edge(rows[finer].program);
  document.claim("contact-m-area",
                 {.sentence = "A = c(aa − 2) is the contact area.",
                  .place = "paper, Appendix 3, p. 18",
                  .stated = Value(area, significant(2), units.length),
                  .computed = Value(half_width, significant(3), units.length),
                  .route = "the program with every repair, on a quarter of its element width: the "
                           "first node without pressure, for one side as A is",
                  .tolerance = "two of the listing's elements, since counting nodes is no better",
                  .expected = Verdict::refuted,
                  .found = confirmed_if(std::abs(area - half_width) < 2 * input.spacing)});
  const ContactM own = run_contact_m(c, input, {.free_edge = true});
  const bool is_own = own.zero_node == input.zero_node;
  const bool is_right = rows[all].program.zero_node == input.zero_node;
  document.claim("contact-m-edge",
                 {.sentence = "aa is the node where p becomes zero.",
                  .place = "paper, Appendix 3, p. 17",
                  .stated = Value(input.zero_node, integer()),
                  .computed = Value(rows[all].program.zero_node, integer()),
                  .route = "the edge found by p ≥ 0: in the program as printed, and with every "
                           "repair, which is the value",
                  .tolerance = "none, it is a count; partly if it is right for the printed program",
                  .expected = Verdict::partly,
                  .found = literate::confirmed_in(is_own + is_right, 2)});
  const double own_half_width = rows[printed].program.hertz_half_width;
  document.claim(
      "contact-m-hertz-width",
      {.sentence = "a of Contact.m is Hertz's contact width.",
       .place = "paper, Appendix 3, p. 18",
       .stated = Value(own_half_width, significant(4), units.length),
       .computed = Value(hertz.half_width(), significant(4), units.length),
       .route = "Hertz's half-width for two bodies under P",
       .tolerance = reason,
       .expected = Verdict::refuted,
       .found = confirmed_if(std::abs(own_half_width / hertz.half_width() - 1) < of_program)});
}

void claim_mended(literate::Document& document, const config::UnitSystem& units,
                  const std::vector<Row>& rows, const Hertz& hertz) {
  const double own_peak = rows[printed].program.hertz_peak_pressure;
  document.claim(
      "contact-m-hertz-peak",
      {.sentence = "p0 of Contact.m is Hertz's maximum pressure.",
       .place = "paper, Appendix 3, p. 18",
       .stated = Value(own_peak, significant(4), units.stress),
       .computed = Value(hertz.peak_pressure(), significant(4), units.stress),
       .route = "Hertz's peak for two bodies under P",
       .tolerance = reason,
       .expected = Verdict::refuted,
       .found = confirmed_if(std::abs(own_peak / hertz.peak_pressure() - 1) < of_program)});
  const double before = std::abs(peak(rows[all].program) / hertz.peak_pressure() - 1);
  const double after = std::abs(peak(rows[finer].program) / hertz.peak_pressure() - 1);
  const double ratio = rows[all].misfit / rows[finer].misfit;
  document.claim("contact-m-mended",
                 {.sentence = "With six repairs Contact.m converges to Hertz.",
                  .place = "this report",
                  .computed = Value(after, scientific(1).rounded_up()),
                  .route = "the peak of the mended program on a grid four times as fine, against "
                           "Hertz",
                  .tolerance = "10⁻³ before and 10⁻⁴ after refining, and a misfit of the pressure "
                               "that falls by four at least",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(before < 1e-3 && after < 1e-4 && ratio > 4)});
}

}  // namespace

void compute_contact_m(literate::Document& document, const parameters::ContactCase& contact,
                       const config::UnitSystem& units, const PrintedData& printed_data) {
  const ContactMInput input = as_printed(printed_data);
  const Hertz hertz(contact.cylinders, contact.line_load);
  const std::vector<Row> rows = repair(contact, input, hertz);

  describe_listing(document, contact, units, input, rows[printed].program, hertz);
  find_edges(document, contact, input, rows[all].program);
  compare_mended(document, contact, input, rows, hertz);
  check_rows(document, rows, hertz.peak_pressure());
  claim_program(document, contact, units, input, rows, hertz);
  claim_mended(document, units, rows, hertz);
  document.table(repair_table(rows, contact, hertz));
  document.figure("contact-m-repair", repair_figure(rows, hertz));
}

}  // namespace paper
