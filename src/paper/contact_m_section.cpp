// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "contact/hertz.hpp"
#include "contact/matrix_inversion.hpp"
#include "figures/contact_m_repair.hpp"
#include "paper/contact_m.hpp"
#include "paper/sections.hpp"

namespace paper {
namespace {

using contact::Hertz;
using literate::Column;
using literate::Value;

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

literate::Table repair_table(const std::vector<Row>& rows, const Hertz& hertz, double line_load) {
  literate::Table table(
      {Column::integer(""), Column::text("mended besides"), Column::fixed("load over $P$", "", 3),
       Column::fixed("edge over $a$", "", 2), Column::fixed("peak over $p_0$", "", 4),
       Column::fixed("over its own $p_0$", "", 4), Column::fixed("misfit", "", 4)});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ContactM& program = rows[i].program;
    table.add_row({i, literate::Cell::latex(rows[i].mended), program.line_load / line_load,
                   edge(program) / hertz.half_width(), peak(program) / hertz.peak_pressure(),
                   peak(program) / program.hertz_peak_pressure, rows[i].misfit});
  }
  return table;
}

// One panel for each row whose pressure or whose Hertz differs from the last.
figures::ContactMRepair repair_figure(const std::vector<Row>& rows, const Hertz& hertz) {
  figures::ContactMRepair figure;
  for (const std::size_t i : {printed, mirror_images, both_bodies, weight, free_edge, all}) {
    const ContactM& program = rows[i].program;
    figures::ContactMRepair::Panel panel{std::to_string(i) + "\\enspace " + rows[i].mended,
                                         {},
                                         {},
                                         program.hertz_half_width / hertz.half_width(),
                                         program.hertz_peak_pressure / hertz.peak_pressure()};
    const auto add = [&](double x, double pressure) {
      panel.x.push_back(x / hertz.half_width());
      panel.pressure.push_back(pressure / hertz.peak_pressure());
    };
    const auto n = static_cast<std::size_t>(program.zero_node);
    for (std::size_t k = program.has_mirror_images ? n - 1 : 1; k > 0; --k) {
      add(-program.x[k], program.has_mirror_images ? program.pressure[k] : 0);
    }
    for (std::size_t k = 0; k < n; ++k) add(program.x[k], program.pressure[k]);
    figure.panels.push_back(std::move(panel));
  }
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
void describe_listing(literate::Document& document, const parameters::Case& from_file,
                      const ContactMInput& input, const ContactM& program, const Hertz& hertz) {
  const parameters::UnitSystem& units = from_file.units;
  const double load = from_file.contact.line_load;
  const auto weight = static_cast<double>(input.zero_node - 2);
  document.value("contact-m.spacing", Value::exact(input.spacing, units.length));
  document.value("contact-m.step", Value::exact(input.step, units.length));
  document.value("contact-m.nodes", Value::integer(input.n_nodes + 1));
  document.value("contact-m.zero-node", Value::integer(input.zero_node));
  document.value("contact-m.weight", Value::exact(weight));
  document.value("contact-m.edge", Value::significant(edge(program), 2, units.length));
  document.value("contact-m.edge-share", Value::fixed(edge(program) / hertz.half_width(), 2));
  document.value("contact-m.load", Value::significant(program.line_load, 4, units.line_load));
  document.value("contact-m.load-share", Value::fixed(load / program.line_load, 2));
  document.value("contact-m.hertz-half-width",
                 Value::significant(program.hertz_half_width, 4, units.length));
  document.value("contact-m.hertz-peak",
                 Value::significant(program.hertz_peak_pressure, 4, units.stress));
  document.value("contact-m.spike", Value::fixed(program.pressure[0] / program.pressure[1], 2));
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
  document.value("contact-m.right-zero-node", Value::integer(mended.zero_node));
  document.value("contact-m.twice-zero-node", Value::integer(wider.zero_node));
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
  document.value("contact-m.rounding", Value::scientific_bound(rounding, 1));
  document.value("contact-m.peak-error", Value::scientific_bound(peak_error(rows[all]), 1));
  document.value("contact-m.finer-peak-error", Value::scientific_bound(peak_error(rows[finer]), 1));
  document.check("contact-m-is-matrix-inversion", rounding < 1e-10,
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
  document.value("contact-m.step-effect", Value::scientific_bound(step_effect, 1));
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

}  // namespace

void compute_contact_m(literate::Document& document, const parameters::Case& from_file) {
  const parameters::ContactCase& contact = from_file.contact;
  const ContactMInput input = as_printed(*from_file.printed);
  const Hertz hertz(contact.cylinders, contact.line_load);
  const std::vector<Row> rows = repair(contact, input, hertz);

  describe_listing(document, from_file, input, rows[printed].program, hertz);
  find_edges(document, contact, input, rows[all].program);
  compare_mended(document, contact, input, rows, hertz);
  check_rows(document, rows, hertz.peak_pressure());
  document.table("contact-m-repair", repair_table(rows, hertz, contact.line_load));
  document.figure("contact-m-repair", 15.2, 9.6,
                  [figure = repair_figure(rows, hertz)](literate::Plot& plot) {
                    figures::draw_contact_m_repair(plot, figure);
                  });
}

}  // namespace paper
