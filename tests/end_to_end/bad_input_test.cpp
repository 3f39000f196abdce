// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of bad input: exit code 2, one line on standard error that names the quantity, its
// value and what is allowed, nothing on standard output, no output touched.
#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(bad_input_test)

namespace fs = std::filesystem;

namespace {

using Flags = std::vector<std::pair<std::string, std::string>>;

const Flags papers_displacement = {{"--x", "0,0.005"},       {"--young", "30e6"},
                                   {"--poisson", "0.3"},     {"--peak-pressure", "1000"},
                                   {"--half-width", "0.01"}, {"--datum", "10"}};
const Flags papers_contact = {{"--load", "2500"},    {"--radius1", "1"},    {"--radius2", "3"},
                              {"--young1", "30e6"},  {"--poisson1", "0.3"}, {"--young2", "30e6"},
                              {"--poisson2", "0.3"}, {"--nodes", "41"}};
const Words concentrated = {"displacement", "--young", "30e6",    "--poisson",   "0.3",
                            "--datum",      "10",      "--shape", "concentrated"};
const Words coarse_block = {"block",    "--case", papers_case.string(), "--order", "2",
                            "--refine", "0"};

// The flags as words, one of them with another value; an empty value leaves the flag out.
Words with_flag(const std::string& command, const Flags& flags, const std::string& flag,
                const std::string& value) {
  Words words = {command};
  for (const auto& [name, given] : flags) {
    const std::string& used = name == flag ? value : given;
    if (!used.empty()) words.push_back(name + "=" + used);
  }
  return words;
}

void check_displacement(const std::string& flag, const std::string& value, const Words& parts) {
  check_refused(2, with_flag("displacement", papers_displacement, flag, value), parts);
}

void check_contact(const std::string& flag, const std::string& value, const Words& parts) {
  check_refused(2, with_flag("contact", papers_contact, flag, value), parts);
}

// The paper's case with one change is refused by the report, at its place in the file, and nothing
// is written.
void check_report_case(const fs::path& file, const Words& parts) {
  const fs::path output = file.parent_path() / "out";
  check_refused(2, ReportSettings{file, output}.stage("compute"),
                parts + Words{file.string() + ":"});
  BOOST_TEST(!fs::exists(output / "generated"));
  BOOST_TEST(!fs::exists(output / "generated.part"));
}

fs::path changed_case(const TemporaryFolder& folder, const std::string& before,
                      const std::string& after) {
  return folder.write("my case.toml", with(sys::read_file(papers_case), before, after));
}

// The same, and by the other commands that read a case.
void check_case(const std::string& before, const std::string& after, const Words& parts) {
  const TemporaryFolder folder;
  const fs::path file = changed_case(folder, before, after);

  BOOST_TEST_CONTEXT(after) {
    check_refused(2, {"displacement", "--case", file.string()}, parts);
    check_refused(2, {"contact", "--case", file.string()}, parts);
    check_report_case(file, parts);
  }
}

// «:line:column: » of the first place of a text in the paper's case.
std::string place_of(const std::string& text) {
  const std::string all = sys::read_file(papers_case);
  const auto at = all.find(text);
  BOOST_TEST_REQUIRE((at != std::string::npos));
  const auto line =
      std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
  const auto begin = all.rfind('\n', at) + 1;
  return fmt::format(":{}:{}: ", line, at - begin + 1);
}

Words report_to(const fs::path& output) {
  return ReportSettings{steel_case, output}.stage("compute");
}

}  // namespace

BOOST_AUTO_TEST_CASE(materials_out_of_range_are_refused) {
  for (const char* value : {"0.5", "-1", "0.7", "-2"}) {
    check_displacement("--poisson", value, {"poisson", value, "between -1 and 0.5"});
    check_contact("--poisson1", value, {"poisson", value, "between -1 and 0.5"});
    check_contact("--poisson2", value, {"poisson", value, "between -1 and 0.5"});
  }
  for (const char* value : {"0", "-30"}) {
    check_displacement("--young", value, {"young", value, "greater than 0"});
    check_contact("--young1", value, {"young", value, "greater than 0"});
    check_contact("--young2", value, {"young", value, "greater than 0"});
  }
}

BOOST_AUTO_TEST_CASE(loads_and_lengths_that_are_not_positive_are_refused) {
  for (const char* value : {"0", "-7"}) {
    check_displacement("--peak-pressure", value, {"peak_pressure", value, "greater than 0"});
    check_displacement("--half-width", value, {"half_width", value, "greater than 0"});
    check_displacement("--datum", value, {"datum", value, "greater than 0"});
    check_contact("--load", value, {"load", value, "greater than 0"});
  }
  check_refused(2, concentrated + Words{"--x", "1", "--line-load=-7"},
                {"line_load", "-7", "greater than 0"});
}

BOOST_AUTO_TEST_CASE(shapes_that_do_not_touch_along_a_line_are_refused) {
  check_contact("--radius1", "0", {"radius1", "0", "other than 0"});
  check_contact("--radius2", "0", {"radius2", "0", "other than 0"});
  check_contact("--radius2", "-1", {"1/radius1 + 1/radius2", "= 0", "greater than 0"});
  check_contact("--radius2", "-0.5", {"1/radius1 + 1/radius2", "= -1", "greater than 0"});
  check_contact("--radius2", "flat", {"radius2", "flat"});
}

BOOST_AUTO_TEST_CASE(numbers_of_nodes_that_no_grid_has_are_refused) {
  for (const char* value : {"4", "0", "-41", "16777217"}) {
    check_contact("--nodes", value, {"nodes", value, "from 5 to 16777216", "GB"});
  }
  for (const char* value : {"41.5", "many"}) check_contact("--nodes", value, {"nodes", value});
  check_contact("--nodes", "99999999999999999999", {"nodes"});
}

BOOST_AUTO_TEST_CASE(what_is_not_a_finite_number_is_refused_by_every_flag) {
  for (const char* value : {"nan", "inf", "-inf", "1e999", "abc", "1,5", "30e6psi", "0x10"}) {
    for (const char* flag :
         {"--young", "--poisson", "--peak-pressure", "--half-width", "--datum"}) {
      check_displacement(flag, value, {flag, value});
    }
    for (const char* flag :
         {"--load", "--radius1", "--radius2", "--young1", "--poisson1", "--young2", "--poisson2"}) {
      check_contact(flag, value, {flag, value});
    }
  }
}

BOOST_AUTO_TEST_CASE(malformed_lists_of_points_are_refused) {
  check_displacement("--x", "0,,1", {"--x", "\"\"", "not a number"});
  check_displacement("--x", "abc", {"--x", "\"abc\"", "not a number"});
  check_displacement("--x", "1,", {"--x", "missing"});
  for (const char* list : {",1", ",", "0;1", "0 1", "0,nan", "0,inf", "0,1e999", "0,1x"}) {
    check_displacement("--x", list, {"--x"});
  }
}

BOOST_AUTO_TEST_CASE(files_of_points_that_cannot_be_used_are_refused_by_name) {
  const TemporaryFolder folder;
  const Words command = with_flag("displacement", papers_displacement, "--x", "");
  const auto refused = [&](const fs::path& file, const Words& parts) {
    check_refused(2, command + Words{"--x-file", file.string()}, parts);
  };

  refused(folder.path() / "none.txt", {(folder.path() / "none.txt").string(), "cannot be read"});
  refused(folder.path(), {folder.path().string(), "cannot be read"});
  refused(folder.write("empty.txt", ""), {"empty.txt", "no number"});
  refused(folder.write("wrong.txt", "0\n# in\n0,5\n"), {"wrong.txt:3: ", "\"0,5\""});
  refused(folder.write("nan.txt", "0\nnan\n"), {"nan.txt:2", "nan", "finite"});
  check_refused(2, command + Words{"--x-file", "-"}, {"no number"});
  check_refused(2, command + Words{"--x-file", "-"}, {"<stdin>:2: ", "\"x\""}, {.input = "0\nx\n"});
  check_refused(2, command + Words{"--x", "0", "--x-file", "-"}, {"--x", "--x-file"});
}

BOOST_AUTO_TEST_CASE(points_where_the_result_is_infinite_are_refused) {
  const Words uniform = with_flag("displacement", papers_displacement, "--x", "-0.01");
  check_refused(2, uniform + Words{"--shape", "uniform"}, {"x = -0.01", "off the"});
  check_refused(2, concentrated + Words{"--x", "0", "--line-load", "10"},
                {"x = 0", "off the concentrated force"});
}

BOOST_AUTO_TEST_CASE(a_missing_parameter_is_named) {
  for (const auto& [flag, value] : papers_displacement) {
    check_displacement(flag, "", {flag});
  }
  for (const auto& [flag, value] : papers_contact) check_contact(flag, "", {flag, "missing"});
  check_refused(2, {"compute"}, {"SETTINGS"});
}

BOOST_AUTO_TEST_CASE(unknown_commands_flags_and_choices_are_refused_by_name) {
  check_refused(2, {}, {"subcommand"});
  check_refused(2, {"displace"}, {"displace"});
  check_refused(2, {"displacement", "--yuong", "30e6"},
                {"--yuong", "halfspace displacement --help"});
  check_refused(2, {"displacement", "--help-all"}, {"--help-all"});
  check_displacement("--young", "30e6 psi", {"30e6 psi"});
  const Words command = with_flag("displacement", papers_displacement, "", "");
  check_refused(2, command + Words{"--format", "xml"}, {"--format", "xml", "csv"});
  check_refused(2, command + Words{"--shape", "square"}, {"--shape", "square", "triangular"});
  check_refused(2, command + Words{"--units", "furlong"}, {"furlong", "mm-N"});
  check_refused(2, command + Words{"--young", "30e6"}, {"--young"});
  check_refused(2, command + Words{"extra"}, {"extra"});
}

BOOST_AUTO_TEST_CASE(values_of_a_case_out_of_range_are_refused_at_their_place) {
  check_case("value = 30e6", "value = -30e6",
             {place_of("{value = 30e6"), "young", "greater than 0"});
  check_case("poisson = 0.30", "poisson = 0.5",
             {place_of("0.30"), "poisson", "0.5", "between -1 and 0.5"});
  check_case("value = 1000", "value = 0", {place_of("{value = 1000"), "peak_pressure", "greater"});
  check_case("value = 0.010", "value = -1", {place_of("{value = 0.010"), "half_width", "greater"});
  check_case("datum = {value = 10", "datum = {value = 0", {":10:", "datum", "greater than 0"});
  check_case("value = 2500", "value = -2500", {place_of("{value = 2500"), "load", "greater"});
  check_case("nodes = 91", "nodes = 3", {place_of("91"), "nodes", "3", "from 5 to 16777216"});
  check_case("count = 11", "count = 1", {place_of("11\n"), "count", "1", "from 2 to 1000"});
  check_case("radius = {value = 1,", "radius = {value = 0,",
             {place_of("{value = 1, unit = \"in\"}\n[contact.body1"), "radius", "other than 0"});
  check_case("radius = {value = 3,", "radius = {value = -1,",
             {"body2", "1/radius1 + 1/radius2", "greater than 0"});
  check_case("value = 30e6", "value = nan", {place_of("30e6"), "young", "finite"});
  check_case("value = 30e6", "value = inf", {place_of("30e6"), "young", "finite"});
}

BOOST_AUTO_TEST_CASE(what_the_commands_can_solve_may_be_too_much_for_the_report) {
  const TemporaryFolder folder;
  check_report_case(changed_case(folder, "nodes = 91", "nodes = 1002"),
                    {place_of("91"), "contact.nodes", "from 7 to 401 for the report"});
  check_report_case(changed_case(folder, "refine = 1", "refine = 4"),
                    {place_of("1\n\n# What"), "block.refine", "from 0 to 3 for the report"});
}

BOOST_AUTO_TEST_CASE(missing_unknown_and_doubled_keys_of_a_case_are_refused_at_their_place) {
  check_case("poisson = 0.30\n\n[half_space.load]", "\n[half_space.load]",
             {"half_space.material.poisson", "missing"});
  check_case("poisson = 0.30", "poisson = 0.30\npoison = 0.3", {":15:1: ", "poison", "unknown"});
  check_case("poisson = 0.30", "poisson = 0.30\npoisson = 0.3", {":15:", "poisson"});
  check_case("[contact.body1]", "[contact.body0]\n[contact.body1]", {"body0", "unknown"});
  check_case("value = 30e6,", "value = 30e6, valeu = 1,", {"valeu", "unknown"});
}

BOOST_AUTO_TEST_CASE(wrong_types_and_units_of_a_case_are_refused_at_their_place) {
  check_case("poisson = 0.30", "poisson = \"0.30\"", {place_of("0.30"), "poisson", "a number"});
  check_case("nodes = 91", "nodes = 91.5", {place_of("91"), "nodes", "an integer"});
  check_case("{value = 30e6, unit = \"psi\"}", "30e6", {"young", "unit = \"psi\""});
  check_case("{value = 30e6, unit = \"psi\"}", "{value = 30e6}", {"young.unit", "missing"});
  check_case("unit = \"psi\"", "unit = \"in\"", {place_of("\"psi\""), "young.unit", "\"in\""});
  check_case("unit = \"psi\"", "unit = \"blob\"", {place_of("\"psi\""), "young.unit", "blob"});
  check_case("units = \"in-lbf\"", "units = \"ft-lbf\"", {"units", "ft-lbf", "mm-N"});
  check_case("title = ", "title = 7 #", {"title", "a string"});
  check_case("poisson = 0.30", "poisson = 0.3O", {":14:"});
}

BOOST_AUTO_TEST_CASE(a_printed_number_that_is_none_is_refused_by_the_report_which_alone_reads_it) {
  const TemporaryFolder folder;
  check_report_case(changed_case(folder, "\"1.5187874e-006\"", "\"1,5187874e-006\""),
                    {"displacement", "1,5187874e-006"});
}

BOOST_AUTO_TEST_CASE(a_case_that_cannot_be_read_is_refused_by_name) {
  const TemporaryFolder folder;
  for (const fs::path& file : {folder.path() / "none.toml", folder.path()}) {
    check_refused(2, {"displacement", "--case", file.string()}, {file.string()});
    check_refused(2, {"contact", "--case", file.string()}, {file.string()});
    check_refused(2, ReportSettings{file, folder.path() / "out"}.stage("compute"), {file.string()});
  }
  BOOST_TEST(!fs::exists(folder.path() / "out"));
}

BOOST_AUTO_TEST_CASE(other_units_than_those_of_the_case_are_refused) {
  check_refused(2, {"displacement", "--case", papers_case.string(), "--units", "mm-N"},
                {"--units mm-N", "in-lbf"});
}

BOOST_AUTO_TEST_CASE(other_units_than_those_of_the_blocks_case_are_refused) {
  check_refused(2, coarse_block + Words{"--units", "mm-N"}, {"--units mm-N", "in-lbf"});
  check_refused(2, coarse_block + Words{"--units", "mm-N", "--format", "csv"}, {"--units mm-N"});
}

BOOST_AUTO_TEST_CASE(results_that_are_not_finite_are_refused_by_column_and_place) {
  const Words soft = with_flag("displacement", papers_displacement, "--young", "1e-320");
  for (const char* format : {"table", "csv", "json"}) {
    check_refused(2, soft + Words{"--format", format},
                  {"gradient_quadrature at x = 0: not a finite number", "range of a double"});
  }
  for (const char* format : {"table", "csv", "json"}) {
    check_refused(
        2, {"contact", "--case", papers_case.string(), "--datum", "1e308", "--format", format},
        {"approach: not a finite number", "range of a double"});
  }
}

BOOST_AUTO_TEST_CASE(a_flag_with_an_empty_value_is_refused_and_not_left_out) {
  const Words from_case = {"displacement", "--case", papers_case.string()};
  for (const char* flag : {"--x", "--x-file", "--young", "--poisson", "--peak-pressure",
                           "--half-width", "--line-load", "--datum", "--units"}) {
    check_refused(2, from_case + Words{flag, ""}, {flag, "empty", "displacement --help"});
  }
  for (const char* flag : {"--young1", "--poisson2", "--radius1", "--load", "--nodes"}) {
    check_refused(2, {"contact", "--case", papers_case.string(), flag, ""}, {flag, "empty"});
  }
  for (const char* flag : {"--width", "--height", "--sides", "--load", "--ccx", "--vtu"}) {
    check_refused(2, coarse_block + Words{flag, ""}, {flag, "empty"});
  }
}

BOOST_AUTO_TEST_CASE(flags_that_the_shape_makes_no_use_of_are_refused) {
  const Words from_case = {"displacement", "--case", papers_case.string(), "--x", "1"};
  for (const char* shape : {"triangular", "uniform"}) {
    check_refused(2, from_case + Words{"--shape", shape, "--line-load", "10"},
                  {"--line-load", "--shape", shape});
  }
  for (const char* flag : {"--peak-pressure", "--half-width"}) {
    check_refused(2, from_case + Words{"--shape", "concentrated", flag, "1"},
                  {flag, "--shape concentrated"});
  }
}

BOOST_AUTO_TEST_CASE(loads_that_are_wrong_are_refused_by_line_or_column) {
  const Words from_case = {"displacement", "--case", papers_case.string(), "--x", "1", "--shape"};
  const TemporaryFolder folder;
  const std::string file = folder.write("load.csv", "x,pressure\n0,0\n1,much\n2,0\n").string();
  check_refused(2, from_case + Words{"file:" + file}, {file + ":3: ", "pressure", "much"});
  check_refused(2, from_case + Words{"file:/none.csv"}, {"cannot read", "/none.csv", "No such file"});
  check_refused(2, from_case + Words{"expression:p0*(1-(y/a)^4)"}, {"column 8", "y"});
  check_refused(2, from_case + Words{"expression:p0*("}, {"column"});
  check_refused(2, from_case + Words{"expression:p0/x"}, {"no finite value at x = "});
  check_refused(2, from_case + Words{"expression:p0", "--kinks", "1"}, {"--kinks: 1", "under"});
  check_refused(2, from_case + Words{"file:" + file, "--half-width", "1"},
                {"--half-width", "no meaning"});
  check_refused(2, from_case + Words{"triangular", "--kinks", "0.001"}, {"--kinks", "no meaning"});
}

BOOST_AUTO_TEST_CASE(a_file_of_the_block_in_a_folder_that_is_not_there_is_refused) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "none" / "file").string();
  for (const char* flag : {"--ccx", "--vtu"}) {
    check_refused(2, coarse_block + Words{flag, file}, {flag, file, "folder does not exist"});
  }
  BOOST_TEST(sys::files_below(folder.path()).empty());
  BOOST_TEST(!fs::exists(folder.path() / "none"));
}

BOOST_AUTO_TEST_CASE(an_approach_at_a_datum_within_the_grid_is_refused) {
  check_refused(2, with_flag("contact", papers_contact, "", "") + Words{"--datum", "0.001"},
                {"datum", "0.001", "outside the contact"});
}

BOOST_AUTO_TEST_CASE(an_output_folder_that_cannot_be_made_is_refused_and_nothing_is_written) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a file", "mine");
  for (const fs::path& output :
       {file, file / "below", fs::path("/proc/halfspace"), fs::path("/dev/null/halfspace")}) {
    // Nothing on standard output: it is refused before the computation, which prints its time.
    check_refused(2, report_to(output), {output.string()});
  }
  BOOST_TEST(sys::read_file(file) == "mine");
  BOOST_TEST(sys::files_below(folder.path()) == Words{"a file"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_source_folder_without_the_sources_is_refused) {
  const TemporaryFolder folder;
  const fs::path output = folder.path() / "out";
  check_refused(
      2, ReportSettings{papers_case, output, source_dir / "report", folder.path()}.stage("compute"),
      {"src", "no such folder"});
  BOOST_TEST(!fs::exists(output));
}

BOOST_AUTO_TEST_CASE(a_document_or_generated_folder_that_is_not_there_is_refused) {
  const TemporaryFolder folder;
  check_refused(2, ReportSettings{steel_case, folder.path()}.stage("typeset"), {"names.json"});
  BOOST_TEST(!fs::exists(folder.path() / "report.pdf"));
}

BOOST_AUTO_TEST_CASE(output_that_is_lost_is_not_a_success) {
  if (!fs::exists("/dev/full")) return;
  const auto result = sys::run({.program = "sh",
                                .arguments = {"-c", R"("$1" displacement --case "$2" >/dev/full)",
                                              "sh", HALFSPACE_PROGRAM, papers_case.string()}});

  BOOST_TEST(result.exit_status == 2);
  BOOST_TEST(result.output == "halfspace: standard output cannot be written\n");
}

BOOST_AUTO_TEST_SUITE_END()
