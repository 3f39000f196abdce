// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/result.hpp"

#include <boost/test/unit_test.hpp>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "command_line/options.hpp"
#include "message_of.hpp"
#include "random_inputs.hpp"

BOOST_AUTO_TEST_SUITE(result_test)

using app::json_text;
using app::Result;
using nlohmann::ordered_json;

namespace {

// How many significant digits a number is written with.
int n_digits_of(std::string text) {
  text.erase(std::min(text.find_first_of("eE"), text.size()));
  std::string digits;
  for (const char c : text) {
    if (c >= '0' && c <= '9') digits += c;
  }
  digits.erase(0, digits.find_first_not_of('0'));
  digits.erase(digits.find_last_not_of('0') + 1);
  return static_cast<int>(digits.size());
}

// The fewest digits that read back as the number, found by trying.
int fewest_digits(double number) {
  for (int n = 1;; ++n) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific, n - 1).ptr;
    double read_back = 0;
    std::from_chars(text.data(), end, read_back);
    if (read_back == number) return n;
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_number_has_the_fewest_digits_that_round_trip) {
  RandomInputs random(5);
  int n_longer_by_dump = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double number = random.log_uniform(1e-12, 1e12);
    const std::string text = json_text(ordered_json(number));
    const int fewest = fewest_digits(number);
    n_longer_by_dump += n_digits_of(ordered_json(number).dump()) > fewest;

    BOOST_REQUIRE(n_digits_of(text) == fewest);
    BOOST_REQUIRE(ordered_json::parse(text).get<double>() == number);
  }
  // The numbers that nlohmann's own writer prints too long are among them.
  BOOST_TEST(n_longer_by_dump > 0);
}

BOOST_AUTO_TEST_CASE(a_flat_array_is_one_line_and_an_object_a_line_a_key) {
  ordered_json value;
  value["nodes"] = 41;
  value["hertz"] = {{"half_width", 0.5}};
  value["x"] = {-0.25, 0.0, 1e-9};

  BOOST_TEST(json_text(value) ==
             "{\n"
             "  \"nodes\": 41,\n"
             "  \"hertz\": {\n"
             "    \"half_width\": 0.5\n"
             "  },\n"
             "  \"x\": [-0.25, 0, 1e-09]\n"
             "}\n");
}

BOOST_AUTO_TEST_CASE(keys_keep_their_order) {
  const std::string text = json_text({{"z", 1}, {"a", 2}, {"m", 3}});

  BOOST_TEST(text.find("\"z\"") < text.find("\"a\""));
  BOOST_TEST(text.find("\"a\"") < text.find("\"m\""));
}

BOOST_AUTO_TEST_CASE(keys_and_strings_are_escaped) {
  const ordered_json value = {{"a \"key\"\n", "back\\slash \t ν"}};

  BOOST_TEST(json_text(value).find('\t') == std::string::npos);
  BOOST_TEST((ordered_json::parse(json_text(value)) == value));
}

BOOST_AUTO_TEST_CASE(whatever_is_nested_reads_back_the_same) {
  const ordered_json value = {
      {"rows", {{{"x", 0.1}}, {{"x", 0.2}}}},
      {"empty", {{"array", ordered_json::array()}, {"object", ordered_json::object()}}},
      {"others", {true, nullptr, "text", -7}},
      {"matrix", {{1.5, 2.5}, {3.5, 4.5}}}};

  BOOST_TEST((ordered_json::parse(json_text(value)) == value));
  BOOST_TEST(json_text(ordered_json::array()) == "[]\n");
  BOOST_TEST(json_text(ordered_json::object()) == "{}\n");
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_is_refused) {
  using limits = std::numeric_limits<double>;
  for (const double number : {limits::infinity(), -limits::infinity(), limits::quiet_NaN()}) {
    BOOST_CHECK_THROW(json_text({{"x", {1.5, number}}}), sys::InputError);
  }
}

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// A result with all that one can have.
Result full_result() {
  return {.quantities = {{"width", "half-width, greatest", 0.5, "mm", 0.25},
                         {"width", "half-width, least", 0.125, "mm", infinite},
                         {"", "tangential load", 3, "N"}},
          .closed_form = "hertz",
          .details = {{"method", "fft"}},
          .tables = {{.columns = {{.key = "x",
                                   .heads = {"x", "[mm]"},
                                   .width = 8,
                                   .format = "{:.3g}",
                                   .numbers = {-0.0, 1. / 3}},
                                  {.key = "gap",
                                   .heads = {"gap", "[mm]"},
                                   .width = 6,
                                   .numbers = {1, infinite},
                                   .may_be_infinite = true},
                                  {.key = "shear",
                                   .heads = {"shear", "[MPa]"},
                                   .width = 7,
                                   .is_absent = true}},
                      .in_json = app::InJson::columns}},
          .notes = "2 nodes\n"};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_csv_is_the_columns_that_are_there) {
  BOOST_TEST(csv_text(full_result().tables[0]) == "x,gap\n0,1\n0.3333333333333333,inf\n");
}

BOOST_AUTO_TEST_CASE(the_json_has_finite_numbers_and_numbers_of_one_key_as_an_array) {
  BOOST_TEST(json_of(full_result()) ==
             "{\n"
             "  \"width\": [0.5, 0.125],\n"
             "  \"method\": \"fft\",\n"
             "  \"hertz\": {\n"
             "    \"width\": 0.25\n"
             "  },\n"
             "  \"x\": [0, 0.3333333333333333]\n"
             "}\n");
}

BOOST_AUTO_TEST_CASE(people_read_quantities_beside_the_closed_form_then_tables_then_notes) {
  BOOST_TEST(text_for_people(full_result()) ==
             "                              elements           Hertz  difference\n"
             "half-width, greatest               0.5            0.25     1.0e+00  mm\n"
             "half-width, least                0.125        infinite              mm\n"
             "tangential load                      3  N\n"
             "       x   gap  shear\n"
             "    [mm]  [mm]  [MPa]\n"
             "       0     1      -\n"
             "   0.333   inf      -\n"
             "2 nodes\n");
}

BOOST_AUTO_TEST_CASE(a_table_alone_is_an_array_of_rows_and_one_by_text_an_object) {
  Result result{.tables = {{.columns = {{.key = "measure", .texts = {"energy", "force"}},
                                        {.key = "value", .numbers = {1.5, 2}}}}}};
  BOOST_TEST(ordered_json::parse(json_of(result)) ==
             ordered_json::parse(
                 R"([{"measure": "energy", "value": 1.5}, {"measure": "force", "value": 2.0}])"));

  result.details = {{"order", 7}};
  result.tables[0].in_json = app::InJson::by_text;
  result.tables[0].name = "measures";
  BOOST_TEST(
      ordered_json::parse(json_of(result)) ==
      ordered_json::parse(
          R"({"order": 7, "measures": {"energy": {"value": 1.5}, "force": {"value": 2.0}}})"));
}

BOOST_AUTO_TEST_CASE(whatever_is_printed_has_to_be_finite_and_is_named_where_it_is_not) {
  const auto refusal = [](const auto& spoil) {
    Result result = full_result();
    spoil(result);
    return message_of<sys::InputError>([&] { require_finite(result); });
  };
  BOOST_CHECK_NO_THROW(require_finite(full_result()));
  BOOST_TEST(refusal([](Result& r) { r.quantities[1].value = infinite; }).starts_with("width:"));
  BOOST_TEST(
      refusal([](Result& r) { r.quantities[2].value = infinite; }).starts_with("tangential load:"));
  BOOST_TEST(refusal([](Result& r) { r.quantities[0].exact = 0; }).starts_with("width / exact:"));
  BOOST_TEST(
      refusal([](Result& r) { r.details["residuals"]["load"] = infinite; }).starts_with("load:"));
  BOOST_TEST(
      refusal([](Result& r) { r.tables[0].columns[0].numbers[1] = infinite; }).starts_with("x:"));
}

BOOST_AUTO_TEST_SUITE_END()
