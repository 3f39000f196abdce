// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/solution.hpp"

#include <fmt/core.h>

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "point_contact/solver/grid.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

// The XML names each array with its place in the data that follow it.
class Arrays {
 public:
  // Adds an array and returns the element that names it.
  template <class Number>
  std::string add(std::string_view attributes, std::span<const Number> numbers) {
    const std::string element = fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>\n",
                                            attributes, data_.size());
    const std::uint64_t n_bytes = numbers.size_bytes();
    data_.append(reinterpret_cast<const char*>(&n_bytes), sizeof n_bytes);
    data_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
    return element;
  }

  const std::string& data() const { return data_; }

 private:
  std::string data_;
};

struct Cells {
  std::vector<std::int64_t> corners;
  int n_corners;  // of each
};

Cells cells_of(const Solution& solution) {
  const Grid& grid = solution.grid;
  const bool is_triangular = grid.is_staggered || solution.element == Element::pyramid;
  Cells cells{.corners = {}, .n_corners = is_triangular ? 3 : 4};
  const auto add = [&](std::initializer_list<std::int64_t> corners) {
    cells.corners.insert(cells.corners.end(), corners);
  };
  for (Index j = 0; j + 1 < grid.n2; ++j) {
    // from -1, since in every second staggered row the first triangle hangs from the row above
    for (Index i = -1; i + 1 < grid.n1; ++i) {
      const Index above = grid.neighbour(i, j, 0, 1);
      const Index here = grid.index(i, j);
      const Index there = grid.index(above, j + 1);
      if (!is_triangular) {
        if (i >= 0) add({here, here + 1, there + 1, there});
        continue;
      }
      if (i >= 0) add({here, here + 1, there});
      if (above >= 0 && above + 1 < grid.n1) add({here + 1, there + 1, there});
    }
  }
  return cells;
}

std::vector<double> coordinates_of(const Grid& grid) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * size_of(grid.size()));
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const Vector2 at = grid.node(i, j);
      coordinates.insert(coordinates.end(), {at.x(), at.y(), 0});
    }
  }
  return coordinates;
}

}  // namespace

std::string vtu(const Solution& solution, const Eigen::VectorXd& shear) {
  const Cells cells = cells_of(solution);
  const std::size_t n_cells = cells.corners.size() / size_of(cells.n_corners);
  std::vector<std::int64_t> ends(n_cells);
  for (std::size_t k = 0; k < n_cells; ++k) {
    ends[k] = static_cast<std::int64_t>(k + 1) * cells.n_corners;
  }
  constexpr std::uint8_t vtk_triangle = 5;
  constexpr std::uint8_t vtk_quad = 9;
  const std::vector<std::uint8_t> types(n_cells, cells.n_corners == 3 ? vtk_triangle : vtk_quad);

  Arrays arrays;
  const auto field = [&](std::string_view name, const Eigen::VectorXd& values) {
    return arrays.add<double>(fmt::format("type=\"Float64\" Name=\"{}\"", name),
                              {values.data(), size_of(values.size())});
  };
  constexpr bool is_little = std::endian::native == std::endian::little;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"{}Endian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData Scalars=\"pressure\">\n",
      is_little ? "Little" : "Big", solution.grid.size(), n_cells);
  text += field("pressure", solution.pressure) + field("gap", solution.gap);
  if (shear.size() > 0) text += field("shear", shear);
  text += "</PointData>\n<Points>\n";
  text += arrays.add<double>("type=\"Float64\" NumberOfComponents=\"3\"",
                             coordinates_of(solution.grid));
  text += "</Points>\n<Cells>\n";
  text += arrays.add<std::int64_t>("type=\"Int64\" Name=\"connectivity\"", cells.corners);
  text += arrays.add<std::int64_t>("type=\"Int64\" Name=\"offsets\"", ends);
  text += arrays.add<std::uint8_t>("type=\"UInt8\" Name=\"types\"", types);
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  text += arrays.data();
  return text + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace point_contact
