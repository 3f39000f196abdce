// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace numerics {

/// Points, the cells between them, and what is known at each point.
struct UnstructuredGrid {
  struct Field {
    std::string name;
    int n_components;
    std::vector<double> values;  ///< the components of each point in turn
  };

  std::vector<double> points;         ///< x, y and z of each
  int n_corners;                      ///< of every cell: 3 or 4
  std::vector<std::int64_t> corners;  ///< the points of each cell in turn, counter-clockwise
  std::vector<Field> fields;          ///< ParaView shows the first when it opens the file
};

/// The grid as a VTU file (VTK's XML unstructured grid) for ParaView. The numbers follow the XML as
/// they are in memory, with no digit lost.
std::string vtu(const UnstructuredGrid& grid);

}  // namespace numerics
