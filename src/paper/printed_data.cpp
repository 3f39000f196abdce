// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/printed_data.hpp"

#include <fmt/core.h>

#include <cmath>

#include "config/table.hpp"

namespace paper {
namespace {

using Numbers = std::map<std::string, PrintedNumber>;

std::vector<PrintedNumber> column(const config::Table& table, const std::string& key,
                                  std::size_t n_points) {
  std::vector<PrintedNumber> numbers = parameters::printed_numbers(table, key);
  if (numbers.size() != n_points) {
    table.fail(key, fmt::format("{} numbers: must be {}, one per point", numbers.size(), n_points));
  }
  return numbers;
}

PrintedFigure5 read_figure5(const config::Table& table) {
  const std::vector<PrintedNumber> x = parameters::printed_numbers(table, "x");
  const std::size_t n = x.size();
  return {x, column(table, "fea_magnitude", n), column(table, "fea_z", n),
          column(table, "analytical", n), column(table, "error", n)};
}

PrintedTriDist read_tri_dist(const config::Table& table, std::size_t n_points) {
  const auto typed = [&](const char* key) { return parameters::printed_number(table, key); };
  return {typed("young"),
          typed("poisson"),
          typed("peak_pressure"),
          typed("half_width"),
          typed("datum"),
          typed("step"),
          column(table, "displacement", n_points)};
}

// All the numbers of a table, whatever their names. Those that are `needed` must be there.
Numbers read_numbers(const config::Table& table, const std::vector<std::string>& needed) {
  Numbers numbers;
  for (const std::string& key : table.keys())
    numbers.emplace(key, parameters::printed_number(table, key));
  for (const std::string& key : needed) {
    if (!numbers.contains(key)) table.fail(key, "missing");
  }
  return numbers;
}

PrintedAppendix2 read_appendix2(const config::Table& table, std::size_t n_points) {
  std::vector<std::string> measures = {"resultant_load_y", "max_disp_x",    "max_stress_prin",
                                       "max_stress_vm",    "max_stress_xx", "max_stress_xy",
                                       "max_stress_yy",    "max_stress_zz", "strain_energy"};
  std::vector<std::string> convergences = {"max_stress_xy", "strain_energy"};
  for (std::size_t i = 1; i <= n_points; ++i) {
    measures.push_back(fmt::format("measure{}", i));
    convergences.push_back(measures.back());
  }
  const config::Table error = table.table("stress_error");
  return {
      {parameters::printed_number(error, "rms"), parameters::printed_number(error, "of_largest")},
      read_numbers(table.table("measures"), measures),
      read_numbers(table.table("convergence"), convergences),
      read_numbers(table.table("mass_properties"),
                   {"mass", "centre_y", "ixx_about_origin", "iyy_about_origin", "izz_about_origin",
                    "ixx_about_centre", "iyy_about_centre", "izz_about_centre"})};
}

PrintedContactM read_contact_m(const config::Table& table) {
  const auto typed = [&](const char* key) { return parameters::printed_number(table, key); };
  return {typed("load"),  typed("young"),   typed("poisson"), typed("radius1"),  typed("radius2"),
          typed("datum"), typed("spacing"), typed("n_nodes"), typed("zero_node")};
}

// Returns "half_space.datum, 3 in, is not the paper's 10", or nothing.
std::string differs(const std::string& key, double number, const PrintedNumber& printed,
                    const std::string& unit) {
  constexpr double rounding = 1e-12;
  if (std::abs(number - printed.value()) <= rounding * std::abs(printed.value())) return "";
  return fmt::format("{}, {:.6g}{}, is not the paper's {}", key, number,
                     unit.empty() ? "" : " " + unit, printed.text());
}

std::string differs_in_points(const std::vector<double>& points,
                              const std::vector<PrintedNumber>& printed) {
  bool agree = points.size() == printed.size();
  for (std::size_t i = 0; agree && i < points.size(); ++i) {
    agree = printed[i].agrees_with(points[i]);
  }
  return agree ? "" : "half_space.points are not those of the paper's Fig. 5";
}

// The run's summary has no dimensions; they follow from the mass and the moments of inertia.
std::string differs_in_block(const parameters::Case& c, const PrintedAppendix2& printed) {
  if (!c.block) return "there is no [block]";
  if (c.block->sides != block::Support::clamped) return "block.sides are not clamped";
  const auto property = [&](const char* name) { return printed.mass_properties.at(name).value(); };
  const auto is_near = [](double number, double expected) {
    return std::abs(number - expected) <= 1e-2 * expected;
  };
  const double mass = property("mass");
  const double width = std::sqrt(12 * property("iyy_about_centre") / mass);
  const double height = std::sqrt(12 * property("ixx_about_centre") / mass);
  const block::Rectangle& r = c.block->rectangle;
  if (!is_near(r.width(), width)) return "block.width is not that of the paper's run";
  if (!is_near(r.height(), height)) return "block.height is not that of the paper's run";
  return is_near(c.block->density * r.width() * r.height(), mass)
             ? ""
             : "block.density is not that of the paper's run";
}

}  // namespace

std::optional<PrintedData> read_printed(const parameters::Case& from_file) {
  if (!from_file.printed) return std::nullopt;
  const config::Table& table = *from_file.printed;
  const PrintedFigure5 figure5 = read_figure5(table.table("figure5"));
  const std::size_t n_points = figure5.x.size();
  PrintedData printed{
      table.text("units"), figure5, read_tri_dist(table.table("tri_dist"), n_points),
      read_appendix2(table.table("appendix2"), n_points), read_contact_m(table.table("contact_m"))};
  table.reject_unknown_keys();
  return printed;
}

std::string difference_from_paper(const parameters::Case& c, const PrintedData& printed) {
  if (c.units.name != printed.units) {
    return fmt::format("the paper's units are {}, not {}", printed.units, c.units.name);
  }
  const HalfSpaceCase& h = c.half_space;
  const ContactCase& k = c.contact;
  const UnitSystem& u = c.units;
  const PrintedTriDist& t = printed.tri_dist;
  const PrintedContactM& m = printed.contact_m;
  const auto curvature = [](const parameters::CylinderCase& body) {
    return body.radius.curvature();
  };
  const std::string differences[] = {
      differs("half_space.material.young", h.material.young(), t.young, u.stress),
      differs("half_space.material.poisson", h.material.poisson(), t.poisson, ""),
      differs("half_space.load.peak_pressure", h.load.peak_pressure(), t.peak_pressure, u.stress),
      differs("half_space.load.half_width", h.load.half_width(), t.half_width, u.length),
      differs("half_space.datum", h.datum, t.datum, u.length),
      differs_in_points(h.points, printed.figure5.x),
      differs_in_block(c, printed.appendix2),
      c.point_contact ? "" : "there is no [point_contact]",
      differs("contact.load", k.line_load, m.load, u.line_load),
      differs("contact.datum", k.datum, m.datum, u.length),
      differs("contact.body1.radius", 1 / curvature(k.body1), m.radius1, u.length),
      differs("contact.body2.radius", 1 / curvature(k.body2), m.radius2, u.length),
      differs("contact.body1.material.young", k.body1.material.young(), m.young, u.stress),
      differs("contact.body2.material.young", k.body2.material.young(), m.young, u.stress),
      differs("contact.body1.material.poisson", k.body1.material.poisson(), m.poisson, ""),
      differs("contact.body2.material.poisson", k.body2.material.poisson(), m.poisson, "")};
  for (const std::string& difference : differences) {
    if (!difference.empty()) return difference;
  }
  return "";
}

}  // namespace paper
