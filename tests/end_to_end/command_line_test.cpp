// SPDX-License-Identifier: GPL-3.0-or-later
// Behaviour common to all commands: help, units, ranges, cases and formats; and the output of
// `displacement` and `block`.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <charconv>
#include <filesystem>
#include <string>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(command_line_test)

namespace {

namespace fs = std::filesystem;

const Words paper = {"displacement", "--case", papers_case.string()};
const Words strip = words_of("displacement --shape uniform --peak-pressure 100 --half-width 1");
const Words block = words_of(
    "block --order 4 --refine 1 --width 50 --height 25 --peak-pressure 100 --half-width 1");
const Words names = {"displacement", "contact", "point-contact", "stress", "block"};

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    const auto is_first_byte = [](char c) { return (c & 0xC0) != 0x80; };  // of a character
    const auto n = std::ranges::count_if(line, is_first_byte);
    longest = std::max(longest, static_cast<std::size_t>(n));
  }
  return longest;
}

// The fewest digits that read back as the same double.
std::string shortest(double number) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + 32, number).ptr};
}

}  // namespace

BOOST_AUTO_TEST_CASE(help_fits_eighty_columns_and_contains_the_words_that_engineers_search_for) {
  std::string helps = output_of({"--help"});
  for (const std::string& name : names) {
    BOOST_TEST(helps.find(name) != std::string::npos);
    helps += output_of({name, "--help"});
  }
  BOOST_TEST(longest_line(helps) <= 80U);
  for (const char* word : {"Hertz", "strip", "cylinder", "210GPa", "BEGIN:END:STEP", "mm-N"}) {
    BOOST_TEST(helps.find(word) != std::string::npos, word);
  }
  BOOST_TEST(output_of({"--version"}).starts_with("halfspace 0."));
}

BOOST_AUTO_TEST_CASE(each_help_has_three_examples_that_run) {
  const TemporaryFolder folder;
  folder.write("gap.csv", "x,gap\n-0.2,0.004\n-0.1,0.001\n0,0\n0.1,0.001\n0.2,0.004\n");
  folder.write("map.csv", "0,0,0,0,0\n0,8,9,8,0\n0,9,10,9,0\n0,8,9,8,0\n0,0,0,0,0\n");
  fs::create_directories(folder.path() / "report");
  fs::copy(papers_case, folder.path() / "report");
  constexpr const char* script = R"sh(PATH=$(dirname "$1"):$PATH
    halfspace "$2" --help | sed -n '/^Examples:/,$s/^    //p' >examples
    test "$(grep -c ^halfspace examples)" = 3 && sh -e examples >answers)sh";
  for (const std::string& name : names) {
    const auto result = run_shell(script, {HALFSPACE_PROGRAM, name}, folder.path());
    BOOST_TEST(result.exit_status == 0, name << ": " << result.output);
  }
}

BOOST_AUTO_TEST_CASE(output_fits_eighty_columns_in_every_system_of_units) {
  for (const char* command :
       {"displacement --peak-pressure 1e9 --half-width 1e-3 --units m-N",
        "displacement --peak-pressure 123456 --half-width 1e-3 --units in-lbf --component "
        "tangential",
        "contact --radius1 0.01 --load 1e5 --units m-N --young1 7e10 --poisson1 0.3 --datum 0.5",
        "point-contact --radius1 0.01 --load 1e5 --units m-N --nodes 64",
        "stress --shape uniform --peak-pressure 1e9 --half-width 1e-3 --units m-N",
        "stress --radius1 0.4 --load 5000 --units in-lbf --x -0.001234567",
        "block --order 4 --refine 1 --width 2 --height 1 --peak-pressure 1e9 --half-width 0.01 "
        "--units m-N"}) {
    BOOST_TEST(longest_line(run_program(words_of(command)).output) <= 80U, command);
  }
}

BOOST_AUTO_TEST_CASE(a_quantity_is_the_same_in_every_unit) {
  const std::string plain =
      output_of(strip + words_of("--young 210000 --poisson 0.3 --format csv"));
  for (const char* young : {"210GPa", "210 GPa", "2.1e5 N/mm2", "+210e9Pa", "0.21 TPa"}) {
    BOOST_TEST(output_of(strip + Words{"--young", young} +
                         words_of("--poisson 0.3 --format csv")) == plain,
               young);
  }
  BOOST_TEST(output_of(strip + words_of("--format csv")) == plain);  // steel by default

  const json metric = json_of(words_of("contact --radius1 10 --load 100"));
  const json inches = json_of(words_of("contact --units in-lbf --radius1 10mm --load 100N/mm"));
  BOOST_TEST(relative_difference(inches.at("half_width").get<double>() * 25.4,
                                 metric.at("half_width").get<double>()) < 1e-12);
  BOOST_TEST(metric.at("units").at("half_width") == "mm");
  BOOST_TEST(inches.at("units").at("peak_pressure") == "psi");
}

BOOST_AUTO_TEST_CASE(ranges_have_both_ends_and_decimal_steps) {
  const auto x = [](const char* list) { return csv_of(strip + Words{"--x", list}).at("x"); };

  BOOST_TEST(x("0:0.7:0.1") == (Words{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7"}),
             boost::test_tools::per_element());
  BOOST_TEST(x("-0.3:0.3:0.1") == (Words{"-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"}),
             boost::test_tools::per_element());
  BOOST_TEST(x("3:1:-0.75") == (Words{"3", "2.25", "1.5"}), boost::test_tools::per_element());
  BOOST_TEST(x("0,2:3:0.5,7") == (Words{"0", "2", "2.5", "3", "7"}),
             boost::test_tools::per_element());
  BOOST_TEST(x("0,5mm,1:2:1cm") == (Words{"0", "5", "10", "20"}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(displacement_prints_the_digits_of_the_paper) {
  // Ruggiero (2001), Appendix 1, output of Tri_dist.m. The third was taken at x = 0.01 + 1e-7.
  const Words printed = {"1.6236048e-06", "1.5187874e-06", "1.3558976e-06", "1.2635610e-06",
                         "1.2043351e-06", "1.1596620e-06", "1.1236214e-06", "1.0933600e-06",
                         "1.0672569e-06", "1.0442961e-06", "1.0237964e-06"};
  const Columns columns = csv_of(paper + words_of("--x 0,0.005,0.0100001,0.015:0.05:0.005"));

  for (const char* way : {"displacement_quadrature", "displacement_closed_form"}) {
    const auto& numbers = columns.at(way);
    BOOST_TEST_REQUIRE(numbers.size() == printed.size());
    for (std::size_t i = 0; i < printed.size(); ++i) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.7e", number(numbers[i]));
      BOOST_TEST(digits == printed[i]);
    }
  }
}

BOOST_AUTO_TEST_CASE(quadrature_and_closed_form_differ_by_less_than_the_printed_error) {
  for (const char* load : {"--shape triangular", "--shape uniform", "--shape linear:0.6",
                           "--component tangential", "--shape concentrated --line-load 10"}) {
    const Columns columns = csv_of(paper + words_of(load) +
                                   words_of("--x=-1e3,-0.011,-0.003,1e-12,0.0099999999,0.7,1e4"));
    for (const std::string name : {"gradient", "displacement"}) {
      const auto& closed = columns.at(name + "_closed_form");
      for (std::size_t i = 0; i < closed.size(); ++i) {
        const double exact = number(closed[i]);
        const double error = number(columns.at(name + "_abs_error")[i]);
        BOOST_TEST(std::abs(number(columns.at(name + "_quadrature")[i]) - exact) <=
                       error + 1e-15 * std::abs(exact),
                   load << ", " << name << " " << i);
      }
    }
    BOOST_TEST(output_of(paper + words_of(load) + words_of("--x 0.003,0.7"))
                   .find("2 of 2 points agree within their errors") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(a_file_a_formula_and_a_name_can_give_the_same_load) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("load.csv", "# MPa\nx,pressure\n-2,0\n0,50\n2,0\n").string();
  const Words points = words_of("--x -3,-2,-0.7,0,1.1,2,9 --datum 20");
  const Words numbers = words_of("--peak-pressure 50 --half-width 2");
  const auto by = [&](const Words& load) {
    return csv_of(Words{"displacement"} + load + points).at("displacement_quadrature");
  };

  const auto named = by(numbers);
  for (const auto& other : {by({"--shape", "file:" + file}),
                            by(numbers + Words{"--shape", "expression:p0*(1-abs(x)/a)"})}) {
    for (std::size_t i = 0; i < named.size(); ++i) {
      BOOST_TEST(relative_difference(number(other[i]), number(named[i])) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(at_the_edge_of_a_strip_the_displacement_is_finite_and_the_gradient_infinite) {
  const Words edges = strip + words_of("--x -1,1 --datum 10");
  const Columns columns = csv_of(edges);
  const json rows = json_of(edges);

  BOOST_TEST(columns.at("gradient_quadrature")[0] == "inf");
  BOOST_TEST(columns.at("gradient_closed_form")[1] == "-inf");
  BOOST_TEST(rows.at(0).at("gradient_quadrature").is_null());
  // 2(1−ν²)p0 a/(πE) [10·… ] by mpmath: 1.4388014667188155e-3 mm.
  for (const json& row : rows) {
    BOOST_TEST(relative_difference(row.at("displacement_quadrature").get<double>(),
                                   1.4388014667188155e-3) < 1e-14);
    BOOST_TEST(row.at("units").at("displacement") == "mm");
  }
  const std::string text =
      output_of(strip + words_of("--x -1,1"));  // the same datum is the default
  BOOST_TEST(text.find("1.43880147") != std::string::npos);
  BOOST_TEST(text.find("u_z = 0 at x = 10 mm") != std::string::npos);
  BOOST_TEST(text.find("-infinite") != std::string::npos);
  const json force =
      json_of(words_of("displacement --shape concentrated --line-load 9 --x 0 --datum 1"));
  BOOST_TEST(force.at(0).at("displacement_quadrature").is_null());
}

BOOST_AUTO_TEST_CASE(csv_and_json_have_the_same_doubles_with_the_fewest_digits) {
  const Columns columns = csv_of(paper);
  const json rows = json_of(paper);

  BOOST_TEST(columns.size() == 7U);
  BOOST_TEST_REQUIRE(rows.size() == 11U);
  for (const auto& [name, cells] : columns) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      BOOST_TEST(rows[i].at(name).get<double>() == number(cells[i]));
      BOOST_TEST(cells[i] == shortest(number(cells[i])));
    }
  }
}

BOOST_AUTO_TEST_CASE(flags_override_the_case) {
  const auto by = [&](const Words& more) {
    return number(csv_of(paper + words_of("--x 0.005") + more).at("displacement_closed_form")[0]);
  };
  const double papers = by({});

  BOOST_TEST(relative_difference(by(words_of("--young 60e6")), papers / 2) < 1e-13);
  BOOST_TEST(relative_difference(by(words_of("--peak-pressure 3000")), papers * 3) < 1e-13);
  BOOST_TEST(relative_difference(by(words_of("--poisson 0")), papers / (1 - 0.3 * 0.3)) < 1e-13);
  BOOST_TEST(by(words_of("--datum 100")) > papers);
}

BOOST_AUTO_TEST_CASE(a_case_needs_only_the_table_that_the_command_reads) {
  const TemporaryFolder folder;
  const std::string text = sys::read_file(papers_case);
  const auto table = [&](const std::string& begin, const std::string& end) {
    const auto at = text.find("\n[" + begin + "]");
    return text.substr(at, text.find("\n[" + end + "]") - at);
  };
  const std::string units = "units = \"in-lbf\"\n";
  const auto same = [&](const Words& command, const std::string& own) {
    const std::string file = folder.write("own.toml", units + own).string();
    return output_of(command + Words{"--case", file, "--format", "csv"}) ==
           output_of(command + Words{"--case", papers_case.string(), "--format", "csv"});
  };
  const std::string half_space = table("half_space", "contact");

  BOOST_TEST(same({"displacement"}, half_space));
  BOOST_TEST(same({"contact"}, table("contact", "point_contact")));
  BOOST_TEST(same(words_of("block --order 4 --refine 1"), half_space + table("block", "printed")));
}

BOOST_AUTO_TEST_CASE(block_prints_a_value_an_error_and_a_unit_for_each_measure) {
  const json measures = json_of(block + words_of("--x 0,3")).at("measures");
  const auto unit = [&](const char* name) { return measures.at(name).at("unit"); };

  BOOST_TEST(relative_difference(measures.at("resultant_load_y").at("value").get<double>(), -100) <
             1e-12);
  BOOST_TEST(unit("resultant_load_y") == "N/mm");
  BOOST_TEST(unit("max_disp_mag") == "mm");
  BOOST_TEST(unit("max_stress_vm") == "MPa");
  BOOST_TEST(unit("strain_energy") == "N");
  BOOST_TEST(unit("measure2") == "mm");
  BOOST_TEST(measures.at("measure2").at("abs_error").get<double>() > 0);
  // At the edges of a strip load stresses have no limit; under a triangle they have one.
  BOOST_TEST(json_of(block + words_of("--sides roller")).at("left_out").empty());
  const json strip_load = json_of(block + words_of("--sides roller --shape uniform"));
  BOOST_TEST(strip_load.at("left_out").at(1).at("x") == 1);
  // A softer block, and one with free sides, is displaced more.
  const auto largest = [&](const char* more) {
    return json_of(block + words_of(more))
        .at("measures")
        .at("max_disp_mag")
        .at("value")
        .get<double>();
  };
  BOOST_TEST(relative_difference(largest("--young 105GPa --poisson 0.3"), 2 * largest("")) < 1e-9);
  BOOST_TEST(largest("--sides free") > largest("--sides roller"));
  BOOST_TEST(largest("--sides roller") > largest("--sides clamped"));
}

BOOST_AUTO_TEST_CASE(locale_and_folder_do_not_change_the_output) {
  const TemporaryFolder folder;
  const Words command = strip + words_of("--format csv");

  BOOST_TEST(
      output_of(command, {.environment = {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "tr_TR.UTF-8"}},
                          .folder = folder.path()}) == output_of(command));
}

BOOST_AUTO_TEST_SUITE_END()
