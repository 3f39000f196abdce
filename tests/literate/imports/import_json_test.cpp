// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/import_json.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>

#include "holds.hpp"
#include "literate/imports/imported_table.hpp"
#include "literate/provenance/manifest.hpp"
#include "message_of.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(import_json_test)

using namespace literate;

namespace {

// A checkout with results.json and the script beside it that is said to have written it.
class Checkout {
 public:
  Checkout() { write("run.m", "x = 1\n"); }

  void write(const std::string& file, const std::string& text) const {
    sys::write_file_atomically(folder_ / "octave" / file, text);
  }
  std::string path() const { return (folder_ / "octave" / "results.json").string(); }
  const std::filesystem::path& root() const { return folder_.path(); }

  Document import(const std::string& json, const std::string& prefix = "") const {
    Document document;
    import_into(document, json, prefix);
    return document;
  }
  void import_into(Document& document, const std::string& json,
                   const std::string& prefix = "") const {
    write("results.json", json);
    import_json(document, path(), {.root = root(), .prefix = prefix});
  }

  /// The message that this JSON is refused with, without the path of the file in front.
  std::string error(const std::string& json) const {
    const std::string message = message_of<ImportError>([&] { import(json); });
    return message.starts_with(path() + ":") ? message.substr(path().size() + 1) : message;
  }
  std::string error_of_values(const std::string& values) const {
    return error(R"({"script": "run.m", "values": {)" + values + "}}");
  }
  std::string error_of_table(const std::string& table) const {
    return error(R"({"script": "run.m", "tables": {"t": )" + table + "}}");
  }

 private:
  TemporaryFolder folder_;
};

const std::string displacements = R"({
  "script": "run.m",
  "values": {
    "u0": {"value": 1.62360478e-6, "abs_error": 1e-14, "unit": "in", "digits": 8},
    "slope": {"value": -0.123456789, "abs_error": 3e-4},
    "count": {"value": 11, "abs_error": 0},
    "version": {"text": "GNU Octave, 7 & more"}
  },
  "tables": {
    "points": {
      "columns": [{"heading": "$x$", "unit": "in", "decimals": 3, "exact": true},
                  {"heading": "$u_z$", "unit": "in", "digits": 8},
                  {"heading": "$u_z$", "unit": "in", "exponent": -6, "decimals": 2},
                  {"heading": "node", "integer": true}, {"heading": "note", "text": true},
                  {"heading": "as written", "exact": true}],
      "rows": [[0, {"value": 1.62360478e-6, "abs_error": 1e-14},
                {"value": 1.62360478e-6, "abs_error": 1e-9}, 1, "centre", 1.50],
               [0.005, {"value": 1.51878737e-6, "abs_error": 1e-14}, null, 2, null, -20]]
    }
  }
})";

}  // namespace

BOOST_AUTO_TEST_CASE(a_value_has_its_digits_unit_error_and_place_in_the_file) {
  const Checkout checkout;

  const Document document = checkout.import(displacements, "octave-");

  const Value& value = document.values().at("octave-u0");
  BOOST_TEST(value.printed() == "1.6236048e-6 in");
  BOOST_TEST(value.number().value() == 1.62360478e-6);
  BOOST_TEST(value.uncertainty().value().bound == 1e-14);
  const SourcePlace& place = document.registered().places.at({"value", "octave-u0"});
  BOOST_TEST(text_of(place) == "octave/results.json:4");
  BOOST_TEST(place.function == "octave/run.m");
}

BOOST_AUTO_TEST_CASE(a_standard_uncertainty_comes_with_its_number) {
  const Checkout checkout;
  const Document document = checkout.import(
      R"({"script": "run.m", "values": {"load": {"value": 993.63, "standard": 0.4, "unit": "psi"},
          "both": {"value": 10, "standard": 1, "abs_error": 0.5}}})");

  const Value& load = document.values().at("load");
  BOOST_TEST(load.printed() == "994 psi");
  BOOST_TEST(load.measured()->components().at("value 'load'") == 0.4);
  const Value& both = document.values().at("both");
  BOOST_TEST(both.uncertainty()->bound == 0.5);
  BOOST_TEST(both.uncertainty()->standard == 1);
  BOOST_TEST(checkout.error_of_values(R"("a": {"value": 1, "standard": -0.5})")
                 .ends_with("value 'a': standard must not be negative"));
}

BOOST_AUTO_TEST_CASE(without_digits_those_are_printed_that_the_error_supports) {
  const Document document = Checkout().import(displacements);

  BOOST_TEST(document.values().at("slope").printed() == "-0.123");
  BOOST_TEST(document.values().at("count").printed() == "11");
  BOOST_TEST(document.values().at("version").latex() == "GNU Octave, 7 \\& more");
}

BOOST_AUTO_TEST_CASE(without_digits_a_number_without_an_error_has_all_of_its_own) {
  const Document document = Checkout().import(
      R"({"script": "run.m", "values": {"pi": {"value": 3.14159265358979, "abs_error": 0}}})");
  BOOST_TEST(document.values().at("pi").printed() == "3.14159265358979");
}

BOOST_AUTO_TEST_CASE(a_table_prints_each_column_in_its_format) {
  const Document document = Checkout().import(displacements);

  const Table& table = document.tables().at("points");
  std::string latex = table.latex();
  for (const auto& [cell, number] : table.printed_numbers()) latex += "{" + number + "}";
  for (const char* printed : {"{0.000}", "{1.6236048e-6}", "(\\qty{e-6}{in})", "{1.62e-6}", "{1}",
                              "centre", "{1.50}", "{-20}"}) {
    BOOST_TEST(holds(latex, printed));
  }
  BOOST_TEST(text_of(document.registered().places.at({"table", "points"})) ==
             "octave/results.json:10");
}

BOOST_AUTO_TEST_CASE(file_and_script_are_attached_with_their_digests) {
  const Checkout checkout;
  const Document document = checkout.import(displacements);
  const TemporaryFolder output;

  document.write(output / "generated");

  BOOST_TEST(document.attachments().digests().at("octave/run.m") == sys::sha256_of_text("x = 1\n"));
  BOOST_TEST(sys::read_file(output / "generated/imports/octave/results.json") == displacements);
  const std::string provenance = sys::read_file(output / "generated/provenance.tex");
  BOOST_TEST(holds(provenance,
                   "\\LiterateFile{imports/octave/run.m}{" + sys::sha256_of_text("x = 1\n") + "}"));
  const Manifest::Texts imported = imported_files(output / "generated/names.json");
  BOOST_TEST(imported.at("octave/results.json") == sys::sha256_of_text(displacements));
}

BOOST_AUTO_TEST_CASE(numbers_that_are_older_than_their_script_are_refused) {
  const Checkout checkout;
  const auto json = [](const std::string& digest) {
    return R"({"script": "run.m", "script_sha256": ")" + digest + R"(", "values": {}})";
  };

  BOOST_CHECK_NO_THROW(checkout.import(json(sys::sha256_of_text("x = 1\n"))));
  BOOST_TEST(checkout.error(json(sys::sha256_of_text("x = 2\n"))) ==
             "1:38: 'octave/run.m' has changed since it wrote these numbers: run it again");
}

BOOST_AUTO_TEST_CASE(bad_json_is_told_with_line_and_column) {
  const Checkout checkout;

  BOOST_TEST(checkout.error("{\n  \"script\": \"run.m\",\n  \"values\": {,}\n}") ==
             "3:14: is not JSON: Missing '}' or object member name");
  BOOST_TEST(checkout.error("{\"values\": {\"a\": NaN}}").starts_with("1:18: is not JSON: "));
  BOOST_TEST(holds(checkout.error(""), "is not JSON"));
  BOOST_TEST(checkout.error("[]") == "1:1: the file must be an object");
  BOOST_TEST(holds(checkout.error("{} {}"), "is not JSON"));
  BOOST_TEST(holds(checkout.error(std::string(5000, '[')), "is not JSON"));
}

BOOST_AUTO_TEST_CASE(a_key_that_stands_twice_in_the_file_is_told) {
  const std::string one = R"("a": {"value": 1, "abs_error": 0})";

  const std::string message = Checkout().error_of_values(one + ",\n" + one);

  BOOST_TEST(message.starts_with("2:"));
  BOOST_TEST(holds(message, "Duplicate key: 'a'"));
}

BOOST_AUTO_TEST_CASE(a_file_or_script_that_cannot_be_read_is_named) {
  const Checkout checkout;
  Document document;

  BOOST_TEST(message_of<ImportError>([&] { import_json(document, checkout.path()); }) ==
             checkout.path() + ": the file cannot be read");
  BOOST_TEST(checkout.error(R"({"values": {}})") == "1:1: the file has no script");
  BOOST_TEST(checkout.error(R"({"script": 3})") == "1:12: the file: script must be a text");
  BOOST_TEST(holds(checkout.error(R"({"script": "gone.m"})"), "its script '"));
  BOOST_TEST(checkout.error(R"({"script": "gone.m"})").ends_with("octave/gone.m' cannot be read"));
}

BOOST_AUTO_TEST_CASE(a_name_that_latex_cannot_attach_is_refused) {
  const Checkout checkout;
  checkout.write("my run.m", "");

  BOOST_TEST(holds(checkout.error(R"({"script": "my run.m"})"), "the name must be letters"));
}

BOOST_AUTO_TEST_CASE(a_number_must_be_there_and_finite) {
  const Checkout checkout;

  BOOST_TEST(checkout.error_of_values(R"("a": {"value": null, "abs_error": 0})") ==
             "1:47: value 'a': value is null, as programs write NaN: it must be a finite number");
  BOOST_TEST(checkout.error_of_values(R"("a": {"value": "1", "abs_error": 0})") ==
             "1:47: value 'a': value must be a finite number");
  BOOST_TEST(
      checkout.error_of_values(R"("a": {"value": 1e999, "abs_error": 0})").starts_with("1:47: "));
  BOOST_TEST(checkout.error_of_values(R"("a": {"abs_error": 0})") ==
             "1:37: value 'a' has no value");
  BOOST_TEST(checkout.error_of_values(R"("a": 3)") == "1:37: value 'a' must be an object");
}

BOOST_AUTO_TEST_CASE(a_number_must_say_how_wrong_it_may_be) {
  const Checkout checkout;

  BOOST_TEST(checkout.error_of_values(R"("a": {"value": 1})") ==
             "1:37: value 'a' has no abs_error");
  BOOST_TEST(checkout.error_of_values(R"("a": {"value": 1, "abs_error": -1e-3})") ==
             "1:63: value 'a': abs_error must not be negative");
}

BOOST_AUTO_TEST_CASE(digits_have_to_be_earned) {
  const Checkout checkout;

  BOOST_TEST(checkout.error_of_values(R"("a": {"value": 1.234, "abs_error": 0.02, "digits": 3})") ==
             "1:37: value 'a': 1.234 is printed as '1.23', more digits than an error of 0.02 "
             "supports");
  BOOST_TEST(checkout.error_of_values(R"("a": {"value": 1, "abs_error": 0, "digits": 0})") ==
             "1:76: value 'a': digits = 0 must be a whole number from 1 to 100");
}

BOOST_AUTO_TEST_CASE(a_unit_is_literal_text) {
  BOOST_TEST(
      Checkout().error_of_values(R"("a": {"value": 1, "abs_error": 0, "unit": "\\mm"})") ==
      "1:37: value 'a': unit '\\mm': '\\' has no place there; a unit is spelt as m s-1, m.s^-1, "
      "m/s2, W/(m2.K), um, degC or %");
}

BOOST_AUTO_TEST_CASE(keys_and_names_have_the_form_of_the_engine) {
  const Checkout checkout;

  BOOST_TEST(checkout.error_of_values(R"("a b": {"value": 1, "abs_error": 0})")
                 .starts_with("1:39: value 'a b': a name must be letters"));
  BOOST_TEST(checkout.error(R"({"script": "run.m", "tables": {"a.b": {}}})")
                 .starts_with("1:39: table 'a.b': a name must be letters"));
}

BOOST_AUTO_TEST_CASE(an_unknown_field_is_told_with_those_that_are_known) {
  const Checkout checkout;

  BOOST_TEST(
      checkout.error_of_values(R"("a": {"value": 1, "abs_err": 0})") ==
      "1:61: value 'a' has an unknown field 'abs_err'; known are value, abs_error, standard, unit, "
      "digits");
  BOOST_TEST(checkout.error(R"({"vales": {}})").starts_with("1:11: the file has an unknown field"));
}

BOOST_AUTO_TEST_CASE(a_name_that_is_registered_already_is_told_with_its_place) {
  const Checkout checkout;
  Document document;
  document.value("slope", Value(1, integer()));

  const std::string message =
      message_of<ImportError>([&] { checkout.import_into(document, displacements); });

  BOOST_TEST(holds(message,
                   "results.json:5:14: value 'slope' is registered already, at "
                   "tests/literate/imports/import_json_test.cpp:"));
  BOOST_TEST(document.values().size() == 1U, "nothing of the file is registered then");
  BOOST_TEST(document.attachments().digests().empty());

  Document with_table = checkout.import(displacements);
  const std::string of_table = message_of<ImportError>([&] {
    checkout.import_into(with_table, R"({"script": "run.m", "tables": {"points": {}}})");
  });
  BOOST_TEST(of_table.ends_with("table 'points' is registered already, at octave/results.json:10"));
}

BOOST_AUTO_TEST_CASE(a_column_has_one_format) {
  const Checkout checkout;
  const auto error = [&](const std::string& column) {
    return checkout.error_of_table(R"({"columns": [{)" + column + R"(}], "rows": []})");
  };

  BOOST_TEST(error(R"("digits": 2)") == "1:50: table 't', column 1 has no heading");
  BOOST_TEST(
      error(R"("heading": "x", "digits": 2, "decimals": 1)") ==
      "1:50: table 't', column 1 has more than one of decimals, digits, integer, uncertain, text");
  BOOST_TEST(error(R"("heading": "x", "integer": false)").ends_with("integer can only be true"));
  BOOST_TEST(error(R"("heading": "x", "exact": false)").ends_with("exact can only be true"));
  BOOST_TEST(
      error(R"("heading": "x", "exponent": 3)").ends_with("exponent needs decimals beside it"));
  BOOST_TEST(error(R"("heading": "x", "decimals": 101)")
                 .ends_with("decimals = 101 must be a whole number from 0 to 100"));
  BOOST_TEST(
      holds(error(R"("heading": "x", "unit": "m#s")"), "unit 'm#s': '#' has no place there"));
}

BOOST_AUTO_TEST_CASE(a_table_has_columns_and_whole_rows) {
  const Checkout checkout;

  BOOST_TEST(checkout.error_of_table(R"({"rows": []})") ==
             "1:37: table 't' has no list of columns");
  BOOST_TEST(checkout.error_of_table(R"({"columns": [], "rows": []})") ==
             "1:37: table 't': a table needs a column");
  BOOST_TEST(checkout.error_of_table(R"({"columns": [{"heading": "x"}], "rows": [[1], [1, 2]]})") ==
             "1:83: table 't', row 2 must be a list of 1 cells");
}

BOOST_AUTO_TEST_CASE(a_cell_is_checked_and_told_with_its_place) {
  const Checkout checkout;
  const auto error = [&](const std::string& format, const std::string& cell) {
    const std::string message = checkout.error_of_table(R"({"columns": [{"heading": "x")" + format +
                                                        "}],\n\"rows\": [[" + cell + "]]}");
    BOOST_TEST(message.starts_with("2:11: table 't', row 1: "), message);
    return message.substr(message.find("row 1: ") + 7);
  };

  BOOST_TEST(error(R"(, "decimals": 2)", R"({"value": 1.5, "abs_error": 0.02})") ==
             "1.5 is printed to the place 1e-2, more digits than its error of 0.02 supports");
  BOOST_TEST(error(R"(, "digits": 2)", R"({"value": 150, "abs_error": 12})") ==
             "150 is printed to the place 1e1, more digits than its error of 12 supports");
  BOOST_TEST(error("", "1.5") ==
             "1.5 comes without its error: give column 'x' an abs_error or a standard, or declare "
             "it exact");
  BOOST_TEST(error(R"(, "exact": true)", "11400714819323198485") ==
             "11400714819323198485 has more digits than a number holds: declare column 'x' to be "
             "of texts");
  BOOST_TEST(error("", R"("one")") == "'one' is not a number, as column 'x' holds");
  BOOST_TEST(error(R"(, "text": true)", "1") == "1 is a number in the column of texts 'x'");
  BOOST_TEST(error(R"(, "integer": true)", "1.5") ==
             "1.5 is not a whole number, as column 'x' holds");
  BOOST_TEST(error("", "[]") == "a cell must be an object");
}

BOOST_AUTO_TEST_CASE(a_number_that_a_double_does_not_hold_is_refused_unless_its_error_is_larger) {
  const Checkout checkout;
  const std::string seed = R"("seed": {"value": 9007199254740993, "abs_error": )";
  const std::string refusal =
      "1:50: value 'seed': 9007199254740993 has more digits than a number holds: give its error, "
      "or a text";
  BOOST_TEST(checkout.error_of_values(seed + "0}") == refusal);
  BOOST_TEST(checkout.error_of_values(seed + "0.5}") == refusal);
  BOOST_TEST(checkout.error_of_values(seed + "10}") == "(no error)");
  BOOST_TEST(checkout.error_of_values(
                 R"("a": {"value": 9007199254740992, "abs_error": 0},)"
                 R"("b": {"value": 0.1, "abs_error": 0}, "c": {"value": 1e22, "abs_error": 0},)"
                 R"("d": {"value": -0.30000000000000004, "abs_error": 0})") == "(no error)");
  for (const char* const format : {R"("decimals": 0)", R"("digits": 16)", R"("uncertain": true)"}) {
    BOOST_TEST(
        checkout
            .error_of_table(R"({"columns": [{"heading": "n", )" + std::string(format) +
                            R"(}], "rows": [[{"value": 9007199254740993, "abs_error": 0}]]})")
            .ends_with("9007199254740993 has more digits than a number holds: declare column 'n' "
                       "to be of texts"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
