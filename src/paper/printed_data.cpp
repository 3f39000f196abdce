// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/printed_data.hpp"

#include <fmt/core.h>

#include <cmath>

#include "config/table.hpp"

namespace paper {
namespace {

PrintedFigure5 read_figure5(const config::Table& table, std::size_t n_points) {
  PrintedFigure5 figure{table.text("source"),
                        table.printed_numbers("x"),
                        table.printed_numbers("fea_magnitude"),
                        table.printed_numbers("fea_z"),
                        table.printed_numbers("analytical"),
                        table.printed_numbers("error")};
  for (const char* key : {"x", "fea_magnitude", "fea_z", "analytical", "error"}) {
    const std::size_t n = table.printed_numbers(key).size();
    if (n != n_points) table.fail(key, fmt::format("{} numbers for {} points", n, n_points));
  }
  return figure;
}

PrintedTriDist read_tri_dist(const config::Table& table, std::size_t n_points) {
  PrintedTriDist printed{table.text("source"), table.printed_numbers("displacement"),
                         table.printed_number("step")};
  if (printed.displacement.size() != n_points) {
    table.fail("displacement",
               fmt::format("{} numbers for {} points", printed.displacement.size(), n_points));
  }
  return printed;
}

std::map<std::string, config::PrintedNumber> read_numbers(const config::Table& table) {
  std::map<std::string, config::PrintedNumber> numbers;
  for (const std::string& key : table.keys()) numbers.emplace(key, table.printed_number(key));
  return numbers;
}

// Reads numbers under any names, of which some are needed.
std::map<std::string, config::PrintedNumber> read_numbers(const config::Table& table,
                                                          const std::vector<std::string>& needed) {
  for (const std::string& key : needed) {
    if (!table.has(key)) table.fail(key, "missing");
  }
  return read_numbers(table);
}

PrintedAppendix2 read_appendix2(const config::Table& table) {
  return {
      table.text("source"),
      read_numbers(table.table("measures"), {"resultant_load_y", "max_disp_x", "max_stress_vm",
                                             "max_stress_zz", "strain_energy"}),
      read_numbers(table.table("convergence")),
      read_numbers(table.table("mass_properties"),
                   {"mass", "centre_y", "ixx_about_origin", "iyy_about_origin", "izz_about_origin",
                    "ixx_about_centre", "iyy_about_centre", "izz_about_centre"})};
}

PrintedContactM read_contact_m(const config::Table& table) {
  PrintedContactM printed{table.text("source"), table.printed_number("spacing"),
                          table.printed_number("n_nodes"), table.printed_number("zero_node")};
  const double n_nodes = printed.n_nodes.value();
  const double zero_node = printed.zero_node.value();
  if (!(printed.spacing.value() > 0)) table.fail("spacing", "must be greater than 0");
  if (n_nodes != std::round(n_nodes) || n_nodes < 4 || n_nodes > 1000) {
    table.fail("n_nodes", fmt::format("{}: must be a whole number from 4 to 1000", n_nodes));
  }
  if (zero_node != std::round(zero_node) || zero_node < 3 || zero_node >= n_nodes) {
    table.fail("zero_node", fmt::format("{}: must be a whole number from 3 to n_nodes", zero_node));
  }
  return printed;
}

}  // namespace

std::optional<PrintedData> read_printed(const parameters::Case& from_file) {
  if (!from_file.printed) return std::nullopt;
  const config::Table& table = *from_file.printed;
  const config::UnitSystem& units = from_file.units;
  if (!table.is_text("units", units.name)) {
    table.fail("units", fmt::format("\"{}\": printed data in other units than the case's {} cannot "
                                    "be compared; leave [printed] out",
                                    table.text("units"), units.name));
  }
  table.text("units");
  const std::size_t n_points = from_file.half_space.points.size();
  PrintedData printed{read_figure5(table.table("figure5"), n_points),
                      read_tri_dist(table.table("tri_dist"), n_points),
                      read_appendix2(table.table("appendix2")),
                      read_contact_m(table.table("contact_m"))};
  table.reject_unknown_keys();
  return printed;
}

}  // namespace paper
