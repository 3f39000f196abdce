// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/displacement_table.hpp"

#include <boost/test/unit_test.hpp>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "command_line/options.hpp"

BOOST_AUTO_TEST_SUITE(displacement_table_test)

using app::DisplacementRow;

namespace {

const std::string header =
    "x,gradient_quadrature,gradient_abs_error,gradient_closed_form,displacement_quadrature,"
    "displacement_abs_error,displacement_closed_form";

const std::vector<DisplacementRow> rows = {
    {0, {{-1.5e-18, 2e-17}, 0}, {{1.6236047748785233e-06, 3e-18}, 1.623604774878523e-06}},
    {0.005,
     {{-2.675848e-05, 1e-16}, -2.6758480000000003e-05},
     {{1.5187873e-06, 4e-18}, 1.5187874e-06}},
};

std::string csv_of(const std::vector<DisplacementRow>& of) {
  return app::csv_text(app::displacement_result(of, config::unit_systems().front(), {}).tables[0]);
}

std::string json_of(const std::vector<DisplacementRow>& of) {
  return app::json_of(app::displacement_result(of, config::unit_systems().front(), {}));
}

std::string text_of(const std::vector<DisplacementRow>& of, const config::UnitSystem& units,
                    const app::DisplacementNotes& notes) {
  return app::text_for_people(app::displacement_result(of, units, notes));
}

const app::DisplacementNotes notes{.closed_form = "eq. (3)", .seconds = 0.0123};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

double number_of(const std::string& text) {
  double number = 0;
  const auto end = text.data() + text.size();
  BOOST_TEST_REQUIRE((std::from_chars(text.data(), end, number).ptr == end));
  return number;
}

std::vector<double> numbers_of(const DisplacementRow& row) {
  return {row.x,
          row.gradient.quadrature.value,
          row.gradient.quadrature.abs_error,
          row.gradient.closed_form.value(),
          row.displacement.quadrature.value,
          row.displacement.quadrature.abs_error,
          row.displacement.closed_form.value()};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_csv_has_the_promised_header_and_a_row_a_point) {
  const std::vector<std::string> lines = lines_of(csv_of(rows));

  BOOST_TEST_REQUIRE(lines.size() == 3U);
  BOOST_TEST(lines[0] == header);
  BOOST_TEST(lines[1] == "0,-1.5e-18,2e-17,0,1.6236047748785233e-06,3e-18,1.623604774878523e-06");
}

BOOST_AUTO_TEST_CASE(the_csv_reads_back_to_the_last_bit) {
  const std::vector<std::string> lines = lines_of(csv_of(rows));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<std::string> cells = cells_of(lines[i + 1]);
    const std::vector<double> numbers = numbers_of(rows[i]);
    BOOST_TEST_REQUIRE(cells.size() == numbers.size());
    for (std::size_t j = 0; j < numbers.size(); ++j) BOOST_TEST(number_of(cells[j]) == numbers[j]);
  }
}

BOOST_AUTO_TEST_CASE(the_json_is_the_csv_under_the_same_names) {
  const auto json = nlohmann::ordered_json::parse(json_of(rows));
  const std::vector<std::string> names = cells_of(header);

  BOOST_TEST_REQUIRE(json.size() == rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double> numbers = numbers_of(rows[i]);
    BOOST_TEST(json[i].size() == names.size());
    for (std::size_t j = 0; j < names.size(); ++j) {
      BOOST_TEST(json[i].at(names[j]).get<double>() == numbers[j]);
    }
  }
}

BOOST_AUTO_TEST_CASE(no_points_give_a_header_and_an_empty_array) {
  BOOST_TEST(csv_of({}) == header + "\n");
  BOOST_TEST(json_of({}) == "[]\n");
}

BOOST_AUTO_TEST_CASE(the_table_is_aligned_and_names_the_units) {
  const std::vector<std::string> lines =
      lines_of(text_of(rows, config::unit_system("mm-N"), notes));

  BOOST_TEST_REQUIRE(lines.size() == 3 + rows.size() + 2);
  for (std::size_t i = 0; i < 3 + rows.size(); ++i) {
    BOOST_TEST(lines[i].size() == lines[0].size());
  }
  // Columns end at the same place: a heading, a unit and each number.
  const auto end_of = [&](std::size_t line, const std::string& cell) {
    const auto at = lines[line].find(cell);
    BOOST_TEST_REQUIRE(at != std::string::npos);
    return at + cell.size();
  };
  BOOST_TEST(end_of(0, "x") == end_of(2, "[mm]"));
  BOOST_TEST(end_of(4, "0.005") == end_of(2, "[mm]"));
  BOOST_TEST(end_of(1, "quadrature") == end_of(4, "-2.675848000000e-05"));
  BOOST_TEST(lines[2].find("[in]") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_table_shows_thirteen_digits_and_the_size_of_the_error) {
  const std::string text = text_of(rows, config::unit_systems().front(), notes);

  BOOST_TEST(text.find(" 1.623604774879e-06 ") != std::string::npos);
  BOOST_TEST(text.find(" 3.0e-18 ") != std::string::npos);
  BOOST_TEST(text.find("[in]") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(below_the_table_stands_how_many_points_agree_and_what_it_took) {
  std::vector<DisplacementRow> some = rows;  // 4e-15 and 1e-13 apart: more than the errors
  some.push_back({0.01, {{2.0, 1e-9}, 2.0 + 0.9e-9}, {{1.0, 1e-12}, 1.0}});
  some.push_back({0.02, {{2.0, 1e-9}, 2.0 + 1.1e-9}, {{1.0, 1e-12}, 1.0}});
  some[2].n_evaluations = 100;
  some[3].n_evaluations = 23;
  const std::string text = text_of(some, config::unit_systems().front(), notes);

  BOOST_TEST(text.find("closed form: eq. (3)\n") != std::string::npos);
  BOOST_TEST(text.find("\n2 of 4 points agree within their errors; 123 evaluations of the load, "
                       "0.0123 s\n") != std::string::npos,
             text);
  BOOST_TEST(text.find(" 0.9 ") != std::string::npos);
  BOOST_TEST(text.find(" 1.1 ") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_difference_is_taken_over_the_estimate_and_roundings) {
  BOOST_TEST(app::difference_over_error({{1.0, 0}, 1.0}) == 0);
  BOOST_TEST(app::difference_over_error({{1.0, 1e-6}, 1.0 + 3e-6}) > 2.999);
  BOOST_TEST(app::difference_over_error({{1.0, 0}, 1.0 + 4e-16}) < 1);
  BOOST_TEST(app::difference_over_error({{1.0, 0}, 1.0 + 1e-12}) > 1000);
}

BOOST_AUTO_TEST_CASE(without_closed_forms_there_are_no_columns_for_them) {
  const std::vector<DisplacementRow> alone{{.x = 0.5,
                                            .gradient = {{-1.5, 2e-17}, {}},
                                            .displacement = {{2.5, 3e-18}, {}},
                                            .n_evaluations = 7}};

  BOOST_TEST(csv_of(alone) ==
             "x,gradient_quadrature,gradient_abs_error,displacement_quadrature,"
             "displacement_abs_error\n0.5,-1.5,2e-17,2.5,3e-18\n");
  BOOST_TEST(json_of(alone).find("closed_form") == std::string::npos);
  BOOST_TEST(text_of(alone, config::unit_systems().front(), {})
                 .find("1 point by quadrature; no closed form is known; 7 evaluations") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_is_refused_by_its_column_and_x) {
  std::vector<DisplacementRow> wrong = rows;
  wrong[1].displacement.closed_form = std::numeric_limits<double>::infinity();
  const auto names_it = [](const sys::InputError& error) {
    return std::string(error.what()) ==
           "displacement_closed_form at x = 0.005: not a finite number; the parameters are beyond "
           "the range of a double";
  };

  BOOST_CHECK_EXCEPTION(
      app::require_finite(app::displacement_result(wrong, config::unit_systems().front(), notes)),
      sys::InputError, names_it);
}

BOOST_AUTO_TEST_CASE(no_zero_has_a_sign) {
  const std::vector<DisplacementRow> zero = {{-0.0, {{-0.0, 0}, -0.0}, {{-0.0, 0}, -0.0}}};
  const config::UnitSystem units = config::unit_system("in-lbf");
  for (const std::string& text : {csv_of(zero), json_of(zero), text_of(zero, units, notes)}) {
    BOOST_TEST(text.find("-0") == std::string::npos, text);
  }
}

BOOST_AUTO_TEST_SUITE_END()
