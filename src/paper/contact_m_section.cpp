// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "line_contact/methods.hpp"
#include "paper/contact_m.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

// The program with all corrections up to one of them.
struct Row {
  std::string change;
  ContactM program;
};

constexpr ContactMRepairs all_repairs{true, true, true, true, true, true};

// The program as printed, with one more correction per row, and finally on a grid four times as
// fine.
std::vector<Row> repair(const ContactCase& contact, ContactMInput input) {
  std::vector<Row> rows;
  ContactMRepairs mended;
  const auto add = [&](const char* change) {
    rows.push_back({change, run_contact_m(contact, input, mended)});
  };
  add("as printed");
  const std::pair<const char*, bool ContactMRepairs::*> repairs[] = {
      {"limits at $0$ and $\\pm c$", &ContactMRepairs::limits},
      {"mirror images", &ContactMRepairs::mirror_images},
      {"both bodies", &ContactMRepairs::both_bodies},
      {"weight of equilibrium", &ContactMRepairs::weight_of_equilibrium},
      {"free edge", &ContactMRepairs::free_edge},
      {"Hertz under $P$", &ContactMRepairs::hertz_load}};
  for (const auto& [change, defect] : repairs) {
    mended.*defect = true;
    add(change);
  }
  input.n_nodes *= 4;
  input.spacing /= 4;
  add("a quarter of $c$");
  return rows;
}

// The rows by name.
enum : std::size_t { printed, limits, mirror_images, both_bodies, weight, free_edge, all, finer };

// P = ½πp₀a.
double load_of(const Hertz& hertz) {
  return std::numbers::pi / 2 * hertz.peak_pressure() * hertz.half_width();
}

double peak(const ContactM& program) {
  return *std::ranges::max_element(program.pressure);
}

// The x at which the pressure becomes zero.
double edge(const ContactM& program) {
  return program.x[static_cast<std::size_t>(program.zero_node - 1)];
}

// The load of all triangles and their mirror images, even if the program has none.
double symmetric_load(const ContactM& program) {
  if (program.has_mirror_images) return program.line_load;
  return 2 * program.line_load - (program.x[1] - program.x[0]) * program.pressure[0];
}

// The pressure between the nodes, at x ≥ 0.
double pressure_at(const ContactM& program, double x) {
  const double place = x / (program.x[1] - program.x[0]);
  const auto k = static_cast<std::size_t>(place);
  if (k + 1 >= program.x.size()) return 0;
  return std::lerp(program.pressure[k], program.pressure[k + 1], place - static_cast<double>(k));
}

// ∫|p − p_Hertz| dx over x ≥ 0, over P/2.
double departure(const ContactM& program, const Hertz& hertz) {
  constexpr int n = 20'000;
  const double end = std::max(edge(program), hertz.half_width());
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double x = end * (i + 0.5) / n;
    sum += std::abs(pressure_at(program, x) - hertz.pressure(x));
  }
  return 2 * sum * end / n / load_of(hertz);
}

// The largest error of the peak and the mean departure of the mended program, on grids of nearly
// the given spacing that place the edge of the contact at every hundredth of a spacing.
struct MendedErrors {
  double peak = 0, departure = 0;
};
MendedErrors errors_of_mended(const ContactCase& contact, ContactMInput input, const Hertz& hertz,
                              int refinement) {
  constexpr int n_grids = 100;
  const double elements = refinement * hertz.half_width() / input.spacing;
  input.n_nodes *= refinement;
  MendedErrors errors;
  for (int k = 0; k < n_grids; ++k) {
    input.spacing = hertz.half_width() / (elements + static_cast<double>(k) / n_grids);
    const ContactM program = run_contact_m(contact, input, all_repairs);
    errors.peak = std::max(errors.peak, std::abs(peak(program) / hertz.peak_pressure() - 1));
    errors.departure += departure(program, hertz) / n_grids;
  }
  return errors;
}

double largest_difference(const std::vector<double>& p, const double* other) {
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    largest = std::max(largest, std::abs(p[i] - other[i]));
  }
  return largest;
}

literate::Table repair_table(const std::vector<Row>& rows, const Hertz& hertz) {
  const auto column = [](const char* heading, int decimals) {
    return Column(heading, fixed(decimals));
  };
  literate::Table table("contact-m-repair", {Column("row", integer()), Column::text("change"),
                                             column("load over $P$", 3), column("edge over $a$", 2),
                                             column("peak over $p_0$", 3), column("departure", 4)});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ContactM& program = rows[i].program;
    table.add_row(
        {i, Cell::latex(rows[i].change), as_it_is(symmetric_load(program) / load_of(hertz)),
         as_it_is(edge(program) / hertz.half_width()),
         as_it_is(peak(program) / hertz.peak_pressure()), as_it_is(departure(program, hertz))});
  }
  return table;
}

// One panel for each row whose pressure or Hertz curve differs from the row before.
Figure repair_figure(const std::vector<Row>& rows, const Hertz& hertz) {
  Figure figure{.width_cm = 15.2, .height_cm = 6.6};
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
    figure.texts["title_" + panel] = std::to_string(i) + "\\enspace " + rows[i].change;
    figure.numbers["half_width_" + panel] = program.hertz_half_width / hertz.half_width();
    figure.numbers["p0_" + panel] = program.hertz_peak_pressure / hertz.peak_pressure();
  }
  figure.numbers["n_panels"] = number;

  // p/p₀ = √(1 − x²/a²), evenly spaced in the angle, so that the steep ends have enough points.
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

// The input of the listing and its results as printed.
void describe_listing(Document& document, const UnitSystem& units, const ContactMInput& input,
                      const std::vector<Row>& rows, const Hertz& hertz) {
  const ContactM& program = rows[printed].program;
  const double load = symmetric_load(program);
  const auto value = [&](const char* key, double number, const literate::Format& format,
                         const std::string& unit = "") {
    document.value(key, Value(number, format, unit).as_is());
  };
  document.value("contact-m.spacing", Value(input.spacing, exact(), units.length));
  document.value("contact-m.zero-node", Value(input.zero_node, integer()));
  document.value("contact-m.weight", Value(input.zero_node - 2, integer()));
  value("contact-m.edge", edge(program), significant(2), units.length);
  value("contact-m.edge-share", edge(program) / hertz.half_width(), fixed(2));
  value("contact-m.half-load", load / 2, significant(4), units.line_load);
  value("contact-m.symmetric-load", load, significant(4), units.line_load);
  value("contact-m.spike", program.pressure[0] / program.pressure[1], fixed(2));
  value("contact-m.hertz-half-width", program.hertz_half_width, significant(4), units.length);
  value("contact-m.hertz-peak", program.hertz_peak_pressure, significant(4), units.stress);
  value("contact-m.step-effect",
        largest_difference(program.pressure, rows[limits].program.pressure.data()) /
            hertz.peak_pressure(),
        scientific(1).rounded_up());
}

// The edge that p ≥ 0 gives: in the printed program, the mended one, and under the load of its
// Hertz.
void find_edges(Document& document, const ContactCase& contact, const ContactMInput& input,
                const ContactM& mended) {
  ContactCase twice = contact;
  twice.line_load *= 2;
  const ContactM own = run_contact_m(contact, input, {.free_edge = true});
  document.value("contact-m.right-zero-node", Value(mended.zero_node, integer()));
  document.value("contact-m.twice-zero-node",
                 Value(run_contact_m(twice, input, all_repairs).zero_node, integer()));
  document.check("contact-m-finds-its-edge", own.zero_node == input.zero_node,
                 "with its own equations and $p \\ge 0$ Contact.m finds the edge that is typed in");
}

// Compares the mended program with the right half of a symmetric grid of this report's solver.
void compare_mended(Document& document, const ContactCase& contact, const ContactMInput& input,
                    const ContactM& mended, const Hertz& hertz) {
  const Eigen::Index last = input.n_nodes - 1;
  const line_contact::Solution solution =
      line_contact::solve_by_matrix_inversion({contact.cylinders.profile(),
                                               contact.cylinders.contact_modulus(),
                                               {.n_nodes = 2 * last + 1, .spacing = input.spacing}},
                                              contact.line_load);
  const Value difference =
      Value(largest_difference(mended.pressure, solution.pressure.data() + last) /
                hertz.peak_pressure(),
            scientific(1).rounded_up())
          .as_is();
  document.value("contact-m.rounding", difference);
  document.check("contact-m-is-matrix-inversion",
                 {Criterion::at_most(
                     "largest difference of the pressures over the peak", difference,
                     Limit(1e-10, LimitKind::choice, "the same equations in a different order"))},
                 "Contact.m with every correction is matrix inversion on a symmetric grid");
}

// Compares the printed program's results with what it claims to compute.
void claim_program(Document& document, const ContactCase& c, const UnitSystem& units,
                   const ContactMInput& input, const ContactM& program, const Hertz& hertz) {
  const auto share = [](double number, const literate::Format& format) {
    return Value(number, format).as_is();
  };
  document.claim(
      "contact-m-load",
      {.route = "the listed program, restored as it reached us, against Hertz under the same load",
       .expected = Verdict::fails,
       .criteria = {
           Criterion::agrees_relatively(
               "load of its triangles and their mirror images",
               Value(symmetric_load(program), significant(4), units.line_load).as_is(),
               Value(c.line_load, exact(), units.line_load), less_than_a_plot_shows()),
           Criterion::agrees("half-width of the contact over Hertz's",
                             share(edge(program) / hertz.half_width(), fixed(2)), Value(1, exact()),
                             Limit(input.spacing / hertz.half_width(), LimitKind::theory,
                                   "$c/a$: an edge is known only to one spacing")),
           Criterion::at_most("departure of the pressure from Hertz's, as a share of the load",
                              share(departure(program, hertz), percent(0)),
                              less_than_a_plot_shows())}});
}

void claim_mended(Document& document, const ContactCase& contact, const ContactMInput& input,
                  const Hertz& hertz) {
  const MendedErrors own = errors_of_mended(contact, input, hertz, 1);
  const MendedErrors fine = errors_of_mended(contact, input, hertz, 4);
  const Value error = Value(own.peak, scientific(2).rounded_up()).as_is();
  const Value finer_error = Value(fine.peak, scientific(2).rounded_up()).as_is();
  document.value("contact-m.peak-error", error);
  document.value("contact-m.finer-peak-error", finer_error);
  document.claim(
      "contact-m-mended",
      {.route =
           "the corrected program on a hundred grids of about its own spacing, which place the "
           "edge at every hundredth of a spacing, and on a hundred grids four times as fine",
       .expected = Verdict::holds,
       .criteria = {
           Criterion::at_most("largest relative error of the peak", error,
                              less_than_a_plot_shows()),
           Criterion::at_most("on the finer grids", finer_error, less_than_a_plot_shows()),
           Criterion::at_least("mean departure from Hertz over that on the finer grids",
                               Value(own.departure / fine.departure, significant(2)).as_is(),
                               Limit(4, LimitKind::theory,
                                     "an order of at least 1 on elements a quarter as wide"))}});
}

}  // namespace

void compute_contact_m(Document& document, const Case& from) {
  if (!from.printed_data) return;
  const ContactCase& contact = from.contact;
  const ContactMInput input = as_printed(*from.printed_data);
  const Hertz hertz(contact.cylinders, contact.line_load);
  const std::vector<Row> rows = repair(contact, input);
  describe_listing(document, from.units, input, rows, hertz);
  find_edges(document, contact, input, rows[all].program);
  compare_mended(document, contact, input, rows[all].program, hertz);
  claim_program(document, contact, from.units, input, rows[printed].program, hertz);
  claim_mended(document, contact, input, hertz);
  document.table(repair_table(rows, hertz));
  document.figure("contact-m-repair", repair_figure(rows, hertz));
}

}  // namespace paper
