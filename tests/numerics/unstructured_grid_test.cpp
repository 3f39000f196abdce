// SPDX-License-Identifier: GPL-3.0-or-later
// The file is read back by its own header: attributes from the XML, which a parser of XML reads
// once the appended data are cut off, and numbers from these data.
#include "numerics/unstructured_grid.hpp"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <sstream>

BOOST_AUTO_TEST_SUITE(unstructured_grid_test)

using numerics::UnstructuredGrid;

namespace {

// Two quadrilaterals side by side.
const UnstructuredGrid quadrilaterals{.points = {0, 0, 0, 1, 0, 0, 2, 0, 0,  //
                                                 0, 1, 0, 1, 1, 0, 2, 1, 1.0 / 3},
                                      .n_corners = 4,
                                      .corners = {0, 1, 4, 3, 1, 2, 5, 4},
                                      .fields = {{"gap", 1, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}},
                                                 {"shift", 2, std::vector<double>(12, 0.7)}}};

const UnstructuredGrid triangle{
    .points = {0, 0, 0, 1, 0, 0, 0, 1, 0}, .n_corners = 3, .corners = {0, 1, 2}, .fields = {}};

struct File {
  explicit File(const UnstructuredGrid& grid) : text(vtu(grid)) {
    const std::size_t appended = text.find("<AppendedData encoding=\"raw\">\n_");
    std::istringstream xml(text.substr(0, appended) + "</VTKFile>");
    boost::property_tree::ptree tree;
    read_xml(xml, tree);  // throws unless well-formed
    piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");
    data = text.substr(text.find("\n_", appended) + 2);
  }

  // The numbers of an array.
  template <class Number>
  std::vector<Number> array(const std::string& parent, const std::string& name) const {
    for (const auto& [tag, element] : piece.get_child(parent)) {
      if (element.get("<xmlattr>.Name", std::string()) != name) continue;
      const auto offset = element.template get<std::size_t>("<xmlattr>.offset");
      std::uint64_t n_bytes = 0;
      std::memcpy(&n_bytes, data.data() + offset, sizeof n_bytes);
      std::vector<Number> numbers(n_bytes / sizeof(Number));
      std::memcpy(numbers.data(), data.data() + offset + sizeof n_bytes, n_bytes);
      return numbers;
    }
    throw std::out_of_range(name);
  }

  std::string text, data;
  boost::property_tree::ptree piece;
};

}  // namespace

BOOST_AUTO_TEST_CASE(points_cells_and_fields_come_back_with_every_bit) {
  const File file(quadrilaterals);

  BOOST_TEST(file.piece.get<int>("<xmlattr>.NumberOfPoints") == 6);
  BOOST_TEST(file.piece.get<int>("<xmlattr>.NumberOfCells") == 2);
  BOOST_TEST(file.array<double>("Points", "points") == quadrilaterals.points);
  BOOST_TEST(file.array<std::int64_t>("Cells", "connectivity") == quadrilaterals.corners);
  BOOST_TEST(file.array<double>("PointData", "gap") == quadrilaterals.fields[0].values);
  BOOST_TEST(file.array<double>("PointData", "shift") == quadrilaterals.fields[1].values);
}

BOOST_AUTO_TEST_CASE(each_cell_has_its_end_and_the_type_of_its_corners) {
  const auto ends = [](const UnstructuredGrid& grid) {
    return File(grid).array<std::int64_t>("Cells", "offsets");
  };
  const auto types = [](const UnstructuredGrid& grid) {
    return File(grid).array<std::uint8_t>("Cells", "types");
  };

  BOOST_TEST((ends(quadrilaterals) == std::vector<std::int64_t>{4, 8}));
  BOOST_TEST((types(quadrilaterals) == std::vector<std::uint8_t>{9, 9}));  // VTK's number of a quad
  BOOST_TEST((ends(triangle) == std::vector<std::int64_t>{3}));
  BOOST_TEST((types(triangle) == std::vector<std::uint8_t>{5}));  // and of a triangle
}

BOOST_AUTO_TEST_SUITE_END()
