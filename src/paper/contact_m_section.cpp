// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "line_contact/dense_methods.hpp"
#include "paper/bounds.hpp"
#include "paper/contact_m.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

// The program with the corrections up to one of them.
struct Row {
  std::string mended;
  ContactM program;
  double misfit;  // ∫|p − Hertz| over x ≥ 0, over P/2
};

// ∫|l − p| dx from x₁ to x₂, where the line l goes from l₁ to l₂ and p is the pressure of Hertz.
// The pieces end where the two cross: (l₁ + s(x − x₁))² = p₀²[1 − (x/a)²] there, s the slope.
double between_line_and_hertz(double x1, double l1, double x2, double l2, const Hertz& hertz) {
  const double p0 = hertz.peak_pressure();
  const double a = hertz.half_width();
  const double slope = (l2 - l1) / (x2 - x1);
  const double at_zero = l1 - slope * x1;
  const auto integral = [&](double x) {  // of l − p from 0
    const double xi = std::clamp(x / a, 0., 1.);
    const double of_hertz = p0 * a / 2 * (xi * std::sqrt((1 - xi) * (1 + xi)) + std::asin(xi));
    return (at_zero + slope * x / 2) * x - of_hertz;
  };
  std::vector<double> ends{x1, x2};
  const auto cut = [&](double x) {
    if (x > x1 && x < x2) ends.push_back(x);
  };
  cut(a);
  if (slope != 0) cut(-at_zero / slope);
  const double steepness = slope * slope + p0 * p0 / (a * a);
  const double middle = -slope * at_zero / steepness;
  const double under_root = middle * middle - (at_zero * at_zero - p0 * p0) / steepness;
  if (under_root > 0) {
    cut(middle - std::sqrt(under_root));
    cut(middle + std::sqrt(under_root));
  }
  std::ranges::sort(ends);
  double sum = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    sum += std::abs(integral(ends[i]) - integral(ends[i - 1]));
  }
  return sum;
}

// ∫|p − p_Hertz| dx over x ≥ 0, over P/2; p is linear between the nodes, and zero beyond the last.
double misfit(const ContactM& program, const Hertz& hertz, double line_load) {
  double sum = 0;
  for (std::size_t i = 1; i < program.x.size(); ++i) {
    sum += between_line_and_hertz(program.x[i - 1], program.pressure[i - 1], program.x[i],
                                  program.pressure[i], hertz);
  }
  const double last = program.x.back();
  if (last < hertz.half_width()) {
    sum += between_line_and_hertz(last, 0, hertz.half_width(), 0, hertz);
  }
  return 2 * sum / line_load;
}

// As printed; each correction with those before it; and the last on a grid four times as fine.
std::vector<Row> repair(const ContactCase& contact, ContactMInput input, const Hertz& hertz) {
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
      {"Hertz under $P$", &ContactMRepairs::hertz_load}};
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

// The mended program on a grid of the case's spacing over `refinement`, and on others of nearly
// that spacing, on which the edge of the contact falls at other places between two nodes: the
// largest difference of the peak from Hertz's, and the mean misfit. On a single grid they may be
// small by chance.
struct MendedErrors {
  double peak = 0;
  double misfit = 0;
};

MendedErrors errors_of_mended(const ContactCase& contact, ContactMInput input, const Hertz& hertz,
                              int refinement) {
  constexpr int n_grids = 100;
  const double elements = refinement * hertz.half_width() / input.spacing;
  input.n_nodes *= refinement;
  MendedErrors errors;
  for (int k = 0; k < n_grids; ++k) {
    input.spacing = hertz.half_width() / (elements + static_cast<double>(k) / n_grids);
    const ContactM program = run_contact_m(contact, input, {true, true, true, true, true, true});
    errors.peak = std::max(errors.peak, std::abs(peak(program) / hertz.peak_pressure() - 1));
    errors.misfit += misfit(program, hertz, contact.line_load) / n_grids;
  }
  return errors;
}

// The load of all triangles, with their mirror images also where the program has none.
double symmetric_load(const ContactM& program) {
  if (program.has_mirror_images) return program.line_load;
  return 2 * program.line_load - (program.x[1] - program.x[0]) * program.pressure[0];
}

double pressure_beside_edge(const ContactM& program) {
  return program.pressure[static_cast<std::size_t>(program.zero_node - 2)];
}

// Its system of equations is as well conditioned as that of the report's own solver, with which it
// agrees to this part of the peak when it is mended: the check contact-m-is-matrix-inversion.
constexpr double of_system = 1e-10;

literate::Table repair_table(const std::vector<Row>& rows, const ContactCase& c,
                             const Hertz& hertz) {
  literate::Table table("contact-m-repair",
                        {Column("row", integer()), Column::text("change"),
                         Column("load over $P$", fixed(3)), Column("edge over $a$", fixed(2)),
                         Column("peak over $p_0$", fixed(3)), Column("departure", fixed(4))});
  // Loads and pressures are as wrong as the solved system, a misfit as twice its largest pressure.
  const double error = of_system + rounded(c, 1);
  const auto solved = [&](double x) { return Estimate{x, error * std::abs(x)}; };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ContactM& program = rows[i].program;
    const double share = edge(program) / hertz.half_width();
    table.add_row(
        {i, literate::Cell::latex(rows[i].mended), solved(symmetric_load(program) / c.line_load),
         Estimate{share, rounded(c, share)}, solved(peak(program) / hertz.peak_pressure()),
         Estimate{rows[i].misfit, 2 * share * error * peak(program) / hertz.peak_pressure()}});
  }
  return table;
}

// One panel for each row whose pressure or whose Hertz differs from the last.
Figure repair_figure(const std::vector<Row>& rows, const Hertz& hertz) {
  Figure figure{.width_cm = 15.2, .height_cm = 7.6};
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
void describe_listing(Document& document, const ContactCase& c, const UnitSystem& units,
                      const ContactMInput& input, const ContactM& program, const Hertz& hertz) {
  const double load = c.line_load;
  const auto weight = static_cast<double>(input.zero_node - 2);
  document.value("contact-m.spacing", Value(input.spacing, exact(), units.length));
  document.value("contact-m.zero-node", Value(input.zero_node, integer()));
  document.value("contact-m.weight", Value(weight, exact()));
  const double share = edge(program) / hertz.half_width();
  const Estimate carried{program.line_load, of_system * program.line_load};
  const double spike = program.pressure[0] / program.pressure[1];
  document.value("contact-m.edge", Value(closed_form(edge(program)), significant(2), units.length));
  document.value("contact-m.edge-share", Value(share, fixed(2)).within(rounded(c, share)));
  const double both_sides = symmetric_load(program);
  document.value("contact-m.half-load", Value({both_sides / 2, 2 * of_system * program.line_load},
                                              significant(4), units.line_load));
  document.value("contact-m.symmetric-load", Value({both_sides, 3 * of_system * program.line_load},
                                                   significant(4), units.line_load));
  document.value("contact-m.hertz-half-width",
                 Value(program.hertz_half_width, significant(4), units.length)
                     .within(rounded(c, program.hertz_half_width)));
  document.value("contact-m.hertz-peak",
                 Value(program.hertz_peak_pressure, significant(4), units.stress)
                     .within(rounded(c, program.hertz_peak_pressure)));
  document.value("contact-m.spike", Value(spike, fixed(2)).within(2 * of_system * spike));
  document.check(
      "contact-m-load",
      {Criterion::agrees_relatively(
          "load that the triangles carry", Value(carried, significant(4), units.line_load),
          Value(closed_form(load / weight), significant(4), units.line_load),
          {LimitKind::choice, 1e-9, "the last equation is solved as the others are"})},
      "Contact.m as printed carries P/(aa - 2)");
}

// Where p >= 0 puts the edge: in the program as printed, mended, and under the load of its Hertz.
void find_edges(Document& document, const ContactCase& contact, const ContactMInput& input,
                const ContactM& mended) {
  ContactCase twice = contact;
  twice.line_load *= 2;
  const ContactM wider = run_contact_m(twice, input, {true, true, true, true, true, true});
  const ContactM own = run_contact_m(contact, input, {.free_edge = true});
  document.check("contact-m-finds-its-edge",
                 {Criterion::agrees("node where p becomes zero", Value(own.zero_node, integer()),
                                    Value(input.zero_node, integer()),
                                    {LimitKind::data, 0.0, "it is a count"})},
                 "looking for its edge by p >= 0, Contact.m as printed finds the node typed in");
  document.check("contact-m-grid-holds-the-contact",
                 mended.zero_node < input.n_nodes && wider.zero_node == input.n_nodes,
                 "the nodes of Contact.m hold the contact under P, and just that under 2P");
  document.value("contact-m.right-zero-node", Value(mended.zero_node, integer()));
  document.value("contact-m.twice-zero-node", Value(wider.zero_node, integer()));
}

// The mended program against this report's solver, and against Hertz.
void compare_mended(Document& document, const ContactCase& contact, const ContactMInput& input,
                    const std::vector<Row>& rows, const Hertz& hertz) {
  const line_contact::Solution solution = line_contact::solve_by_matrix_inversion(
      {contact.cylinders.profile(),
       contact.cylinders.contact_modulus(),
       {.n_nodes = 2 * input.n_nodes - 1, .spacing = input.spacing}},
      contact.line_load);
  const double p0 = hertz.peak_pressure();
  const double rounding =
      largest_difference(rows[all].program.pressure,
                         {solution.pressure.data() + input.n_nodes - 1, rows[all].program.pressure.size()}) /
      p0;
  document.value("contact-m.rounding", Value(rounding, scientific(1).rounded_up()).as_is());
  document.check(
      "contact-m-is-matrix-inversion",
      {Criterion::at_most("largest difference of the pressures, over p₀",
                          Value(rounding, scientific(1).rounded_up()).as_is(),
                          {LimitKind::choice, of_system, "the same equations in another order"})},
      "Contact.m with every correction is the matrix inversion on both sides");
}

// What the prose says of single rows.
void check_rows(Document& document, const std::vector<Row>& rows, double p0) {
  const auto& before = rows[printed].program.pressure;
  const double step_effect = largest_difference(before, rows[limits].program.pressure) / p0;
  document.value("contact-m.step-effect",
                 Value(Estimate{step_effect, 2 * of_system}, scientific(1).rounded_up()));
  document.check(
      "contact-m-step-is-harmless",
      {Criterion::at_most("largest change of a pressure, over p₀",
                          Value(Estimate{step_effect, 2 * of_system}, scientific(1).rounded_up()),
                          {LimitKind::choice, 1e-3, "less than a plot shows"})},
      "the step off 0 and c changes no pressure of Contact.m");
  document.check("contact-m-falls-to-its-edge",
                 std::ranges::is_sorted(before, std::ranges::greater()),
                 "the pressure of Contact.m as printed falls from the centre to the edge");
  document.check(
      "contact-m-overlaps-once-mirrored",
      rows[printed].program.gap_at_edge > 0 && rows[mirror_images].program.gap_at_edge < 0,
      "with mirror images the bodies of Contact.m overlap at the edge, and not before");
  const auto rises = [&](std::size_t i) {
    const double ratio = pressure_beside_edge(rows[i].program) / rows[i].program.pressure[0];
    return Criterion::at_least("row " + std::to_string(i),
                               Value({ratio, 2 * of_system * ratio}, significant(2)),
                               {LimitKind::choice, 1.5, "a rise that a plot shows"});
  };
  document.check("contact-m-rises-to-a-typed-edge", {rises(both_bodies), rises(weight)},
                 "with both bodies the pressure beside the typed edge is above that of the middle");
  const auto grows = [&](std::size_t i) {
    const double ratio = rows[i].misfit / rows[i - 1].misfit;
    return Criterion::at_least("misfit of row " + std::to_string(i) + " over that before",
                               Value({ratio, 4 * of_system * ratio}, significant(2)),
                               {LimitKind::data, 1.0, "a repair that makes it worse"});
  };
  document.check("contact-m-order-matters",
                 {grows(both_bodies), grows(weight),
                  Criterion::at_most("misfit with a free edge",
                                     Value({rows[free_edge].misfit, 4 * of_system}, percent(1)),
                                     less_than_a_plot_shows())},
                 "before the edge is free, correcting both bodies and the load adds to the misfit");
}

// What it computes, for what it says that it computes.
void claim_program(Document& document, const ContactCase& c, const UnitSystem& units,
                   const ContactMInput& input, const Row& row, const Hertz& hertz) {
  const double carried = symmetric_load(row.program);
  const double share = edge(row.program) / hertz.half_width();
  document.claim(
      "contact-m-load",
      {.route = "the listed program run as printed, against Hertz under the load that it is given",
       .expected = Verdict::refuted,
       .criteria = {
           Criterion::agrees_relatively(
               "load of its triangles and their mirror images",
               Value({carried, 3 * of_system * carried}, significant(4), units.line_load),
               Value(c.line_load, exact(), units.line_load),
               {LimitKind::choice, 1e-2, "less than a plot shows"}),
           Criterion::agrees("half-width of the contact over Hertz's",
                             Value(share, fixed(2)).within(rounded(c, share)), Value(1, exact()),
                             Limit::theory("𝑐/𝑎", {{"𝑐", input.spacing}, {"𝑎", hertz.half_width()}},
                                           "one element: an edge is known only to one spacing")),
           Criterion::at_most("departure of the pressure from Hertz's, as a share of the load",
                              Value({row.misfit, 4 * of_system}, percent(0)),
                              less_than_a_plot_shows())}});
}

void claim_mended(Document& document, const ContactCase& contact, const ContactMInput& input,
                  const Hertz& hertz) {
  const MendedErrors own = errors_of_mended(contact, input, hertz, 1);
  const MendedErrors fine = errors_of_mended(contact, input, hertz, 4);
  const auto register_error = [&](const char* key, const MendedErrors& errors) {
    document.value(key, Value(Estimate{errors.peak, of_system}, scientific(2).rounded_up()));
  };
  register_error("contact-m.peak-error", own);
  register_error("contact-m.finer-peak-error", fine);
  const auto peak_error = [&](const char* what, const MendedErrors& errors) {
    return Criterion::at_most(what,
                              Value(Estimate{errors.peak, of_system}, scientific(2).rounded_up()),
                              less_than_a_plot_shows());
  };
  const double ratio = own.misfit / fine.misfit;
  document.claim(
      "contact-m-mended",
      {.route =
           "the corrected program on a hundred grids of about its own spacing, on which the edge "
           "falls at every hundredth of a spacing, and on a hundred four times as fine",
       .expected = Verdict::confirmed,
       .criteria = {
           peak_error("largest relative difference of the peaks", own),
           peak_error("on the finer grids", fine),
           Criterion::at_least(
               "mean departure of the pressures over that on the finer grids",
               Value({ratio, 4 * of_system / fine.misfit * ratio}, significant(2)),
               Limit::theory("4", {}, "an order of at least 1 on elements a quarter as wide"))}});
}

}  // namespace

void compute_contact_m(Document& document, const Case& from) {
  if (!from.printed_data) return;
  const ContactCase& contact = from.contact;
  const UnitSystem& units = from.units;
  const ContactMInput input = as_printed(*from.printed_data);
  const Hertz hertz(contact.cylinders, contact.line_load);
  const std::vector<Row> rows = repair(contact, input, hertz);

  describe_listing(document, contact, units, input, rows[printed].program, hertz);
  find_edges(document, contact, input, rows[all].program);
  compare_mended(document, contact, input, rows, hertz);
  check_rows(document, rows, hertz.peak_pressure());
  claim_program(document, contact, units, input, rows[printed], hertz);
  claim_mended(document, contact, input, hertz);
  document.table(repair_table(rows, contact, hertz));
  document.figure("contact-m-repair", repair_figure(rows, hertz));
}

}  // namespace paper
