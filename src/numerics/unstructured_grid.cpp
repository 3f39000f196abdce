// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/unstructured_grid.hpp"

#include <fmt/core.h>

#include <bit>
#include <span>
#include <string_view>

namespace numerics {
namespace {

// The XML names each array with its place in the data that follow it.
class Arrays {
 public:
  // Adds an array and returns the element that names it.
  template <class Number>
  std::string add(std::string_view attributes, const std::vector<Number>& numbers) {
    const std::string element = fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>\n",
                                            attributes, data_.size());
    const std::uint64_t n_bytes = std::span(numbers).size_bytes();
    data_.append(reinterpret_cast<const char*>(&n_bytes), sizeof n_bytes);
    data_.append(reinterpret_cast<const char*>(numbers.data()), n_bytes);
    return element;
  }

  const std::string& data() const { return data_; }

 private:
  std::string data_;
};

}  // namespace

std::string vtu(const UnstructuredGrid& grid) {
  const auto n_corners = static_cast<std::size_t>(grid.n_corners);
  const std::size_t n_cells = grid.corners.size() / n_corners;
  std::vector<std::int64_t> ends(n_cells);
  for (std::size_t k = 0; k < n_cells; ++k) {
    ends[k] = static_cast<std::int64_t>((k + 1) * n_corners);
  }
  constexpr std::uint8_t vtk_triangle = 5;
  constexpr std::uint8_t vtk_quad = 9;
  const std::vector<std::uint8_t> types(n_cells, n_corners == 3 ? vtk_triangle : vtk_quad);

  Arrays arrays;
  constexpr bool is_little = std::endian::native == std::endian::little;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"{}Endian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
      is_little ? "Little" : "Big", grid.points.size() / 3, n_cells);
  for (const UnstructuredGrid::Field& field : grid.fields) {
    text += arrays.add(fmt::format("type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\"",
                                   field.name, field.n_components),
                       field.values);
  }
  text += "</PointData>\n<Points>\n";
  text += arrays.add("type=\"Float64\" Name=\"points\" NumberOfComponents=\"3\"", grid.points);
  text += "</Points>\n<Cells>\n";
  text += arrays.add("type=\"Int64\" Name=\"connectivity\"", grid.corners);
  text += arrays.add("type=\"Int64\" Name=\"offsets\"", ends);
  text += arrays.add("type=\"UInt8\" Name=\"types\"", types);
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  text += arrays.data();
  return text + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace numerics
