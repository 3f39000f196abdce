// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/exports.hpp"

#include <fmt/core.h>

#include <ostream>

#include <string>
#include <string_view>
#include <vector>

#include "system/require.hpp"

namespace block {
namespace {

// Writes a line for each point, which `write` makes of the point's state.
template <class Write>
void write_point_array(std::ostream& out, const std::vector<PointState>& states,
                       std::string_view attributes, Write write) {
  out << fmt::format("<DataArray type=\"Float64\" {} format=\"ascii\">\n", attributes);
  for (const PointState& state : states) write(state);
  out << "</DataArray>\n";
}

void write_points(std::ostream& out, const std::vector<PointState>& states) {
  out << "<Points>\n";
  write_point_array(out, states, "NumberOfComponents=\"3\"", [&](const PointState& s) {
    out << fmt::format("{:.9g} {:.9g} 0\n", s.position.x(), 0.0 - s.position.y());
  });
  out << "</Points>\n";
}

void write_point_data(std::ostream& out, const std::vector<PointState>& states) {
  out << "<PointData Vectors=\"displacement\" Scalars=\"von_mises\">\n";
  write_point_array(
      out, states, "Name=\"displacement\" NumberOfComponents=\"3\"", [&](const PointState& s) {
        out << fmt::format("{:.9g} {:.9g} 0\n", s.displacement.x(), 0.0 - s.displacement.y());
      });
  write_point_array(out, states, "Name=\"stress\" NumberOfComponents=\"6\"",
                    [&](const PointState& s) {
                      out << fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} 0 0\n", s.stress.xx,
                                         s.stress.zz, s.stress.yy, 0.0 - s.stress.xz);
                    });
  write_point_array(out, states, "Name=\"von_mises\"", [&](const PointState& s) {
    out << fmt::format("{:.9g}\n", von_mises(s.stress));
  });
  out << "</PointData>\n";
}

void write_cells(std::ostream& out, Index n_elements, Index n_cells) {
  const Index n_points = n_cells + 1;
  out << "<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (Index e = 0; e < n_elements; ++e) {
    for (Index j = 0; j < n_cells; ++j) {
      for (Index i = 0; i < n_cells; ++i) {
        // The corners follow each other counter-clockwise as one sees them with y up; each row of
        // points lies below the last
        const Index corner = (e * n_points + j) * n_points + i;
        out << fmt::format("{} {} {} {}\n", corner + n_points, corner + n_points + 1, corner + 1,
                           corner);
      }
    }
  }
  constexpr int vtk_quad = 9;
  const Index n_all = n_elements * n_cells * n_cells;
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (Index k = 1; k <= n_all; ++k) out << fmt::format("{}\n", 4 * k);
  out << "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for (Index k = 0; k < n_all; ++k) out << fmt::format("{}\n", vtk_quad);
  out << "</DataArray>\n</Cells>\n";
}

}  // namespace

void write_vtu(std::ostream& out, const Solution& solution, int n_cells) {
  if (n_cells > 100) throw sys::InvalidQuantity("n_cells", n_cells, "100 or less");
  const Mesh& mesh = solution.model().mesh();
  if (n_cells <= 0) n_cells = mesh.order();

  // Sample every element on its grid of points
  std::vector<PointState> states;
  const auto grid = Eigen::VectorXd::LinSpaced(n_cells + 1, -1, 1);
  for (Index e = 0; e < mesh.n_elements(); ++e) {
    const std::vector<PointState> sampled = solution.sample(e, grid);
    states.insert(states.end(), sampled.begin(), sampled.end());
  }

  out << fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      states.size(), mesh.n_elements() * n_cells * n_cells);
  write_points(out, states);
  write_point_data(out, states);
  write_cells(out, mesh.n_elements(), n_cells);
  out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace block
