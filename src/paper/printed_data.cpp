// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/printed_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "config/table.hpp"
#include "paper/prelude.hpp"

namespace paper {
namespace {

// What print may hold: squares and quotients of such numbers are doubles.
constexpr double least = 1e-50;
constexpr double greatest = 1e50;

enum class Sign { any, not_zero, positive };

void require_in_range(const config::Table& table, const std::string& key,
                      const PrintedNumber& number, Sign sign) {
  const double size = std::abs(number.value());
  if (size != 0 && !(size >= least && size <= greatest)) {
    table.fail(key, fmt::format("{}: its magnitude must be from {} to {}", number.text(), least,
                                greatest));
  }
  if (sign == Sign::positive && !(number.value() > 0)) {
    table.fail(key, fmt::format("{}: must be greater than 0", number.text()));
  }
  if (sign == Sign::not_zero && size == 0) {
    table.fail(key, fmt::format("{}: must not be 0", number.text()));
  }
}

std::vector<PrintedNumber> read_column(const config::Table& table, const std::string& key,
                                       std::size_t n_points, Sign sign) {
  std::vector<PrintedNumber> column = table.printed_numbers(key);
  if (column.size() != n_points) {
    table.fail(key, fmt::format("{} numbers for {} points", column.size(), n_points));
  }
  for (const PrintedNumber& number : column) require_in_range(table, key, number, sign);
  return column;
}

// The report divides by the slopes between the last five points.
void require_slopes(const config::Table& table, const std::string& key,
                    const std::vector<PrintedNumber>& column) {
  constexpr std::size_t n_last = 5;
  for (std::size_t i = std::max(n_last, column.size()) - n_last + 1; i < column.size(); ++i) {
    const double step = std::abs(column[i].value() - column[i - 1].value());
    if (!(step > column[i].last_place() + column[i - 1].last_place())) {
      table.fail(key, fmt::format("{} after {}: neighbours among the last {} must differ by more "
                                  "than their last places",
                                  column[i].text(), column[i - 1].text(), n_last));
    }
  }
}

PrintedFigure5 read_figure5(const config::Table& table, const std::vector<double>& points,
                            const std::string& unit) {
  PrintedFigure5 figure{table.text("source"),
                        read_column(table, "x", points.size(), Sign::any),
                        read_column(table, "fea_magnitude", points.size(), Sign::positive),
                        read_column(table, "fea_z", points.size(), Sign::positive),
                        read_column(table, "analytical", points.size(), Sign::positive),
                        read_column(table, "error", points.size(), Sign::positive)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (figure.x[i].agrees_with(points[i])) continue;
    table.fail("x", fmt::format("{} {}: must be {:.12g} {}, which half_space.points has there",
                                figure.x[i].text(), unit, points[i], unit));
  }
  require_slopes(table, "analytical", figure.analytical);
  return figure;
}

PrintedTriDist read_tri_dist(const config::Table& table, const HalfSpaceCase& c,
                             const std::string& unit) {
  PrintedTriDist printed{table.text("source"),
                         read_column(table, "displacement", c.points.size(), Sign::positive),
                         table.printed_number("step")};
  require_in_range(table, "step", printed.step, Sign::positive);
  if (printed.step.value() > c.load.half_width()) {
    table.fail("step", fmt::format("{0} {1}: must be at most half_space.load.half_width, {2:.6g} "
                                   "{1}",
                                   printed.step.text(), unit, c.load.half_width()));
  }
  return printed;
}

// Reads numbers under any names, of which some are needed, because the report divides by them.
std::map<std::string, PrintedNumber> read_numbers(const config::Table& table,
                                                  const std::vector<std::string>& needed) {
  std::map<std::string, PrintedNumber> numbers;
  for (const std::string& key : table.keys()) {
    require_in_range(table, key, numbers.emplace(key, table.printed_number(key)).first->second,
                     Sign::any);
  }
  for (const std::string& key : needed) {
    if (!table.has(key)) table.fail(key, "missing");
    require_in_range(table, key, numbers.at(key), Sign::not_zero);
  }
  return numbers;
}

std::map<std::string, PrintedNumber> read_measures(const config::Table& table,
                                                   std::size_t n_points) {
  std::vector<std::string> needed = {"resultant_load_y", "max_disp_mag",    "max_disp_x",
                                     "max_disp_y",       "max_stress_prin", "max_stress_vm",
                                     "max_stress_xx",    "max_stress_xy",   "max_stress_yy",
                                     "max_stress_zz",    "strain_energy"};
  for (std::size_t i = 1; i <= n_points; ++i) needed.push_back(fmt::format("measure{}", i));
  std::map<std::string, PrintedNumber> measures = read_numbers(table, needed);
  const PrintedNumber& xx = measures.at("max_stress_xx");
  const PrintedNumber& yy = measures.at("max_stress_yy");
  if (!(std::abs(xx.value() + yy.value()) > xx.last_place() + yy.last_place())) {
    table.fail("max_stress_xx", fmt::format("{}: must not be the opposite of max_stress_yy, {}",
                                            xx.text(), yy.text()));
  }
  return measures;
}

PrintedStressError read_stress_error(const config::Table& table) {
  PrintedStressError printed{table.printed_number("rms"), table.printed_number("of_largest")};
  require_in_range(table, "rms", printed.rms, Sign::positive);
  require_in_range(table, "of_largest", printed.of_largest, Sign::positive);
  return printed;
}

PrintedAppendix2 read_appendix2(const config::Table& table, std::size_t n_points) {
  return {
      table.text("source"), read_stress_error(table.table("stress_error")),
      read_measures(table.table("measures"), n_points),
      read_numbers(table.table("convergence"), {"max_stress_prin", "max_stress_xy"}),
      read_numbers(table.table("mass_properties"),
                   {"mass", "centre_y", "ixx_about_origin", "iyy_about_origin", "izz_about_origin",
                    "ixx_about_centre", "iyy_about_centre", "izz_about_centre"})};
}

PrintedContactM read_contact_m(const config::Table& table, const ContactCase& c,
                               const std::string& unit) {
  PrintedContactM printed{table.text("source"), table.printed_number("spacing"),
                          table.printed_number("n_nodes"), table.printed_number("zero_node")};
  const double n_nodes = printed.n_nodes.value();
  const double zero_node = printed.zero_node.value();
  require_in_range(table, "spacing", printed.spacing, Sign::positive);
  if (n_nodes != std::round(n_nodes) || n_nodes < 5 || n_nodes > 1000) {
    table.fail("n_nodes", fmt::format("{}: must be a whole number from 5 to 1000", n_nodes));
  }
  if (zero_node != std::round(zero_node) || zero_node < 3 || zero_node >= n_nodes) {
    table.fail("zero_node", fmt::format("{}: must be a whole number from 3 to n_nodes", zero_node));
  }
  // The listed program's last node but one is the edge of the contact under 2P.
  const double twice = Hertz(c.cylinders, 2 * c.line_load).half_width();
  const double least_spacing = twice / (n_nodes - 2);
  const double most_spacing = twice / (n_nodes - 4);
  if (!(printed.spacing.value() >= least_spacing && printed.spacing.value() <= most_spacing)) {
    table.fail("spacing", fmt::format("{0} {1}: must be from {2:.4g} to {3:.4g} {1}, so that "
                                      "n_nodes nodes just hold the contact under twice "
                                      "contact.load; leave [printed] out of a case with other "
                                      "cylinders than the paper's",
                                      printed.spacing.text(), unit, least_spacing, most_spacing));
  }
  return printed;
}

}  // namespace

std::optional<PrintedData> read_printed(const parameters::Case& from_file) {
  if (!from_file.printed) return std::nullopt;
  const config::Table& table = *from_file.printed;
  const UnitSystem& units = from_file.units;
  if (!table.is_text("units", units.name)) {
    table.fail("units", fmt::format("\"{}\": printed data in other units than the case's {} cannot "
                                    "be compared; leave [printed] out",
                                    table.text("units"), units.name));
  }
  table.text("units");
  const HalfSpaceCase& half_space = from_file.half_space;
  PrintedData printed{read_figure5(table.table("figure5"), half_space.points, units.length),
                      read_tri_dist(table.table("tri_dist"), half_space, units.length),
                      read_appendix2(table.table("appendix2"), half_space.points.size()),
                      read_contact_m(table.table("contact_m"), from_file.contact, units.length)};
  table.reject_unknown_keys();
  return printed;
}

}  // namespace paper
