// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/manifest.hpp"

#include <boost/test/unit_test.hpp>

#include "literate/document/document.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(manifest_test)

using namespace literate;

namespace {

Manifest some_manifest() {
  return {.project = "paper",
          .facts = {{"tools", {{"compiler", "GNU 12"}}}},
          .inputs = {{"a.tex", "11"}},
          .outputs = {{"a.pdf", "22"}, {"b.tex", "33"}},
          .numbers = {{"count", {38, std::nullopt, "38"}}, {"u", {2.385e-6, 3e-12, "2.385"}}},
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

  BOOST_TEST(manifest_json(read_manifest(scratch / "m.json", "paper")) == text);
}

BOOST_AUTO_TEST_CASE(numbers_come_from_what_a_document_wrote) {
  const TemporaryFolder scratch;
  Document document;
  document.value("u", Value({1.6236054e-6, 3e-10}, supported(), "in"));
  document.value("words", Value::text("none"));
  document.write(scratch / "out");

  const auto numbers = numbers_in(scratch / "out/names.json");

  BOOST_TEST(numbers.size() == 1U);
  BOOST_TEST(numbers.at("u").number == 1.6236054e-6);
  BOOST_TEST(numbers.at("u").abs_error.value() == 3e-10);
}

BOOST_AUTO_TEST_CASE(numbers_of_tables_and_verdicts_come_from_it_too) {
  const TemporaryFolder scratch;
  Document document;
  Table table("errors", {Column("$N$", integer()), Column("error", significant(2), "in")});
  table.add_row({64, numerics::Estimate{1.2345e-6, 1e-9}});
  document.table(table);
  document.check("finite", true, "all numbers are finite");
  document.write(scratch / "out");

  const auto numbers = numbers_in(scratch / "out/names.json");
  const auto verdicts = verdicts_in(scratch / "out/names.json");

  BOOST_TEST(numbers.at("table errors, row 1, column 1").printed == "64");
  BOOST_TEST(numbers.at("table errors, row 1, column 2").number == 1.2345e-6);
  BOOST_TEST(numbers.at("table errors, row 1, column 2").abs_error.value() == 1e-9);
  BOOST_TEST(numbers.at("table errors, row 1, column 2").printed == "1.2");
  BOOST_TEST((verdicts == Manifest::Texts{{"check finite", "passed"}}));
}

BOOST_AUTO_TEST_CASE(what_is_no_manifest_of_the_project_is_named) {
  const TemporaryFolder scratch;
  const auto file = scratch / "m.json";

  BOOST_TEST(message_of_reading(file).find("cannot read") != std::string::npos);
  sys::write_file_atomically(file, "{");
  BOOST_TEST(message_of_reading(file).ends_with("m.json' is not JSON"));
  sys::write_file_atomically(file, "[1]");
  BOOST_TEST(message_of_reading(file).ends_with("m.json' is not a manifest"));
  sys::write_file_atomically(file, R"({"project": "paper", "outputs": 1})");
  BOOST_TEST(message_of_reading(file).ends_with("m.json' is not a manifest"));
  sys::write_file_atomically(file, R"({"project": "other"})");
  BOOST_TEST(message_of_reading(file).ends_with("is the manifest of another project, \"other\""));
}

BOOST_AUTO_TEST_SUITE_END()
