// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands print.
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(command_line_test)

namespace {

using nlohmann::json;

const Words papers_load = {"--young", "30e6",         "--poisson", "0.3",     "--peak-pressure",
                           "1000",    "--half-width", "0.01",      "--datum", "10"};
const Words papers_points = {"--x", "0,0.005,0.01,0.015,0.02,0.025,0.03,0.035,0.04,0.045,0.05"};
const Words papers_contact = {"--load",   "2500",     "--radius1",  "1",          "--radius2",
                              "3",        "--young1", "30e6",       "--poisson1", "0.3",
                              "--young2", "30e6",     "--poisson2", "0.3"};

const Words displacement = Words{"displacement"} + papers_load;
const Words contact = Words{"contact"} + papers_contact + Words{"--nodes", "41"};
const Words fine_contact = Words{"contact"} + papers_contact + Words{"--nodes", "91"};
const Words csv = {"--format", "csv"};
const Words as_json = {"--format", "json"};

double number_of(std::string_view text) {
  double number = 0;
  const char* end = text.data() + text.size();
  BOOST_TEST_REQUIRE((std::from_chars(text.data(), end, number).ptr == end), text);
  return number;
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

// The rows of a csv under their header, as numbers.
std::vector<std::vector<double>> numbers_in(const std::string& text) {
  std::vector<std::vector<double>> rows;
  for (const std::string_view line : sys::lines_of(text)) {
    rows.emplace_back();
    if (rows.size() == 1) continue;
    for (const std::string& cell : cells_of(line)) rows.back().push_back(number_of(cell));
  }
  rows.erase(rows.begin());
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_CASE(displacement_prints_the_promised_header_and_a_row_a_point) {
  const std::string text = output_of(displacement + Words{"--x", "0,0.005,0.01"} + csv);
  const auto lines = sys::lines_of(text);

  BOOST_TEST_REQUIRE(lines.size() == 4U);
  BOOST_TEST(lines[0] ==
             "x,gradient_quadrature,gradient_abs_error,gradient_closed_form,"
             "displacement_quadrature,displacement_abs_error,displacement_closed_form");
  BOOST_TEST(lines[1].starts_with("0,"));
  BOOST_TEST(lines[2].starts_with("0.005,"));
  BOOST_TEST(lines[3].starts_with("0.01,"));
}

BOOST_AUTO_TEST_CASE(displacement_prints_the_papers_digits) {
  // Ruggiero (2001), Appendix 1, output of Tri_dist.m. The third was taken at x = 0.01 + 1e-7.
  const Words printed = {"1.6236048e-06", "1.5187874e-06", "",
                         "1.2635610e-06", "1.2043351e-06", "1.1596620e-06",
                         "1.1236214e-06", "1.0933600e-06", "1.0672569e-06",
                         "1.0442961e-06", "1.0237964e-06"};

  const auto rows = numbers_in(output_of(displacement + papers_points + csv));

  BOOST_TEST_REQUIRE(rows.size() == printed.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (printed[i].empty()) continue;
    BOOST_TEST(fmt::format("{:.7e}", rows[i][4]) == printed[i]);
    BOOST_TEST(fmt::format("{:.7e}", rows[i][6]) == printed[i]);
  }
  const auto stepped = numbers_in(output_of(displacement + Words{"--x", "0.0100001"} + csv));
  BOOST_TEST(fmt::format("{:.7e}", stepped.at(0)[6]) == "1.3558976e-06");
}

BOOST_AUTO_TEST_CASE(quadrature_and_closed_form_differ_by_less_than_the_printed_error) {
  const Words points = {"--x", "-1e3,-0.01,-0.003,0,1e-12,0.0099999999,0.01,0.010000001,0.7,1e4"};
  for (const auto& row : numbers_in(output_of(displacement + points + csv))) {
    BOOST_TEST(std::abs(row[1] - row[3]) <= row[2], "at x = " << row[0]);
    BOOST_TEST(std::abs(row[4] - row[6]) <= row[5], "at x = " << row[0]);
  }
}

BOOST_AUTO_TEST_CASE(any_load_agrees_with_its_closed_form_and_the_table_says_so) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("load.csv", "x,pressure\n-0.02,0\n-0.01,900\n0.003,400\n0.01,0\n").string();
  const std::string other =
      folder.write("other.csv", "x,pressure\n-0.01,0\n-0.004,800\n0.003,500\n0.01,0\n").string();
  const Words points = {"--x", "-0.02,-0.01,-0.002,0,0.003,0.0099,0.01,0.04"};
  for (const Words& load : {Words{"--shape", "elliptic"}, Words{"--shape", "parabolic"},
                            Words{"--shape", "file:" + file}, Words{"--shape", "file:" + other},
                            Words{"--shape", "parabolic", "--component", "tangential"}}) {
    const Words command = {"displacement", "--case", papers_case.string()};
    const std::string table = output_of(command + load + points);
    BOOST_TEST(table.find("8 of 8 points agree within their errors; ") != std::string::npos, table);
    BOOST_TEST(table.find("closed form: ") != std::string::npos);
    BOOST_TEST(numbers_in(output_of(command + load + points + csv)).size() == 8U);
  }
}

BOOST_AUTO_TEST_CASE(a_formula_needs_no_points_and_has_no_closed_form) {
  const Words command = {"displacement", "--young",         "30e6", "--poisson",
                         "0.3",          "--datum",         "10",   "--half-width",
                         "0.01",         "--peak-pressure", "1000", "--shape"};
  const std::string text = output_of(command + Words{"expression:p0*(1-(x/a)^2)"} + csv);
  const auto rows = numbers_in(text);

  BOOST_TEST(sys::lines_of(text).front() ==
             "x,gradient_quadrature,gradient_abs_error,displacement_quadrature,"
             "displacement_abs_error");
  BOOST_TEST_REQUIRE(rows.size() == 7U);
  const auto parabola = numbers_in(
      output_of(command + Words{"parabolic", "--x", "-0.02,-0.01,-0.005,0,0.005,0.01,0.02"} + csv));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    BOOST_TEST(std::abs(rows[i][1] - parabola[i][3]) <= rows[i][2] + 1e-19);
    BOOST_TEST(std::abs(rows[i][3] - parabola[i][6]) <= rows[i][4] + 1e-21);
  }
}

BOOST_AUTO_TEST_CASE(csv_and_json_carry_the_same_doubles) {
  const std::string csv_text = output_of(displacement + papers_points + csv);
  const json rows = json::parse(output_of(displacement + papers_points + as_json));
  const auto names = cells_of(sys::lines_of(csv_text).front());
  const auto numbers = numbers_in(csv_text);

  BOOST_TEST_REQUIRE(rows.size() == numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    BOOST_TEST(rows[i].size() == names.size());
    for (std::size_t j = 0; j < names.size(); ++j) {
      BOOST_TEST(rows[i].at(names[j]).get<double>() == numbers[i][j]);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_number_of_the_csv_has_the_fewest_digits) {
  const std::string text = output_of(displacement + papers_points + csv);
  const auto lines = sys::lines_of(text);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    for (const std::string& cell : cells_of(lines[i])) {
      BOOST_TEST(cell == fmt::format("{}", number_of(cell)));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_table_is_the_default_aligned_and_has_units) {
  const std::string text = output_of(displacement + papers_points);
  const auto lines = sys::lines_of(text);

  BOOST_TEST_REQUIRE(lines.size() == 3U + 11U + 2U);
  for (std::size_t i = 0; i < 14; ++i) BOOST_TEST(lines[i].size() == lines[0].size());
  BOOST_TEST(lines[2].find("[in]") != std::string_view::npos);
  BOOST_TEST(lines[4].find("1.518787362762e-06") != std::string_view::npos);
  // The last line tells the time that it took.
  const std::string given = output_of(displacement + papers_points + Words{"--format", "table"});
  BOOST_TEST(given.substr(0, given.rfind(", ")) == text.substr(0, text.rfind(", ")));
  const std::string metric = output_of(displacement + papers_points + Words{"--units", "mm-N"});
  BOOST_TEST(metric.find("[mm]") != std::string::npos);
  BOOST_TEST(metric.find("[in]") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(points_come_from_a_list_a_file_or_standard_input_alike) {
  const TemporaryFolder folder;
  const auto file = folder.write("my points.txt", "# in\n-0.005\n\n0\n 0.01\n");
  const std::string from_list = output_of(displacement + Words{"--x", "-0.005,0,0.01"} + csv);

  BOOST_TEST(output_of(displacement + Words{"--x-file", file.string()} + csv) == from_list);
  BOOST_TEST(output_of(displacement + Words{"--x-file", "-"} + csv,
                       {.input = "-0.005\n0\n0.01\n"}) == from_list);
}

BOOST_AUTO_TEST_CASE(a_case_gives_what_the_flags_leave_out) {
  const Words from_case = {"displacement", "--case", papers_case.string()};
  const std::string by_flags = output_of(displacement + papers_points + csv);

  // The case's points are first + i·step: the same numbers but for their last bits.
  const auto case_rows = numbers_in(output_of(from_case + csv));
  const auto flag_rows = numbers_in(by_flags);
  BOOST_TEST_REQUIRE(case_rows.size() == 11U);
  for (std::size_t i = 0; i < 11; ++i) {
    BOOST_TEST(case_rows[i][6] == flag_rows[i][6], boost::test_tools::tolerance(1e-14));
  }
  BOOST_TEST(output_of(from_case + papers_points + csv) == by_flags);
}

BOOST_AUTO_TEST_CASE(flags_override_the_case) {
  const Words from_case = {"displacement", "--case", papers_case.string(), "--x", "0.005"};
  const auto by = [&](const Words& more) {
    return numbers_in(output_of(from_case + more + csv)).at(0)[6];
  };
  const double papers = by({});
  const auto close = boost::test_tools::tolerance(1e-13);

  BOOST_TEST(by({"--young", "60e6"}) == papers / 2, close);
  BOOST_TEST(by({"--peak-pressure", "3000"}) == papers * 3, close);
  BOOST_TEST(by({"--poisson", "0"}) == papers / (1 - 0.3 * 0.3), close);
  // A datum ten times as far adds 2(1−ν²)p0 a ln 10/(πE), all but exactly.
  const double shift = 2 * 0.91 * 10 * std::log(10.0) / (std::acos(-1.0) * 30e6);
  BOOST_TEST(by({"--datum", "100"}) == papers + shift, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(by({"--half-width", "0.005", "--datum", "5"}) != papers);
}

BOOST_AUTO_TEST_CASE(a_case_in_other_units_prints_in_them) {
  const std::string table = output_of({"displacement", "--case", steel_case.string()});
  BOOST_TEST(table.find("[mm]") != std::string::npos);
  BOOST_TEST(sys::lines_of(table).size() == 3U + 9U + 2U);

  const std::string contact_table = output_of({"contact", "--case", steel_case.string()});
  for (const char* unit : {" mm", " MPa", " N/mm"}) {
    BOOST_TEST(contact_table.find(unit) != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(uniform_and_concentrated_loads_agree_with_theirs_in_closed_form) {
  const Words from_case = {"displacement", "--case", papers_case.string()};
  for (const Words& shape :
       {Words{"--shape", "uniform"}, Words{"--shape", "concentrated", "--line-load", "10"},
        Words{"--component", "tangential"}}) {
    const auto rows =
        numbers_in(output_of(from_case + shape + Words{"--x", "-0.02,0.003,0.7"} + csv));
    BOOST_TEST_REQUIRE(rows.size() == 3U);
    for (const auto& row : rows) {
      BOOST_TEST(std::abs(row[1] - row[3]) <= row[2] + 1e-15 * std::abs(row[3]));
      BOOST_TEST(std::abs(row[4] - row[6]) <= row[5] + 1e-15 * std::abs(row[6]));
      BOOST_TEST(row[6] != 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(contact_prints_the_promised_keys) {
  const json result = json::parse(output_of(contact + as_json));

  for (const char* key : {"half_width", "peak_pressure", "load", "nodes", "x", "pressure"}) {
    BOOST_TEST(result.contains(key), key);
  }
  BOOST_TEST(result.at("nodes") == 41);
  BOOST_TEST(result.at("x").size() == 41U);
  BOOST_TEST(result.at("pressure").size() == 41U);
  BOOST_TEST(result.at("load").get<double>() == 2500, boost::test_tools::tolerance(1e-13));
  // a = √(4PR/(πE*)) = 0.012035 in, p0 = 2P/(πa) = 132248 psi (Johnson 4.43, 4.45).
  BOOST_TEST(fmt::format("{:.6f}", result.at("hertz").at("half_width").get<double>()) ==
             "0.012035");
  BOOST_TEST(fmt::format("{:.0f}", result.at("hertz").at("peak_pressure").get<double>()) ==
             "132248");
}

BOOST_AUTO_TEST_CASE(contact_on_forty_elements_agrees_with_hertz) {
  const json result = json::parse(output_of(fine_contact + as_json));
  const json& hertz = result.at("hertz");
  const auto relative_error = [&](const char* key) {
    return std::abs(result.at(key).get<double>() / hertz.at(key).get<double>() - 1);
  };

  BOOST_TEST(relative_error("peak_pressure") < 1e-4);
  BOOST_TEST(relative_error("half_width") < 2e-4);
}

BOOST_AUTO_TEST_CASE(contact_prints_the_same_pressures_as_csv_and_json) {
  const std::string text = output_of(contact + csv);
  const json result = json::parse(output_of(contact + as_json));
  const auto rows = numbers_in(text);

  BOOST_TEST(text.starts_with("x,pressure,"));
  BOOST_TEST_REQUIRE(rows.size() == 41U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    BOOST_TEST(result.at("x").at(i).get<double>() == rows[i][0]);
    BOOST_TEST(result.at("pressure").at(i).get<double>() == rows[i][1]);
  }
}

BOOST_AUTO_TEST_CASE(contact_takes_planes_hollows_and_a_case) {
  const Words from_case = {"contact", "--case", papers_case.string()};
  const auto hertz = [&](const Words& more) {
    return json::parse(output_of(from_case + more + as_json))
        .at("hertz")
        .at("half_width")
        .get<double>();
  };
  const double papers = hertz({});
  const auto close = boost::test_tools::tolerance(1e-14);

  // a ∝ √R with 1/R = 1/R1 + 1/R2: 4/3 for the paper, 1 on a plane, 1/2 in a hollow of −2.
  BOOST_TEST(hertz({"--radius2", "plane"}) == papers * std::sqrt(4.0 / 3), close);
  BOOST_TEST(hertz({"--radius2", "-2"}) == papers * std::sqrt(4.0 / 3 * 2), close);
  BOOST_TEST(hertz({"--load", "10000"}) == papers * 2, close);
  BOOST_TEST(json::parse(output_of(from_case + as_json)).contains("approach"));
  BOOST_TEST(!json::parse(output_of(contact + as_json)).contains("approach"));
}

BOOST_AUTO_TEST_CASE(block_prints_units_and_the_seconds_it_took) {
  const std::string text =
      output_of({"block", "--case", papers_case.string(), "--order", "2", "--refine", "0"});
  const auto lines = sys::lines_of(text);
  const auto ends = [&](std::string_view measure, std::string_view unit) {
    for (const std::string_view line : lines) {
      if (line.starts_with(measure)) return line.ends_with(unit);
    }
    return false;
  };

  BOOST_TEST(ends("resultant_load_y ", " lbf/in"));
  BOOST_TEST(ends("max_disp_mag ", " in"));
  BOOST_TEST(ends("max_rot_z ", " 1"));
  BOOST_TEST(ends("max_stress_vm ", " psi"));
  BOOST_TEST(ends("strain_energy ", " lbf"));
  BOOST_TEST(ends("measure11 ", " in"));
  BOOST_TEST(lines.back().starts_with("seconds: elements "));
  for (const char* stage : {"assembly", "factorisation", "solution"}) {
    BOOST_TEST(lines.back().find(stage) != std::string_view::npos);
  }
}

BOOST_AUTO_TEST_CASE(version_names_the_commit_and_help_every_command) {
  BOOST_TEST(output_of({"--version"}).starts_with("halfspace "));
  BOOST_TEST(output_of({"--version"}).find("commit ") != std::string::npos);
  const std::string help = output_of({"--help"});
  for (const char* command : {"displacement", "contact", "point-contact", "stress", "block"}) {
    BOOST_TEST(help.find(command) != std::string::npos);
    BOOST_TEST(output_of({command, "--help"}).find("--") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(locale_and_folder_change_nothing) {
  const TemporaryFolder folder;
  const std::string here = output_of(displacement + papers_points + csv);

  BOOST_TEST(output_of(displacement + papers_points + csv,
                       {.environment = {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "tr_TR.UTF-8"}},
                        .folder = folder.path(),
                        .umask = "077"}) == here);
}

BOOST_AUTO_TEST_SUITE_END()
