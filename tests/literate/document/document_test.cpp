// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/document.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <limits>
#include <stdexcept>

#include "holds.hpp"
#include "literate/document/names.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(document_test)

using namespace literate;
namespace fs = std::filesystem;

namespace {

Document document_with(int load) {
  Document document;
  document.value("load", Value(load, integer(), "psi"));
  document.value("modulus", Value(30e6, exact(), "psi"));
  document.flag("converged", true);
  document.table(Table("results", {Column("$n$", integer())}).add_row({3}));
  return document;
}

void age(const fs::path& file) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(5));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_doubled_or_malformed_key_is_a_logic_error_naming_it) {
  Document document = document_with(1);

  const std::string message =
      message_of<std::logic_error>([&] { document.value("load", Value(2, integer())); });
  BOOST_TEST(message.find("tests/literate/document/document_test.cpp:") == 0U);
  BOOST_TEST(holds(message, ": value 'load' is registered twice, first at tests/literate/"));
  BOOST_CHECK_THROW(document.flag("converged", false), std::logic_error);
  BOOST_CHECK_THROW(document.table(Table("results", {Column::text("x")})), std::logic_error);
  BOOST_CHECK_THROW(document.value("a b", Value(2, integer())), std::logic_error);
  BOOST_CHECK_THROW(document.table(Table("../x", {Column::text("x")})), std::logic_error);
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_is_refused_with_its_key_and_line) {
  Document document;
  const double nan = std::numeric_limits<double>::quiet_NaN();

  const std::string message =
      message_of<std::invalid_argument>([&] { document.value("period", Value(nan, fixed(2))); });

  BOOST_TEST(message.starts_with("tests/literate/document/document_test.cpp:"));
  BOOST_TEST(message.ends_with(": value 'period': nan is not finite"));
  BOOST_TEST(document.values().empty());
}

BOOST_AUTO_TEST_CASE(a_number_without_its_error_is_refused_with_its_key_and_line) {
  Document document;

  const std::string message =
      message_of<std::invalid_argument>([&] { document.value("period", Value(2.35, fixed(1))); });

  BOOST_TEST(message.starts_with("tests/literate/document/document_test.cpp:"));
  BOOST_TEST(message.ends_with(
      ": value 'period': 2.35 comes without its error: give an Estimate or .within(error), or say "
      ".as_is() of a number that is printed as it came"));
  BOOST_TEST(document.values().empty());
}

BOOST_AUTO_TEST_CASE(what_is_known_of_an_error_is_told_of_no_more_than_that) {
  const TemporaryFolder folder;
  Document document;
  document.value("residual", Value(2.34e-15, scientific(2)).as_is());
  document.value("bound", Value({1.25, 0.01}, fixed(2)));
  document.value("none", Value({1.25, 0}, fixed(2)));
  const numerics::Measured load =
      numerics::Measured(994, 20, "statistics") + numerics::Measured(0, 9, "calibration");
  document.value("load", Value(load, uncertain(), "psi"));
  document.value("load-of-both", Value(load + numerics::Measured::bounded({0, 3}), uncertain()));
  document.value("sides", Value(994, Uncertainty::to_sides(18, 21), uncertain(), "psi"));
  const numerics::Measured ratio = load / numerics::Measured(100, 20, "width");
  document.value("ratio", Value(ratio, uncertain()));

  document.write(folder / "generated");

  const auto has = [&](const char* file, const std::string& text) {
    return sys::read_file(folder / "generated" / file).find(text) != std::string::npos;
  };
  BOOST_TEST(has("index.tex", "{residual}{residual}{no error bound}"));
  BOOST_TEST(has("index.tex", "{bound}{bound}{error $\\le$ \\num{1.0e-2}}"));
  BOOST_TEST(has("index.tex", "{none}{none}{exact}"));
  BOOST_TEST(has("index.tex",
                 "{standard uncertainty \\qty{22}{psi} (calibration \\qty{9.0}{psi}, statistics "
                 "\\qty{20}{psi})}"));
  BOOST_TEST(has("index.tex", "statistics \\num{20}), error $\\le$ \\num{3.0}}"));
  BOOST_TEST(has("index.tex", "error $\\le$ \\qty{1.8e1}{psi} below, \\qty{2.1e1}{psi} above"));
  BOOST_TEST(has("index.tex", "; the second order, which is left out, is at most \\num{0.4"));
  BOOST_TEST(has("page/index.html", "<tex>standard uncertainty \\qty{22}{psi}"));
  BOOST_TEST(has("values.csv", "load,994(22) psi,994,0,,,21.9317"));
  BOOST_TEST(has("names.json",
                 "\"value load: sources of uncertainty\": \"calibration 9, statistics 20\""));
  BOOST_TEST(has("values.csv", "residual,2.3e-15,2.34e-15,,,,,,"));
  BOOST_TEST(has("page/index.html", ", <tex>no error bound</tex>"));
  const Names names = read_names(folder / "generated/names.json");
  BOOST_TEST(!names.numbers.at("residual").is_exact);
  BOOST_TEST(!names.numbers.at("residual").uncertainty.has_value());
}

BOOST_AUTO_TEST_CASE(bare_digits_read_back_the_same_and_have_neither_unit_nor_exponent) {
  const TemporaryFolder folder;
  Document document;
  document.value("small", Value(1.25e-7, exact(), "in"));
  document.value("large", Value(30e6, exact(), "psi"));
  document.value("share", Value(0.125, percent(1)).as_is());
  document.value("word", Value::text("none"));

  document.write(folder / "generated");

  const std::string values = sys::read_file(folder / "generated/values.tex");
  BOOST_TEST(holds(values, "\\LiterateRaw{small}{0.000000125}"));
  BOOST_TEST(holds(values, "\\LiterateRaw{large}{30000000}"));
  BOOST_TEST(holds(values, "\\LiterateRaw{share}{0.125}"));
  BOOST_TEST(lacks(values, "\\LiterateRaw{word}"));
}

BOOST_AUTO_TEST_CASE(failed_checks_are_told_apart) {
  Document document;
  document.check("balance", true, "the forces balance");
  document.check("sign", false, "the pressure is positive");

  BOOST_REQUIRE(document.failed_checks().size() == 1U);
  BOOST_TEST(document.failed_checks()[0].statement == "the pressure is positive");
  BOOST_CHECK_THROW(document.check("sign", true, ""), std::logic_error);
}

BOOST_AUTO_TEST_CASE(a_part_is_appended_in_its_order_with_its_places_and_without_doubles) {
  Document document = document_with(1);
  document.check("first", true, "1");
  Document part;
  part.check("second", true, "2");
  part.value("radius", Value(3, integer()));
  const auto line = part.registered().places.at({"value", "radius"}).line;

  document.append(part);

  BOOST_TEST(document.values().at("radius").printed() == "3");
  BOOST_TEST(document.registered().places.at({"value", "radius"}).line == line);
  BOOST_REQUIRE(document.checks().size() == 2U);
  BOOST_TEST(document.checks()[1].id == "second");
  BOOST_TEST(document.value("radius").printed() == "3");
  BOOST_TEST(message_of<std::invalid_argument>([&] {
               std::ignore = document.value("radios");
             }).ends_with("no value 'radios' is registered, did you mean 'radius'?"));
  const std::string message = message_of<std::logic_error>([&] { document.append(part); });
  BOOST_TEST(holds(message, "check 'second' is registered twice"));
}

BOOST_AUTO_TEST_CASE(the_formula_of_a_limit_is_none_of_the_texts_that_may_hold_no_typed_number) {
  const TemporaryFolder scratch;
  Document document;
  document.claim("order", {.route = "counting",
                           .expected = Verdict::confirmed,
                           .criteria = {Criterion::at_most(
                               "error", Value({0.1, 1e-3}, fixed(2)),
                               Limit::theory("2h", {{"h", 0.25}}, "twice the step, at most"))}});
  document.write(scratch.path());

  const std::vector<NamedText> texts = read_names(scratch / "names.json").texts;
  const auto reason = std::ranges::find_if(
      texts, [](const NamedText& text) { return text.what.starts_with("reason"); });

  BOOST_TEST_REQUIRE((reason != texts.end()));
  BOOST_TEST(reason->latex == "twice the step, at most");
}

BOOST_AUTO_TEST_CASE(the_names_read_back) {
  const TemporaryFolder scratch;
  document_with(1).write(scratch / "out", {{"x", "a.cpp", 3, "a\n"}});

  const Names names = read_names(scratch / "out/names.json");

  BOOST_TEST(names.values.contains("modulus"));
  BOOST_TEST(names.flags.contains("converged"));
  BOOST_TEST(names.tables.contains("results"));
  BOOST_TEST(names.excerpts.contains("x"));
  BOOST_TEST(names.files == sys::files_below(scratch / "out"), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(unchanged_files_keep_their_time_stamps_and_changed_ones_do_not) {
  const TemporaryFolder scratch;
  const fs::path out = scratch / "out";
  document_with(1).write(out);
  for (const auto& file : sys::files_below(out)) age(out / file);
  const auto table_stamp = fs::last_write_time(out / "tables/results.tex");
  const auto values_stamp = fs::last_write_time(out / "values.tex");

  document_with(2).write(out);

  BOOST_CHECK(fs::last_write_time(out / "tables/results.tex") == table_stamp);
  BOOST_CHECK(fs::last_write_time(out / "values.tex") > values_stamp);
  BOOST_TEST(!fs::exists(scratch / "out.part"));
}

BOOST_AUTO_TEST_CASE(files_no_longer_made_are_removed_and_foreign_ones_stay) {
  const TemporaryFolder scratch;
  const fs::path out = scratch / "out";
  document_with(1).write(out);
  sys::write_file_atomically(out / "mine.txt", "mine");

  Document().write(out);

  BOOST_TEST(!fs::exists(out / "tables/results.tex"));
  BOOST_TEST(fs::exists(out / "mine.txt"));
}

BOOST_AUTO_TEST_CASE(files_of_another_version_of_the_engine_are_removed_too) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "out/figures/f.dat", "1 2\n");
  sys::write_file_atomically(scratch / "out/names.json",
                             R"({"figures": ["f"], "files": ["figures/f.dat"]})");

  document_with(1).write(scratch / "out");

  BOOST_TEST(!fs::exists(scratch / "out/figures/f.dat"));
}

BOOST_AUTO_TEST_CASE(a_failure_leaves_the_old_output_untouched) {
  const TemporaryFolder scratch;
  const fs::path out = scratch / "out";
  document_with(1).write(out);
  const std::string before = sys::read_file(out / "values.tex");
  const Excerpt too_long{
      .name = std::string(300, 'x'), .file = "a.cpp", .first_line = 1, .text = "1\n"};

  BOOST_CHECK_THROW(document_with(2).write(out, {too_long}), sys::OutputError);

  BOOST_TEST(sys::read_file(out / "values.tex") == before);
  BOOST_TEST(!fs::exists(scratch / "out.part"));
}

BOOST_AUTO_TEST_CASE(a_stale_staging_folder_is_removed_and_a_foreign_one_is_refused) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "out.part/.literate-staging", "");
  sys::write_file_atomically(scratch / "out.part/old.tex", "old");
  document_with(1).write((scratch / "out").string() + "/");
  BOOST_TEST(!fs::exists(scratch / "out/old.tex"));
  sys::write_file_atomically(scratch / "out.part/thesis.tex", "years of work");

  BOOST_CHECK_THROW(document_with(1).write(scratch / "out"), sys::OutputError);

  BOOST_TEST(sys::read_file(scratch / "out.part/thesis.tex") == "years of work");
}

BOOST_AUTO_TEST_CASE(an_output_that_is_no_folder_is_an_output_error_naming_it) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "out", "a file");

  const std::string message =
      message_of<sys::OutputError>([&] { document_with(1).write(scratch / "out"); });

  BOOST_TEST(holds(message, (scratch / "out").string()));
  BOOST_TEST(sys::read_file(scratch / "out") == "a file");
}

BOOST_AUTO_TEST_SUITE_END()
