// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/import_csv.hpp"

#include <boost/test/unit_test.hpp>
#include <set>
#include <stdexcept>
#include <string>

#include "holds.hpp"
#include "literate/imports/imported_table.hpp"
#include "message_of.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(import_csv_test)

using namespace literate;

namespace {

class Checkout {
 public:
  Checkout() { sys::write_file_atomically(folder_ / "run.py", "print(1)\n"); }

  std::string path() const { return (folder_ / "points.csv").string(); }

  Document import(const std::string& csv, const std::set<std::string>& exact = {"x"}) const {
    Document document;
    import_into(document, csv, "points", exact);
    return document;
  }
  Document import_with(ImportOptions options, const std::string& csv) const {
    Document document;
    options.root = folder_.path();
    sys::write_file_atomically(path(), csv);
    import_csv(document, "points", path(), folder_ / "run.py", options);
    return document;
  }
  void import_into(Document& document, const std::string& csv, const std::string& name = "points",
                   const std::set<std::string>& exact = {"x"}) const {
    sys::write_file_atomically(path(), csv);
    import_csv(document, name, path(), folder_ / "run.py",
               {.root = folder_.path(), .exact = exact});
  }

  std::string error(const std::string& csv, const std::set<std::string>& exact = {}) const {
    std::string message = message_of<ImportError>([&] { import(csv, exact); });
    // Every message names the table, behind the place.
    const std::string table = "table 'points': ";
    const auto at = message.find(table);
    if (!message.starts_with(path() + ":") || at == std::string::npos) return message;
    return message.erase(at, table.size()).substr(path().size() + 1);
  }

 private:
  TemporaryFolder folder_;
};

// The table, and behind it each of its numbers in braces.
std::string latex_of_points(const Document& document) {
  const Table& table = document.tables().at("points");
  std::string text = table.latex();
  for (const auto& [cell, printed] : table.printed_numbers()) text += "{" + printed + "}";
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_number_keeps_the_digits_of_the_file) {
  const std::string latex =
      latex_of_points(Checkout().import("x (in),u (in),note\r\n0.000,1.6236048e-006,\"the "
                                        "\"\"centre\"\", 100 %\"\r\n\r\n0.005,,\r\n",
                                        {"x (in)", "u (in)"}));

  for (const char* part : {"{0.000}", "{1.6236048e-6}", "(\\unit{in})", "{0.005}",
                           "the \\textquotedbl{}centre\\textquotedbl{}, 100 \\%"}) {
    BOOST_TEST(holds(latex, part));
  }
}

BOOST_AUTO_TEST_CASE(headings_of_the_file_are_plain_text) {
  BOOST_TEST(holds(latex_of_points(Checkout().import("u_z\n1\n", {"u_z"})), "u\\_z"));
}

BOOST_AUTO_TEST_CASE(
    a_unit_that_is_none_and_a_parenthesis_that_is_open_are_refused_at_their_heading) {
  const auto refused = [](const std::string& heading) {
    return message_of<ImportError>([&] { (void)Checkout().import(heading + "\n1\n", {heading}); });
  };
  BOOST_TEST(holds(refused("k (furlongz)"), "points.csv:1:1: "));
  BOOST_TEST(holds(refused("k (furlongz)"), "UDUNITS-2 does not know 'furlongz'"));
  BOOST_TEST(
      refused("k (s-1").ends_with("column 'k (s-1': the parenthesis of its unit is not closed"),
      refused("k (s-1"));
  BOOST_TEST(refused("cars ({cars})") == "(no error)");
}

BOOST_AUTO_TEST_CASE(a_standard_uncertainty_stands_to_the_right_of_its_column) {
  const Document document =
      Checkout().import("load (psi),standard,abs_error\n994.1,0.08,0.01\n605,1,\n", {});
  const auto& rows = document.tables().at("points").rows();
  BOOST_TEST(rows[0][0].uncertainty()->standard == 0.08);
  BOOST_TEST(rows[0][0].uncertainty()->bound == 0.01);
  BOOST_TEST(rows[1][0].uncertainty()->standard == 1);
  BOOST_TEST(document.tables().at("points").csv().starts_with("load (psi),abs_error,standard\n"));
}

BOOST_AUTO_TEST_CASE(file_and_script_are_the_source_of_the_table) {
  const Document document = Checkout().import("x\n1\n");

  BOOST_TEST(text_of(document.registered().places.at({"table", "points"})) == "points.csv:1");
  BOOST_TEST(document.registered().places.at({"table", "points"}).function == "run.py");
  BOOST_TEST(document.attachments().digests().at("points.csv") == sys::sha256_of_text("x\n1\n"));
  BOOST_TEST(document.attachments().digests().contains("run.py"));
}

BOOST_AUTO_TEST_CASE(digits_have_to_be_earned_by_the_error_beside_them) {
  const Checkout checkout;

  const std::string latex =
      latex_of_points(checkout.import("x,abs_error\n1.5,0.1\n1.25,0.02\n1234,40\n", {}));
  for (const char* part : {"{1.5}", "{1.2}", "{1.2e3}"}) {
    BOOST_TEST(holds(latex, part));
  }
  BOOST_TEST(checkout.error("x,abs_error\n1.5,-0.1\n") ==
             "2:5: abs_error = -0.1: must be finite and not negative");
  BOOST_TEST(checkout.error("x,abs_error\n1.5,much\n") == "2:5: abs_error 'much' is not a number");
  BOOST_TEST(checkout.error("x,abs_error\n1.5,0.1\n,0.1\n") ==
             "3:2: abs_error '0.1' belongs to no number: the cell is empty");
}

BOOST_AUTO_TEST_CASE(a_number_whose_error_leaves_no_digit_of_it_is_printed_with_the_error) {
  const std::string latex =
      latex_of_points(Checkout().import("x,abs_error\n0.02,3\n12,34\n15,3\n", {}));
  for (const char* part : {"{0.0±3.1}", "{12±34}", "{2e1}"}) {
    BOOST_TEST(holds(latex, part));
  }
}

BOOST_AUTO_TEST_CASE(a_number_without_its_error_is_refused_unless_its_column_is_declared_exact) {
  const Checkout checkout;
  const std::string csv = "x (m),u\n1.5,2\n";

  BOOST_TEST(checkout.error(csv) ==
             "2:1: 1.5 comes without its error: give column 'x' an abs_error or a standard, or "
             "declare it exact");
  BOOST_TEST(checkout.error(csv, {"x (m)"}) ==
             "2:5: 2 comes without its error: give column 'u' an abs_error or a standard, or "
             "declare it exact");
  BOOST_CHECK_NO_THROW(checkout.import(csv, {"x (m)", "u"}));
  BOOST_TEST(checkout.error(csv, {"x", "u"}) == "1: there is no column 'x', which is to be exact");
  BOOST_TEST(checkout.error("u,abs_eror\n1.5,0.1\n") ==
             "1:3: column 'abs_eror', did you mean 'abs_error'?");
  BOOST_TEST(checkout.error("u,abs_eror\n1.5,0.1\n", {"u"}) ==
             "1:3: column 'abs_eror', did you mean 'abs_error'?");
  BOOST_TEST(checkout.error("u,abs_error\n1.5,\n") ==
             "2:1: 1.5 comes without its error: give column 'u' an abs_error or a standard, or "
             "declare it exact");
}

BOOST_AUTO_TEST_CASE(a_number_with_more_digits_than_a_double_holds_is_refused) {
  const Checkout checkout;
  const auto error = [&](const std::string& number) {
    return checkout.error("x\n" + number + "\n", {"x"});
  };

  for (const char* number : {"11400714819323198485", "0.12345678901234567"}) {
    BOOST_TEST(error(number) ==
               "2:1: " + std::string(number) +
                   " has more digits than a number holds: declare column 'x' to be of texts");
  }
  for (const char* number : {"0.30000000000000004", "1.6236048e-006", "-0.00", "9007199254740992",
                             "12e3", "+1.50", ".5", "0.10000000000000000555"}) {
    BOOST_CHECK_NO_THROW(checkout.import("x\n" + std::string(number) + "\n"));
  }
}

BOOST_AUTO_TEST_CASE(a_column_that_is_declared_to_hold_texts_holds_numbers_of_any_length) {
  const Checkout checkout;

  const Document document =
      checkout.import_with({.text = {"seed"}}, "seed\n11400714819323198485\n7\n");

  const auto& rows = document.tables().at("points").rows();
  BOOST_TEST(rows[0][0].plain() == "11400714819323198485");
  BOOST_TEST(rows[1][0].plain() == "7");
  BOOST_TEST(message_of<ImportError>([&] {
               checkout.import_with({.text = {"x"}}, "x,abs_error\n1,2\n");
             }).ends_with("column 'x' is of texts and has errors"));
}

BOOST_AUTO_TEST_CASE(a_column_of_texts_keeps_its_heading_and_an_exact_one_holds_numbers) {
  const Checkout checkout;

  const Document document =
      checkout.import_with({.text = {"x (m)"}}, "x (m),who (all)\n1,a\n2,b\n");

  BOOST_TEST(document.table("points").csv() == "x (m),who (all)\n1,a\n2,b\n");
  BOOST_TEST(checkout.error("x (m)\n\"1,5\"\n", {"x (m)"}) ==
             "2:1: '1,5' is not a number, and column 'x (m)' is to be exact");
}

BOOST_AUTO_TEST_CASE(a_row_that_begins_with_a_number_sign_is_kept) {
  const Checkout checkout;

  const Document document = checkout.import_with({}, "who\n#1\n#2\n# a note\npump\n");

  BOOST_TEST(document.table("points").rows().size() == 3U);
}

BOOST_AUTO_TEST_CASE(a_column_that_is_declared_uncertain_prints_its_errors) {
  const Checkout checkout;
  const auto import = [&](const std::string& csv) {
    return checkout.import_with({.uncertain = {"x (s)"}}, csv);
  };

  const std::string latex =
      latex_of_points(import("x (s),standard,abs_error\n1.2345,0.012,0\n2.5,0,0.1\n4,0,0\n"));
  for (const char* part : {"{1.234(12)}", "{2.50±0.10}", "{4}"}) {
    BOOST_TEST(holds(latex, part));
  }
  BOOST_TEST(
      message_of<ImportError>([&] { import("x (s)\n1.5\n"); })
          .ends_with(
              "1.5 comes without its error: give column 'x' an abs_error or a standard, or declare "
              "it exact"));
  BOOST_TEST(message_of<ImportError>([&] { import("x (m),abs_error\n1.5,0.1\n"); })
                 .ends_with("there is no column 'x (s)', which is to be uncertain, did you mean "
                            "'x (m)'?"));
}

BOOST_AUTO_TEST_CASE(bounds_to_either_side_come_back) {
  const Checkout checkout;
  const std::string csv = "x (s),below,above\n1.5,0.2,0.3\n2.5,0.1,0.1\n";

  const Document document = checkout.import_with({.uncertain = {"x (s)"}}, csv);

  BOOST_TEST(holds(latex_of_points(document), "{1.50+0.30−0.20}"));
  BOOST_TEST(document.tables().at("points").csv() == csv);
  BOOST_TEST(checkout.error("x,below\n1.5,0.1\n") ==
             "2:1: a number has an abs_error, or one below and one above");
  const Document sizes = checkout.import("flow,below\n1.5,7\n", {"flow", "below"});
  BOOST_TEST(sizes.tables().at("points").columns().size() == 2U);
}

BOOST_AUTO_TEST_CASE(a_sign_in_a_heading_is_the_same_in_messages_and_in_the_csv_file) {
  const Checkout checkout;
  const std::string csv = "\"θ in °, 10⁻³ of <x>\"\n1.5\n";

  BOOST_TEST(checkout.error("θ in °\n1.5\n") ==
             "2:1: 1.5 comes without its error: give column 'θ in °' an abs_error or a standard, "
             "or declare it "
             "exact");
  BOOST_TEST(checkout.import(csv, {"θ in °, 10⁻³ of <x>"}).tables().at("points").csv() == csv);
}

BOOST_AUTO_TEST_CASE(the_csv_file_of_a_table_comes_back) {
  Table table("points", {Column::text("method"), Column("$\\theta$", exact(), "°"),
                         Column("$u_z$", significant(4), "in").under("$T/T_0$"),
                         Column("share", percent(1))});
  table
      .add_row({"50 % & \"more\" of a_b", 0.1, numerics::Estimate{0.786151378, 1.2e-7},
                numerics::Estimate{0.25, 1e-9}})
      .add_row({Cell::latex("$\\infty$--$\\nu$"), 1e-7, {}, numerics::Estimate{1.0 / 3, 0}})
      .add_row({"two\nlines", 3, numerics::Estimate{1234.5, 40}, {}});
  const std::string csv = table.csv();
  BOOST_TEST(csv.find('\\') == std::string::npos, csv);
  BOOST_TEST(csv.find('$') == std::string::npos, csv);

  const Document document = Checkout().import(csv, {"θ (°)"});

  const Table& again = document.tables().at("points");
  BOOST_TEST(again.csv() == csv);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t i = 1; i < 4; ++i) {
      const Cell& was = table.rows()[row][i];
      const Cell& is = again.rows()[row][i];
      BOOST_TEST((was.number() == nullptr) == (is.number() == nullptr));
      if (was.number() == nullptr || is.number() == nullptr) continue;
      BOOST_TEST(*is.number() == *was.number());
      BOOST_TEST(is.error() == was.error());
    }
  }
  BOOST_TEST(again.rows()[0][0].plain() == "50 % & \"more\" of a_b");
  BOOST_TEST(again.rows()[1][0].plain() == "∞–ν");
}

BOOST_AUTO_TEST_CASE(what_is_no_number_among_numbers_is_refused) {
  const Checkout checkout;

  for (const char* text : {"NaN", "nan", "inf", "-inf", "1.2x", "1,2", "0x10", "--1", "1e", "e5"}) {
    const std::string cell = "\"" + std::string(text) + "\"";
    BOOST_TEST(checkout.error("x\n1\n" + cell + "\n", {"x"}) ==
               "3:1: '" + std::string(text) + "' is not a number, as column 'x' holds");
  }
  BOOST_TEST(checkout.error("x\n1e999\n", {"x"}) == "2:1: the number is not finite");
}

BOOST_AUTO_TEST_CASE(a_column_of_nothing_but_nan_is_refused_and_is_none_of_texts) {
  const Checkout checkout;

  for (const char* text : {"nan", "-inf", "NaN", "Infinity"}) {
    const std::string cell(text);
    BOOST_TEST(checkout.error("x\n" + cell + "\n" + cell + "\n", {"x"}) ==
               "2:1: '" + cell + "' is not a number, as column 'x' holds");
  }
  BOOST_TEST(checkout.error("x,abs_error\nnone,0.1\n", {}) ==
             "2:1: 'none' is not a number, as column 'x' holds");
}

BOOST_AUTO_TEST_CASE(lines_that_do_not_fit_are_told) {
  const Checkout checkout;

  const std::string path = checkout.path();
  const std::string table = ", for table 'points'";
  BOOST_TEST(checkout.error("") == "1: there is no line of headings");
  BOOST_TEST(checkout.error("x,y\n1,2\n\n1\n") ==
             path + ":4:1: the line has 1 field, the first one has 2" + table);
  BOOST_TEST(checkout.error("x,y\n1,2,3\n") ==
             path + ":2:1: the line has 3 fields, the first one has 2" + table);
  BOOST_TEST(checkout.error("x\n\"1\n") == path + ":2:1: a quote is not closed" + table);
  BOOST_TEST(checkout.error("x,y\n1,caf\xe9\n") == path + ":2:3: this text is not UTF-8" + table);
  BOOST_TEST(checkout.error("x,y\n1,\"2\n") == path + ":2:3: a quote is not closed" + table);
  BOOST_TEST(checkout.error(std::string("x\n1\0\n", 5)) ==
             path + ":2:2: there is a zero byte" + table);
  BOOST_TEST(checkout.error(std::string("x,y\n1,2\0\n", 9)) ==
             path + ":2:4: there is a zero byte" + table);
  BOOST_TEST(checkout.error("abs_error,x\n1,2\n") ==
             "1:1: abs_error has no column of numbers to its left");
  BOOST_TEST(checkout.error("x,abs_error,abs_error\n1,2,3\n") ==
             "1:13: abs_error has no column of numbers to its left");
  BOOST_TEST(checkout.error("x (\\mm)\n1\n") ==
             "1:1: unit '\\mm': '\\' has no place there; a unit is spelt as m s-1, m.s^-1, m/s2, "
             "W/(m2.K), um, degC or %");
  BOOST_TEST(checkout.error("# a note\nx,y (\\mm)\n1,2\n") ==
             "2:3: unit '\\mm': '\\' has no place there; a unit is spelt as m s-1, m.s^-1, m/s2, "
             "W/(m2.K), um, degC or %");
}

BOOST_AUTO_TEST_CASE(a_message_names_file_line_column_and_the_table_that_was_registered) {
  const Checkout checkout;

  const std::string message = message_of<ImportError>([&] {
    checkout.import("x (in),y\n1,2\n3,four\n5,6\n", {"x (in)", "y"});
  });

  BOOST_TEST(message ==
             checkout.path() + ":3:3: table 'points': 'four' is not a number, as column 'y' holds");
}

BOOST_AUTO_TEST_CASE(names_are_checked_as_everywhere) {
  const Checkout checkout;
  Document document = checkout.import("x\n1\n");

  const auto error = [&](const std::string& name) {
    return message_of<ImportError>([&] { checkout.import_into(document, "x\n1\n", name); });
  };
  BOOST_TEST(error("points") ==
             checkout.path() + ": table 'points' is registered already, at points.csv:1");
  BOOST_TEST(error("a.b") ==
             checkout.path() + ": the table's name 'a.b' must be letters, digits, '-' and '_'");
}

BOOST_AUTO_TEST_CASE(a_file_or_script_that_cannot_be_read_is_named) {
  const TemporaryFolder folder;
  Document document;
  const auto error = [&] {
    return message_of<ImportError>(
        [&] { import_csv(document, "t", folder / "t.csv", folder / "run.py"); });
  };

  BOOST_TEST(error() == (folder / "t.csv").string() + ": the file cannot be read, for table 't'");
  sys::write_file_atomically(folder / "t.csv", "x\n");
  BOOST_TEST(error().ends_with("run.py' cannot be read, for table 't'"));
}

BOOST_AUTO_TEST_CASE(a_heading_that_stands_twice_is_refused) {
  const Checkout checkout;
  BOOST_TEST(checkout.error("x (s),y (s),x (s)\n1,2,3\n", {"x (s)", "y (s)"}) ==
             "1:13: column 'x (s)' stands twice");
  BOOST_TEST(checkout.error("x (s),x (ms)\n1,2\n", {"x (s)", "x (ms)"}) == "(no error)");
  BOOST_TEST(checkout.error("x,abs_error,y,abs_error\n1,0.1,2,0.1\n") == "(no error)");
}

BOOST_AUTO_TEST_CASE(a_column_is_found_by_its_heading_with_its_unit) {
  const Document document = Checkout().import("x (m),note,y (s),abs_error\n1,a,2,0.1\n", {"x (m)"});
  const Table& table = document.tables().at("points");
  BOOST_TEST(table.column("x (m)") == 0U);
  BOOST_TEST(table.column("note") == 1U);
  BOOST_TEST(*table.rows()[0][table.column("y (s)")].number() == 2);
  BOOST_TEST(message_of<std::invalid_argument>([&] {
               table.column("y (ms)");
             }).ends_with(": table 'points' has no column 'y (ms)', but 'x (m)', 'note', 'y (s)'"));
}

BOOST_AUTO_TEST_SUITE_END()
