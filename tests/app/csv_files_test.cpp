// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/csv_files.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "message_of.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(csv_files_test)

using app::read_grid;

BOOST_AUTO_TEST_CASE(lines_are_rows_along_x) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "map.csv", "# measured\n1, 2,3,4,5\r\n6,7,8,9,10\n\n11,12,13,14,1.5e1\n16,17,18,19,20\n");
  const Eigen::ArrayXXd grid = read_grid(file.string());

  BOOST_TEST(grid.rows() == 5);
  BOOST_TEST(grid.cols() == 4);
  BOOST_TEST(grid(0, 0) == 1);
  BOOST_TEST(grid(1, 0) == 2);
  BOOST_TEST(grid(4, 2) == 15);
  BOOST_TEST(grid(0, 3) == 16);
}

BOOST_AUTO_TEST_CASE(gaps_and_ragged_rows_are_refused_by_file_line_and_column) {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& text, const std::string& reason) {
    const std::string file = folder.write("map.csv", text).string();
    const std::string message = message_of<sys::InputError>([&] { read_grid(file); });
    BOOST_TEST(message.find(file + reason) != std::string::npos, message);
  };
  check("1,2,3,4\n1,2,,4\n1,2,3,4\n1,2,3,4\n", ":2:5: the grid has a gap");
  check("1,2,3,4\n1,2,3,\n1,2,3,4\n1,2,3,4\n", ":2:7: the grid has a gap");
  check("# one\n1,2,3,4\n1,2,3\n1,2,3,4\n1,2,3,4\n", ":3: holds 3 numbers, line 2 holds 4");
  check("1,2,3,4\n1,2,3,4\n1,2,3,4,5\n1,2,3,4\n", ":3: holds 5 numbers, line 1 holds 4");
  check("1,2,3,4\n1,2,low,4\n1,2,3,4\n1,2,3,4\n", ":2:5");
  check("1,2,3,4\n1,2,nan,4\n1,2,3,4\n1,2,3,4\n", ":2:5");
  check("1,2,3,4\n1,2,3,4\n", ": holds 2 lines of 4 numbers, 4 of 4 or more are needed");
  check("", ": holds 0 lines");
  BOOST_TEST(message_of<sys::InputError>([&] {
               read_grid(folder.path().string());
             }).find("is a folder") != std::string::npos);
  BOOST_TEST(message_of<sys::InputError>([] { read_grid("/none.csv"); }).find("/none.csv") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_curve_that_does_not_rise_or_is_too_short_is_refused_by_file_and_line) {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& text, const std::string& reason) {
    const std::string file = folder.write("curve.csv", text).string();
    const std::string message =
        message_of<sys::InputError>([&] { app::read_curve(file, "x", "gap", 3); });
    BOOST_TEST(message == file + reason);
  };
  check("x,gap\n0,1\n# here\n0.5,2\n0.5,3\n",
        ":5: x = 0.5: must be greater than the one before, 0.5");
  check("x,gap\n0,1\n1,2\n", ": holds 2 points, 3 or more are needed");
  check("x,gap\n0,1\n1,high\n2,1\n", ":3: gap: \"high\" is not a number");
}

BOOST_AUTO_TEST_SUITE_END()
