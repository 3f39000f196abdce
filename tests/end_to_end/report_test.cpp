// SPDX-License-Identifier: GPL-3.0-or-later
// From a case file to the PDF: what it says, and that nothing but the case decides what it says.
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "report.hpp"

BOOST_AUTO_TEST_SUITE(report_test)

namespace fs = std::filesystem;

namespace {

// Whether a number with its unit is in the text, where its digits stand in groups of three and its
// power of ten is written out.
bool holds_number(std::string text, const std::string& number) {
  std::string set = std::regex_replace(number, std::regex("e(-?\\d+)"), "\u00d710$1");
  std::erase(set, ' ');
  std::erase(text, ' ');
  return holds(text, set);
}

// The report of the case in other units, made once.
const Report& steel_report() {
  static const TemporaryFolder folder;
  static const Report report = [] {
    const Report made{steel_case, folder.path()};
    made.make({.environment = {{"TZ", "UTC"}, {"LC_ALL", "C"}}});
    return made;
  }();
  return report;
}

void check_same_files(const fs::path& one, const fs::path& other) {
  const Words files = sys::files_below(one);
  BOOST_TEST(files == sys::files_below(other), boost::test_tools::per_element());
  for (const std::string& file : files) {
    BOOST_TEST((sys::read_file(one / file) == sys::read_file(other / file)), file << " differs");
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_report_prints_its_values_and_what_it_compares_with) {
  const TemporaryFolder folder;
  const Report report{papers_case, folder.path()};

  report.make();

  const std::string text = report.text();
  BOOST_TEST(!holds(text, "??"));
  for (const char* unit : {" in ", "psi", "lbf/in"}) BOOST_TEST(holds(text, unit), unit);
  for (const char* unit : {" mm ", "MPa"}) BOOST_TEST(!holds(text, unit), unit);
  for (const char* key : {"cylinders.modulus", "cylinders.approach", "line-load"}) {
    BOOST_TEST(holds_number(text, report.printed(key)), key << " = " << report.printed(key));
  }
  // The first point of Fig. 5, analytical and FEA.
  BOOST_TEST(holds_number(text, "1.623605"));
  BOOST_TEST(holds_number(text, "1.594637"));
  BOOST_TEST(holds(text, report.printed("provenance.case-sha256").substr(0, 16)));
}

BOOST_AUTO_TEST_CASE(a_report_in_other_units_has_no_trace_of_the_papers) {
  const Report& report = steel_report();

  const std::string text = report.text();
  BOOST_TEST(!holds(text, "??"));
  for (const char* unit : {" mm", "MPa", "N/mm"}) BOOST_TEST(holds(text, unit), unit);
  for (const char* unit : {" psi", "lbf"}) BOOST_TEST(!holds(text, unit), unit);
  BOOST_TEST(holds(text, "steel_mm.toml"));
  for (const char* key : {"young", "poisson", "half-width", "cylinders.load", "cylinders.datum",
                          "cylinders.modulus", "cylinders.approach"}) {
    BOOST_TEST(holds_number(text, report.printed(key)), key << " = " << report.printed(key));
  }
  // Nothing of the figures and tables either: their labels and headings are generated.
  for (const std::string& file : sys::files_below(report.generated())) {
    if (!file.ends_with(".tex") || file.starts_with("excerpts/")) continue;
    std::string made = sys::read_file(report.generated() / file);
    for (const std::string letter = "\\varepsilon"; holds(made, letter);) {  // ε is no pound
      made.erase(made.find(letter), letter.size());
    }
    for (const char* unit : {"psi", "lbf", "{in}"}) BOOST_TEST(!holds(made, unit), file);
  }
}

BOOST_AUTO_TEST_CASE(two_runs_anywhere_give_the_same_bytes) {
  const Report& first = steel_report();
  const TemporaryFolder elsewhere;
  const fs::path copied_case =
      elsewhere.write("my cases/steel_mm.toml", sys::read_file(steel_case));
  fs::create_directories(elsewhere.path() / "my copy");
  fs::copy(source_dir / "report", elsewhere.path() / "my copy/report", fs::copy_options::recursive);
  const Report second{copied_case, elsewhere.path() / "my output",
                      elsewhere.path() / "my copy/report"};
  fs::create_directory(second.output);

  second.make({.environment = {{"TZ", "Pacific/Kiritimati"},
                               {"LC_ALL", "C.UTF-8"},
                               {"LANG", "tr_TR.UTF-8"},
                               {"HOME", "/nowhere"},
                               {"SOURCE_DATE_EPOCH", "86400"}},
               .folder = elsewhere.path(),
               .umask = "077"});

  check_same_files(first.generated(), second.generated());
  BOOST_TEST((sys::read_file(first.pdf()) == sys::read_file(second.pdf())));
}

BOOST_AUTO_TEST_CASE(a_comma_decimal_locale_changes_nothing) {
  const TemporaryFolder locales;
  const auto made = sys::run({.program = "sh",
                              .arguments = {"-c", "localedef -i de_DE -f UTF-8 \"$1\"", "sh",
                                            (locales.path() / "de_DE.UTF-8").string()}});
  BOOST_TEST_REQUIRE(made.exit_status == 0,
                     "no German locale can be made here: install the Debian package locales");
  const std::map<std::string, std::string> german = {
      {"LOCPATH", locales.path().string()}, {"LC_ALL", "de_DE.UTF-8"}, {"LANGUAGE", "de"}};
  const auto comma =
      sys::run({.program = "sh", .arguments = {"-c", "printf '%.1f' 0,5"}, .environment = german});
  BOOST_TEST_MESSAGE("a German shell prints one half as " << comma.output);
  const Report& in_plain = steel_report();
  const TemporaryFolder folder;
  const Report in_german{steel_case, folder.path()};

  in_german.make({.environment = german});

  check_same_files(in_plain.generated(), in_german.generated());
  BOOST_TEST((sys::read_file(in_plain.pdf()) == sys::read_file(in_german.pdf())));
}

BOOST_AUTO_TEST_CASE(a_second_run_leaves_every_time_stamp) {
  const Report& report = steel_report();
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(24 * 365);
  std::vector<fs::path> made = {report.pdf()};
  for (const std::string& file : sys::files_below(report.generated())) {
    made.push_back(report.generated() / file);
  }
  for (const fs::path& file : made) fs::last_write_time(file, old);

  report.make();

  for (const fs::path& file : made) {
    BOOST_TEST((fs::last_write_time(file) == old), file.string() << " was written again");
  }
}

BOOST_AUTO_TEST_CASE(another_case_changes_what_it_must_and_removes_what_is_no_more) {
  const TemporaryFolder folder;
  const Report papers{papers_case, folder.path()};
  const Report steel{steel_case, folder.path()};
  const Report& fresh = steel_report();

  papers.make();
  BOOST_TEST(fs::exists(papers.generated() / "tables/figure5.tex"));
  steel.make();

  BOOST_TEST(!fs::exists(steel.generated() / "tables/figure5.tex"));
  check_same_files(steel.generated(), fresh.generated());
  BOOST_TEST((sys::read_file(steel.pdf()) == sys::read_file(fresh.pdf())));
}

BOOST_AUTO_TEST_CASE(the_manifest_names_all_files_and_nothing_of_the_machine) {
  const Report& report = steel_report();
  const TemporaryFolder elsewhere;
  const Report second{elsewhere.write("other cases/steel_mm.toml", sys::read_file(steel_case)),
                      elsewhere.path() / "my output"};
  fs::create_directory(second.output);
  second.make({.environment = {{"TZ", "Pacific/Kiritimati"}}});

  auto first = nlohmann::json::parse(report.manifest());
  const auto other = nlohmann::json::parse(second.manifest());
  BOOST_TEST(!holds(report.manifest(), report.output.string()));
  BOOST_TEST(!holds(report.manifest(), source_dir.string()));
  for (const char* file :
       {"report/report.tex", "report/sections/results.tex", "src/literate/document/literate.sty",
        "figures/style.gp", "figures/surface-gradient.gp"}) {
    BOOST_TEST(first["inputs"].contains(file), file);
  }
  for (const char* file : {"report.pdf", "generated/values.tex", "generated/tables/graded.tex",
                           "generated/figures/surface-gradient/script.gp",
                           "generated/figures/surface-gradient/loads.csv"}) {
    BOOST_TEST(first["outputs"].contains(file), file);
  }
  for (const char* name : {"Boost", "CLI11", "Eigen", "FFTW", "GSL", "OpenSSL", "UDUNITS", "fmt",
                           "nlohmann-json", "toml++"}) {
    BOOST_TEST(first["made_with"]["libraries"].contains(name), name);
  }
  // A case goes by its path in the checkout, or from elsewhere by its name.
  BOOST_TEST(first["inputs"]["tests/end_to_end/steel_mm.toml"] == other["inputs"]["steel_mm.toml"]);
  first["inputs"]["steel_mm.toml"] = first["inputs"]["tests/end_to_end/steel_mm.toml"];
  first["inputs"].erase("tests/end_to_end/steel_mm.toml");
  BOOST_TEST((first == other));
}

BOOST_AUTO_TEST_CASE(the_attachments_are_those_that_their_own_list_names) {
  const TemporaryFolder saved;
  const std::string folder = saved.path().string();

  sys::run({.program = "pdfdetach",
            .arguments = {"-saveall", "-o", folder, steel_report().pdf().string()}});
  const sys::ProcessResult checked = sys::run(
      {.program = "sha256sum",
       .arguments = {"--check", "--strict", "--ignore-missing", "--quiet", "attached.sha256"},
       .working_directory = saved.path()});

  BOOST_TEST(checked.exit_status == 0, checked.output);
  for (const std::string& file : sys::files_below(saved.path())) {
    const bool is_listed = file == "attached.sha256" ||
                           holds(sys::read_file(saved / "attached.sha256"), "  " + file + "\n");
    BOOST_TEST(is_listed, file);
  }
}

BOOST_AUTO_TEST_CASE(a_manifest_from_elsewhere_is_compared_by_bytes_then_by_numbers) {
  const Report& report = steel_report();
  const TemporaryFolder folder;
  const std::string theirs = (folder.path() / "theirs.json").string();
  auto manifest = nlohmann::json::parse(report.manifest());
  const auto compared = [&] {
    folder.write("theirs.json", manifest.dump());
    return run_program(report.stage("typeset") + Words{"--against", theirs});
  };

  BOOST_TEST(compared().status == 0);
  manifest["outputs"]["report.pdf"] = "other";
  BOOST_TEST(compared().status == 1);
  BOOST_TEST(holds(compared().errors, "so should the bytes be"));
  manifest["made_with"]["platform"]["compiler"] = "GNU 99";
  BOOST_TEST(compared().status == 0);
  BOOST_TEST(holds(compared().output, "compiler: GNU 99 there, "));
  manifest["numbers"]["cylinders.approach"] = {{"number", 2.385}, {"printed", "2.4 mm"}};
  BOOST_TEST(compared().status == 1);
  BOOST_TEST(holds(compared().errors, "moved: cylinders.approach: 2.385 (2.4 mm) there, "));
  manifest["project"] = "other";
  folder.write("theirs.json", manifest.dump());
  check_refused(2, report.stage("typeset") + Words{"--against", theirs},
                {"theirs.json", "another project"});
}

BOOST_AUTO_TEST_CASE(a_generated_file_that_was_changed_is_refused_by_name) {
  const Report& made = steel_report();
  const TemporaryFolder folder;
  const Report report{steel_case, folder.path()};
  fs::copy(made.output, report.output, fs::copy_options::recursive);
  const Words words = report.stage("typeset");
  BOOST_TEST(run_program(words).status == 0);

  sys::write_file_atomically(report.generated() / "tables/graded.tex", "42");
  check_refused(2, words, {"tables/graded.tex", "was changed after it was made"});
  sys::write_file_atomically(report.generated() / "mine.sty", "");
  check_refused(2, words, {"mine.sty", "was not made by the program"});
}

BOOST_AUTO_TEST_CASE(an_error_in_a_generated_table_is_told_where_the_report_uses_it) {
  const Report& made = steel_report();
  const TemporaryFolder folder;
  const Report report{steel_case, folder.path()};
  fs::copy(made.output, report.output, fs::copy_options::recursive);
  const fs::path table = report.generated() / "tables/graded.tex";
  sys::write_file_atomically(table, sys::read_file(table) + "\n\\nosuchmacro\n");
  output_of(report.stage("draw"));

  const Outcome outcome = run_program(report.stage("typeset"));

  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(
      std::regex_search(outcome.errors,
                        std::regex("^halfspace: report/sections/elements\\.tex:\\d+: in table "
                                   "'graded': Undefined control sequence\\. "
                                   "\\(tables/graded\\.tex:\\d+\\)")),
      outcome.errors);
}

BOOST_AUTO_TEST_SUITE_END()
