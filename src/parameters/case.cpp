// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/case.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/table.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/problem.hpp"

namespace parameters {
namespace {

// The range of a case's numbers. Beyond it, squares of lengths or pressures would overflow or
// underflow.
constexpr double least = 1e-50;
constexpr double greatest = 1e50;

// The greatest distance of datum and points from the load, in half-widths. Farther out, rounding
// swamps the differences of displacements.
constexpr double farthest = 1e8;

// The greatest size of the block, in half-widths of the load. In a larger block the elements are so
// thin that the stiffness is ill-conditioned.
constexpr double widest_block = 2000;

double in_range(const config::Table& table, const std::string& key, config::Dimension dimension,
                const config::UnitSystem& units) {
  const double value = table.quantity(key, dimension, units);
  if (value != 0 && !(std::abs(value) >= least && std::abs(value) <= greatest)) {
    table.fail(key, fmt::format("{:.12g} {}: its magnitude must be from {} to {}", value,
                                units.unit(dimension), least, greatest));
  }
  return value;
}

double positive(const config::Table& table, const std::string& key, config::Dimension dimension,
                const config::UnitSystem& units) {
  const double value = in_range(table, key, dimension, units);
  if (!(value > 0)) {
    table.fail(key,
               fmt::format("{:.12g} {}: must be greater than 0", value, units.unit(dimension)));
  }
  return value;
}

long integer_in(const config::Table& table, const std::string& key, long fewest, long most) {
  const long value = table.integer(key);
  if (value < fewest || value > most) {
    table.fail(key, fmt::format("{}: must be from {} to {}", value, fewest, most));
  }
  return value;
}

elasticity::Material read_material(const config::Table& table, const config::UnitSystem& units) {
  const double young = positive(table, "young", config::Dimension::stress, units);
  const double poisson = table.number("poisson");
  return table.at("poisson", [&] { return elasticity::Material(young, poisson); });
}

// Returns `count` points first, first + step, …; each product is rounded once, so 3·0.005 is 0.015.
std::vector<double> read_points(const config::Table& table, const config::UnitSystem& units) {
  const double first = in_range(table, "first", config::Dimension::length, units);
  const double step = positive(table, "step", config::Dimension::length, units);
  const long count = integer_in(table, "count", 2, 1000);
  std::vector<double> points;
  for (long i = 0; i < count; ++i) points.push_back(first + static_cast<double>(i) * step);
  return points;
}

HalfSpaceCase read_half_space(const config::Table& table, const config::UnitSystem& units) {
  const config::Table load = table.table("load");
  const elasticity::Material material = read_material(table.table("material"), units);
  const elasticity::TriangularLoad triangle(
      positive(load, "peak_pressure", config::Dimension::stress, units),
      positive(load, "half_width", config::Dimension::length, units));
  const double reach = farthest * triangle.half_width();
  const auto too_far = [&](double x) {
    return fmt::format(
        "{0:.12g} {1}: must be at most {2:.6g} {1}, {3} times half_space.load.half_width", x,
        units.length, reach, farthest);
  };
  const double datum = positive(table, "datum", config::Dimension::length, units);
  if (datum > reach) table.fail("datum", too_far(datum));
  const config::Table points_table = table.table("points");
  const std::vector<double> points = read_points(points_table, units);
  if (std::abs(points.front()) > reach) points_table.fail("first", too_far(points.front()));
  if (std::abs(points.back()) > reach) points_table.fail("step", too_far(points.back()));
  return {material, triangle, datum, points};
}

CylinderCase read_body(const config::Table& table, const config::UnitSystem& units) {
  const elasticity::Material material = read_material(table.table("material"), units);
  if (table.is_text("radius", "plane")) {
    table.text("radius");
    return {material, line_contact::Radius::of_plane()};
  }
  const double radius = in_range(table, "radius", config::Dimension::length, units);
  return {material,
          table.at("radius", [&] { return line_contact::Radius::of_cylinder("radius", radius); })};
}

ContactCase read_contact(const config::Table& table, const config::UnitSystem& units) {
  const CylinderCase body1 = read_body(table.table("body1"), units);
  const CylinderCase body2 = read_body(table.table("body2"), units);
  const auto cylinders = table.table("body2").at("radius", [&] {
    return line_contact::CylinderPair(body1.material, body1.radius, body2.material, body2.radius);
  });
  const long n_nodes = integer_in(table, "nodes", line_contact::min_nodes, line_contact::max_nodes);
  const double line_load = positive(table, "load", config::Dimension::line_load, units);
  const double datum = positive(table, "datum", config::Dimension::length, units);
  const line_contact::Grid grid =
      line_contact::grid_around(line_contact::Hertz(cylinders, line_load).half_width(), n_nodes);
  const double end = grid.x(grid.n_nodes - 1);
  if (datum <= end) {
    table.fail(
        "datum",
        fmt::format("{0:.12g} {1}: must be greater than {2:.6g} {1}, the end of the grid that "
                    "follows from contact.load, nodes, body1 and body2",
                    datum, units.length, end));
  }
  return {body1, body2, cylinders, line_load, datum, n_nodes};
}

block::Support read_sides(const config::Table& table) {
  const std::string sides = table.text("sides");
  if (sides == "clamped") return block::Support::clamped;
  if (sides == "roller") return block::Support::roller;
  if (sides == "free") return block::Support::free;
  table.fail("sides", fmt::format("\"{}\": must be clamped, roller or free", sides));
}

BlockCase read_block(const config::Table& table, const config::UnitSystem& units) {
  const block::Rectangle rectangle(positive(table, "width", config::Dimension::length, units),
                                   positive(table, "height", config::Dimension::length, units));
  block::Discretization discretization;
  discretization.order = static_cast<int>(integer_in(table, "order", 4, 10));
  discretization.refine = static_cast<int>(integer_in(table, "refine", 1, 4));
  return {rectangle, read_sides(table),
          positive(table, "density", config::Dimension::density, units), discretization};
}

// The block must contain the load and the points of the half-space with which it is compared.
void require_suitable(const config::Table& table, const block::Rectangle& rectangle,
                      const HalfSpaceCase& half_space, const config::UnitSystem& units) {
  if (half_space.load.half_width() >= rectangle.right()) {
    table.fail("width",
               fmt::format("{0:.12g} {1}: must be greater than {2:.6g} {1}, twice "
                           "half_space.load.half_width",
                           rectangle.width(), units.length, 2 * half_space.load.half_width()));
  }
  const double widest = widest_block * half_space.load.half_width();
  for (const auto& [key, size] :
       {std::pair{"width", rectangle.width()}, std::pair{"height", rectangle.height()}}) {
    if (size > widest) {
      table.fail(key, fmt::format("{0:.12g} {1}: must be at most {2:.6g} {1}, {3} times "
                                  "half_space.load.half_width",
                                  size, units.length, widest, widest_block));
    }
  }
  if (half_space.farthest_point() > rectangle.right()) {
    table.fail("width",
               fmt::format("{0:.12g} {1}: must be at least {2:.6g} {1}, twice the farthest of "
                           "half_space.points",
                           rectangle.width(), units.length, 2 * half_space.farthest_point()));
  }
}

// Returns the result of `read` for a table, all of whose keys it must read.
template <class Read>
auto whole(const CaseFile& file, const char* key, Read read) {
  const config::Table table = file.root().table(key);
  auto result = read(table, file.units());
  table.reject_unknown_keys();
  return result;
}

}  // namespace

double HalfSpaceCase::farthest_point() const {
  return std::max(std::abs(points.front()), std::abs(points.back()));
}

CaseFile::CaseFile(const std::filesystem::path& file)
    : root_(config::Table::parse_file(file)),
      units_(root_.at("units", [&] { return config::unit_system(root_.text("units")); })) {}

HalfSpaceCase CaseFile::half_space() const {
  return whole(*this, "half_space", &read_half_space);
}

ContactCase CaseFile::contact() const {
  return whole(*this, "contact", &read_contact);
}

PointContactCase CaseFile::point_contact() const {
  return whole(*this, "point_contact", [](const auto& table, const auto& units) {
    return PointContactCase{positive(table, "load", config::Dimension::force, units)};
  });
}

BlockCase CaseFile::block() const {
  return whole(*this, "block", &read_block);
}

Case read_case(const std::filesystem::path& path) {
  const CaseFile file(path);
  const config::Table& root = file.root();
  Case c{path, root.text("title"), file.units(), file.half_space(), file.contact(), {}, {}, {}};
  if (c.title.find_first_not_of(' ') == std::string::npos) {
    root.fail("title", "must not be empty");
  }
  if (root.has("point_contact")) c.point_contact = file.point_contact();
  if (root.has("block")) {
    c.block = file.block();
    require_suitable(root.table("block"), c.block->rectangle, c.half_space, file.units());
  }
  if (root.has("printed")) c.printed = root.table("printed");
  root.reject_unknown_keys({"printed"});
  return c;
}

}  // namespace parameters
