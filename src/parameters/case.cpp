// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/case.hpp"

#include <fmt/format.h>

#include "contact/grid.hpp"
#include "numerics/require.hpp"
#include "parameters/case_table.hpp"

namespace parameters {
namespace {

using numerics::require_positive;

double positive(const CaseTable& table, const std::string& key, Dimension dimension,
                const UnitSystem& units) {
  const double value = table.quantity(key, dimension, units);
  if (!(value > 0)) {
    table.fail(key, fmt::format("{} {}: must be greater than 0", value, units.unit(dimension)));
  }
  return value;
}

elasticity::Material read_material(const CaseTable& table, const UnitSystem& units) {
  const double young = positive(table, "young", Dimension::stress, units);
  const double poisson = table.number("poisson");
  return table.at("poisson", [&] { return elasticity::Material(young, poisson); });
}

// first, first + step, …, `count` of them; each product rounded once, so that 3·0.005 is 0.015.
std::vector<double> read_points(const CaseTable& table, const UnitSystem& units) {
  const double first = table.quantity("first", Dimension::length, units);
  const double step = positive(table, "step", Dimension::length, units);
  const long count = table.integer("count");
  if (count < 2 || count > 1000) {
    table.fail("count", fmt::format("{}: must be from 2 to 1000", count));
  }
  std::vector<double> points;
  for (long i = 0; i < count; ++i) points.push_back(first + static_cast<double>(i) * step);
  return points;
}

HalfSpaceCase read_half_space(const CaseTable& table, const UnitSystem& units) {
  const CaseTable load = table.table("load");
  return {read_material(table.table("material"), units),
          elasticity::TriangularLoad(positive(load, "peak_pressure", Dimension::stress, units),
                                     positive(load, "half_width", Dimension::length, units)),
          positive(table, "datum", Dimension::length, units),
          read_points(table.table("points"), units)};
}

CylinderCase read_body(const CaseTable& table, const UnitSystem& units) {
  const elasticity::Material material = read_material(table.table("material"), units);
  if (table.is_text("radius", "plane")) {
    table.text("radius");
    return {material, contact::Radius::of_plane()};
  }
  const double radius = table.quantity("radius", Dimension::length, units);
  return {material,
          table.at("radius", [&] { return contact::Radius::of_cylinder("radius", radius); })};
}

ContactCase read_contact(const CaseTable& table, const UnitSystem& units) {
  const CylinderCase body1 = read_body(table.table("body1"), units);
  const CylinderCase body2 = read_body(table.table("body2"), units);
  const auto cylinders = table.at("body2", [&] {
    return contact::CylinderPair(body1.material, body1.radius, body2.material, body2.radius);
  });
  const long n_nodes = table.integer("nodes");
  table.at("nodes", [&] { return contact::grid_around(1, n_nodes); });
  return {body1,
          body2,
          cylinders,
          positive(table, "load", Dimension::line_load, units),
          positive(table, "datum", Dimension::length, units),
          n_nodes};
}

PrintedFigure5 read_figure5(const CaseTable& table, std::size_t n_points) {
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

PrintedTriDist read_tri_dist(const CaseTable& table, std::size_t n_points) {
  PrintedTriDist printed{table.text("source"), table.printed_numbers("displacement"),
                         table.printed_number("step")};
  if (printed.displacement.size() != n_points) {
    table.fail("displacement",
               fmt::format("{} numbers for {} points", printed.displacement.size(), n_points));
  }
  return printed;
}

PrintedAppendix2 read_appendix2(const CaseTable& table) {
  return {table.text("source"),
          table.printed_number("resultant"),
          table.printed_number("max_disp_x"),
          table.printed_number("max_disp_y"),
          table.printed_number("strain_energy"),
          table.printed_number("max_stress_vm"),
          table.printed_number("mass")};
}

PrintedData read_printed(const CaseTable& table, std::size_t n_points, const UnitSystem& units) {
  if (!table.is_text("units", units.name)) {
    table.fail("units", fmt::format("\"{}\": printed data in other units than the case's {} cannot "
                                    "be compared; leave [printed] out",
                                    table.text("units"), units.name));
  }
  table.text("units");
  return {read_figure5(table.table("figure5"), n_points),
          read_tri_dist(table.table("tri_dist"), n_points),
          read_appendix2(table.table("appendix2"))};
}

}  // namespace

Case read_case(const std::filesystem::path& file) {
  const CaseTable root = CaseTable::parse_file(file);
  const std::string title = root.text("title");
  const UnitSystem units = root.at("units", [&] { return unit_system(root.text("units")); });
  const HalfSpaceCase half_space = read_half_space(root.table("half_space"), units);
  const ContactCase contact = read_contact(root.table("contact"), units);
  std::optional<PrintedData> printed;
  if (root.has("printed")) {
    printed = read_printed(root.table("printed"), half_space.points.size(), units);
  }
  root.reject_unknown_keys();
  return {file, title, units, half_space, contact, printed};
}

}  // namespace parameters
