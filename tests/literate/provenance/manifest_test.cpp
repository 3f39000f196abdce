// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/manifest.hpp"

#include <boost/test/unit_test.hpp>

#include "holds.hpp"
#include "literate/document/document.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(manifest_test)

using namespace literate;
using Lines = std::vector<std::string>;
using boost::test_tools::per_element;

namespace {

Manifest some_manifest() {
  return {.project = "paper",
          .facts = {{"tools", {{"compiler", "GNU 12"}}}},
          .inputs = {{"a.tex", "11"}},
          .outputs = {{"a.pdf", "22"}, {"b.tex", "33"}},
          .numbers = {{"count", {38, std::nullopt, "38"}},
                      {"lean", {1.5, 0.3, "1.5", 0, std::pair(0.2, 0.3)}},
                      {"u", {2.385e-6, 3e-12, "2.385 in", 0, {}, "in"}}},
          .verdicts = {{"claim it-holds", "confirmed"}}};
}

std::string message_of_reading(const std::filesystem::path& file) {
  return message_of<sys::OutputError>([&] { read_manifest(file, "paper"); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_manifest_reads_back_as_it_was_written) {
  const TemporaryFolder scratch;
  const std::string text = manifest_json(some_manifest());
  sys::write_file_atomically(scratch / "m.json", text);

  const Manifest read = read_manifest(scratch / "m.json", "paper");
  BOOST_TEST(manifest_json(read) == text);
  BOOST_TEST(read.numbers.at("u").unit.value() == "in");
  BOOST_TEST(read.numbers.at("count").unit.value() == "");
}

BOOST_AUTO_TEST_CASE(numbers_come_from_what_a_document_wrote) {
  const TemporaryFolder scratch;
  Document document;
  document.value("u", Value({1.6236054e-6, 3e-10}, supported(), "in"));
  document.value("words", Value::text("none"));
  document.value("lean", Value(1.5, Uncertainty::to_sides(0.2, 0.3), uncertain(), "s"));
  document.write(scratch / "out");

  const auto numbers = results_in(scratch / "out/names.json", "paper").numbers;

  BOOST_TEST(numbers.size() == 2U);
  BOOST_TEST((numbers.at("lean").sides == std::pair(0.2, 0.3)));
  BOOST_TEST(numbers.at("u").number == 1.6236054e-6);
  BOOST_TEST(numbers.at("u").abs_error.value() == 3e-10);
  BOOST_TEST(numbers.at("u").unit.value() == "in");
}

BOOST_AUTO_TEST_CASE(what_the_law_of_propagation_neglects_is_in_the_bound_where_it_does_not_hold) {
  const TemporaryFolder folder;
  Document document;
  document.value("y", Value(cos(numerics::Measured(0, 0.3, "angle")), uncertain()));
  document.value("z", Value(numerics::Measured(2, 0.3, "length"), uncertain()));
  document.write(folder.path());

  const auto numbers = results_in(folder / "names.json", "rod").numbers;

  BOOST_TEST(numbers.at("y").printed == "1.000 ± 0.045");
  BOOST_TEST(*numbers.at("y").abs_error >= 0.045);
  BOOST_TEST(*numbers.at("y").abs_error <= 0.0451);
  BOOST_TEST(*numbers.at("z").abs_error == 0);
}

BOOST_AUTO_TEST_CASE(the_words_of_routes_reasons_headings_notes_and_faults_come_from_it) {
  const TemporaryFolder scratch;
  Document document;
  Table table("errors", {Column("$N$", integer()), Column("error", significant(2), "in")});
  table.add_row({64, numerics::Estimate{1.2345e-6, 1e-9}});
  table.note("on one grid");
  document.table(table);
  document.claim("small", {.route = "by hand",
                           .expected = Verdict::confirmed,
                           .criteria = {Criterion::at_most("error", Value(0.5, exact()),
                                                           {LimitKind::data, 1, "printed"})}});
  document.check("finite", true, "all numbers are finite");
  document.severity(Severity{.n_faults = 3, .n_turning = {{"small", 2}}});
  document.write(scratch / "out");

  const Manifest::Texts expected = {{"check finite: statement", "all numbers are finite"},
                                    {"claim small: error: margin", "2.0 times"},
                                    {"claim small: error: reason", "data: printed"},
                                    {"claim small: planted faults", "2 of 3 faults"},
                                    {"claim small: route", "by hand"},
                                    {"table errors: headings", "N | error (in)"},
                                    {"table errors: notes", "on one grid"}};
  BOOST_TEST((results_in(scratch / "out/names.json", "paper").words == expected));
}

BOOST_AUTO_TEST_CASE(numbers_of_tables_and_verdicts_come_from_it_too) {
  const TemporaryFolder scratch;
  Document document;
  Table table("errors", {Column("$N$", integer()), Column("error", significant(2), "in")});
  table.add_row({64, numerics::Estimate{1.2345e-6, 1e-9}});
  document.table(table);
  document.check("finite", true, "all numbers are finite");
  document.write(scratch / "out");

  const Manifest results = results_in(scratch / "out/names.json", "paper");
  const auto& numbers = results.numbers;

  BOOST_TEST(numbers.at("table errors, row 1, column 1").printed == "64");
  BOOST_TEST(numbers.at("table errors, row 1, column 2").number == 1.2345e-6);
  BOOST_TEST(numbers.at("table errors, row 1, column 2").abs_error.value() == 1e-9);
  BOOST_TEST(numbers.at("table errors, row 1, column 2").printed == "1.2e-6");
  BOOST_TEST((results.verdicts == Manifest::Texts{{"check finite", "passed"}}));
}

BOOST_AUTO_TEST_CASE(what_is_no_manifest_of_the_project_is_named) {
  const TemporaryFolder scratch;
  const auto file = scratch / "m.json";

  BOOST_TEST(holds(message_of_reading(file), "cannot read"));
  sys::write_file_atomically(file, "{");
  BOOST_TEST(message_of_reading(file).ends_with("m.json' is not JSON"));
  sys::write_file_atomically(file, "[1]");
  BOOST_TEST(message_of_reading(file).ends_with("m.json' is not a manifest"));
  sys::write_file_atomically(file, R"({"project": "paper", "outputs": 1})");
  BOOST_TEST(message_of_reading(file).ends_with("m.json' is not a manifest"));
  sys::write_file_atomically(file, R"({"project": "other"})");
  BOOST_TEST(message_of_reading(file).ends_with("is the manifest of another project, \"other\""));
}

BOOST_AUTO_TEST_CASE(the_same_manifest_has_no_differences) {
  const ManifestComparison found = compare(some_manifest(), some_manifest());
  BOOST_TEST(found.has_same_results);

  BOOST_TEST(found.changed_outputs.empty());
  BOOST_TEST(found.reasons.empty());
  BOOST_TEST(found.moved.empty());
}

BOOST_AUTO_TEST_CASE(differences_are_named_with_both_sides) {
  const Manifest theirs = some_manifest();
  Manifest ours = some_manifest();
  ours.facts["tools"] = {{"compiler", "GNU 13"}, {"linker", "gold"}};
  ours.inputs = {{"a.tex", "12"}, {"new.tex", "1"}};
  ours.outputs["a.pdf"] = "23";
  ours.outputs.erase("b.tex");

  const ManifestComparison found = compare(theirs, ours);

  BOOST_TEST(found.changed_outputs == (Lines{"a.pdf", "b.tex"}), per_element());
  BOOST_TEST(found.reasons ==
                 (Lines{"compiler: GNU 12 there, GNU 13 here", "linker: none there, gold here",
                        "a.tex: another content", "new.tex: only here"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(a_number_may_move_within_the_sum_of_the_two_errors) {
  const Manifest theirs = some_manifest();
  Manifest ours = some_manifest();
  ours.numbers["u"].number += 5.9e-12;
  BOOST_TEST(!compare(theirs, ours).has_same_results);
  BOOST_TEST(compare(theirs, ours).moved.empty());

  ours.numbers["u"].number += 0.2e-12;

  BOOST_TEST(compare(theirs, ours).moved.size() == 1U);
  BOOST_TEST(compare(theirs, ours).moved.front().starts_with("u: 2.385e-06 (2.385 in) there, "));
}

BOOST_AUTO_TEST_CASE(a_number_that_moves_by_just_both_errors_agrees) {
  Manifest theirs = some_manifest(), ours = some_manifest();
  theirs.numbers["u"] = {2.5, 0.05, "2.50"};
  ours.numbers["u"] = {2.6, 0.05, "2.60"};  // as doubles they are farther apart than 0.1
  BOOST_TEST(compare(theirs, ours).moved.empty());
}

BOOST_AUTO_TEST_CASE(a_number_may_move_to_a_side_by_the_bounds_to_that_side) {
  const Manifest theirs = some_manifest();
  Manifest ours = some_manifest();
  ours.numbers["lean"] = {1.7, 0.1, "1.7"};
  BOOST_TEST(compare(theirs, ours).moved.empty());
  ours.numbers["lean"] = {1.15, 0.1, "1.2"};

  BOOST_TEST(compare(theirs, ours).moved.size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_number_in_another_unit_is_another) {
  Manifest other = some_manifest();
  other.numbers["u"].unit = "cm";
  other.numbers["u"].printed = "2.385 cm";
  BOOST_TEST(compare(some_manifest(), other).moved ==
                 Lines{"u: 2.385e-06 (2.385 in) there, 2.385e-06 (2.385 cm) here"},
             per_element());
  other.numbers["u"] = some_manifest().numbers.at("u");
  other.numbers["u"].unit = {};  // as of an earlier version
  BOOST_TEST(compare(some_manifest(), other).moved.empty());
}

BOOST_AUTO_TEST_CASE(a_unit_is_told_once) {
  Manifest theirs = some_manifest(), ours = some_manifest();
  theirs.numbers = {{"table t, row 1, column 2", {3, 0.1, "3.0", 0, {}, "in"}},
                    {"w", {106.2, 0.1, "106.2 s²/(kg m²)", 0, {}, "s2/(kg m2)"}}};
  ours.numbers.clear();
  BOOST_TEST(
      compare(theirs, ours).moved == (Lines{"table t, row 1, column 2: 3 (3.0 in) there, none here",
                                            "w: 106.2 (106.2 s²/(kg m²)) there, none here"}),
      per_element());
}

BOOST_AUTO_TEST_CASE(a_number_without_an_error_is_compared_as_printed) {
  const Manifest theirs = some_manifest();
  Manifest ours = some_manifest();
  ours.numbers["count"].number += 1e-13;
  BOOST_TEST(compare(theirs, ours).moved.empty());

  ours.numbers["count"] = {39, std::nullopt, "39"};
  ours.numbers.erase("u");

  BOOST_TEST(compare(theirs, ours).moved == (Lines{"count: 38 (38) there, 39 (39) here",
                                                   "u: 2.385e-06 (2.385 in) there, none here"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(another_verdict_is_named) {
  Manifest ours = some_manifest();
  ours.verdicts["claim it-holds"] = "refuted";

  BOOST_TEST(compare(some_manifest(), ours).moved ==
                 (Lines{"claim it-holds: confirmed there, refuted here"}),
             per_element());
}

BOOST_AUTO_TEST_SUITE_END()
