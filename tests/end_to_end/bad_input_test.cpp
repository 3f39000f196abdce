// SPDX-License-Identifier: GPL-3.0-or-later
// Users' mistakes and the messages they see: exit code 2, one line on standard error with the
// user's own number and the allowed range, nothing on standard output, nothing written.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(bad_input_test)

namespace {

namespace fs = std::filesystem;

struct Refusal {
  const char* arguments;  // separated by spaces
  const char* message;
};

// Runs in the folder that contains the files of the arguments.
void check(const fs::path& folder, const std::vector<Refusal>& refusals) {
  for (const auto& [arguments, message] : refusals) {
    BOOST_TEST_CONTEXT(arguments) {
      const Outcome outcome = run_program(words_of(arguments), {.folder = folder});
      BOOST_TEST(outcome.status == 2);
      BOOST_TEST(outcome.output == "");
      BOOST_TEST(outcome.errors == std::string("halfspace: ") + message + "\n");
    }
  }
}

void check(const std::vector<Refusal>& refusals) {
  const TemporaryFolder folder;
  check(folder.path(), refusals);
  BOOST_TEST(fs::is_empty(folder.path()));
}

}  // namespace

BOOST_AUTO_TEST_CASE(unknown_commands_and_flags) {
  check({
      {"",
       "a command is missing: displacement, contact, point-contact, stress, block (see halfspace "
       "--help)"},
      {"contct",
       "unknown command contct: displacement, contact, point-contact, stress, block (see halfspace "
       "--help)"},
      {"contact --nodez 5",
       "unknown flag --nodez, did you mean '--nodes'? (see halfspace contact --help)"},
      {"displacement --unit mm-N",
       "unknown flag --unit, did you mean '--units'? (see halfspace displacement --help)"},
      {"contact --friction 0.3", "unknown flag --friction (see halfspace contact --help)"},
      {"contact extra", "unexpected 'extra' (see halfspace contact --help)"},
      {"contact --load 100 --load 200", "--load: At Most 1 required but received 2"},
      {"displacement --x= --young=210000", "--x: the value is missing"},
      {"displacement --x --young 210000", "--x: the value is missing"},
      {"displacement --x", "--x: 1 required LENGTH missing"},
  });
}

BOOST_AUTO_TEST_CASE(unknown_choices) {
  check({
      {"contact --units SI", "--units: SI not in {mm-N,m-N,in-lbf}"},
      {"contact --format xml", "--format: xml not in {table,csv,json}"},
      {"contact --radius1 1 --load 1 --method fast",
       "--method: fast not in {matrix-inversion,variational,fft}"},
      {"contact --radius1 1 --load 1 --element hat",
       "--element: hat not in {triangular,uniform,point}"},
      {"contact --radius1 1 --load 1 --profile wedge",
       "--profile = wedge: must be cylinder or file:PATH"},
      {"point-contact --load 1 --profile cone", "--profile = cone: must be sphere or heights:PATH"},
      {"displacement --shape square",
       "--shape = square: must be one of triangular, uniform, linear:FRACTION, file:PATH, "
       "expression:FORMULA, concentrated"},
      {"block --shape concentrated",
       "--shape = concentrated: must be one of triangular, uniform, linear:FRACTION"},
      {"block --peak-pressure 1 --half-width 1 --width 9 --height 9 --sides glued",
       "--sides: glued not in {clamped,roller,free}"},
      {"displacement --plot out.jpg",
       "--plot = out.jpg: must end with .svg, .png or .pdf, or be -"},
      {"displacement --plot no/out.svg", "--plot = no/out.svg: folder does not exist"},
      {"displacement --plot - --format csv",
       "--plot = -: needs --format table; the plot is printed below the table"},
  });
}

BOOST_AUTO_TEST_CASE(malformed_numbers_and_units_of_a_different_dimension) {
  check({
      {"contact --radius1 10 --load 1,5", "--load: \"1,5\" is not a number"},
      {"contact --radius1 10 --load many", "--load: \"many\" is not a number"},
      {"contact --radius1 10 --load nan", "--load = nan: must be a finite number"},
      {"contact --radius1 10 --load -inf", "--load = -inf: must be a finite number"},
      {"contact --radius1 10 --load 1e999", "--load: \"1e999\" is beyond the range of a double"},
      {"contact --radius1 10 --load 100N", "--load: \"N\" cannot be converted into \"N/mm\""},
      {"contact --radius1 10 --load 100Nm/parsek", "--load: unknown unit \"Nm/parsek\""},
      {"contact --radius1 10psi --load 1", "--radius1: \"psi\" cannot be converted into \"mm\""},
      {"contact --radius1 10 --load 1 --young 210GPa --poisson 0.3mm",
       "--poisson = 0.3mm: must be a plain number"},
      {"contact --radius1 10 --load 1 --nodes 41.5", "--nodes = 41.5: must be a whole number"},
      {"contact --radius1 10 --load 1 --nodes 2", "--nodes = 2: must be from 10 to 16777216"},
      {"contact --radius1 10 --load 1 --nodes 99999999999999999999",
       "--nodes = 99999999999999999999: must be from 10 to 16777216"},
      {"point-contact --radius1 10 --load 1 --nodes 20000",
       "--nodes = 20000: must be from 8 to 8192"},
      {"block --order 11 --peak-pressure 1 --half-width 1 --width 9 --height 9",
       "--order = 11: must be from 4 to 10"},
  });
}

BOOST_AUTO_TEST_CASE(quantities_out_of_range) {
  check({
      {"contact --radius1 10 --load 0", "--load = 0: must be greater than 0"},
      {"contact --radius1 10 --load=-7N/mm", "--load = -7N/mm: must be greater than 0"},
      {"contact --radius1 0 --load 1", "--radius1 = 0: must not be 0; write 'plane' for a plane"},
      {"contact --radius1 10 --load 1 --young1 -3 --poisson1 0.3",
       "--young1 = -3: must be greater than 0"},
      {"contact --radius1 10 --load 1 --young1 3 --poisson1 3",
       "--poisson1 = 3: must be between -1 and 0.5, both excluded"},
      {"displacement --half-width 1 --peak-pressure 1 --young 3 --poisson 0.5",
       "--poisson = 0.5: must be between -1 and 0.5, both excluded"},
      {"contact --radius1 10 --radius2 -5 --load 1",
       "1/radius1 + 1/radius2 = -0.1: must be greater than 0: at most one plane, and a hollow "
       "only if wider than the cylinder in it"},
      {"contact --radius1 plane --load 1",
       "1/radius1 + 1/radius2 = 0: must be greater than 0: at most one plane, and a hollow "
       "only if wider than the cylinder in it"},
      {"point-contact --radius1 10 --radius2 -9 --load 1",
       "1/radius1 + 1/radius2 = -0.0111111 along x and -0.0111111 along y: both must be greater "
       "than 0"},
      {"displacement --peak-pressure -5MPa --half-width 1",
       "--peak-pressure = -5MPa: must be greater than 0"},
      {"displacement --peak-pressure 1 --half-width 0", "--half-width = 0: must be greater than 0"},
      {"displacement --peak-pressure 1 --half-width 1 --datum 0",
       "--datum = 0: must be greater than 0"},
      {"displacement --peak-pressure 1 --half-width 1 --shape linear:-1",
       "--shape = linear:-1: the fraction must be 0 or greater"},
      {"block --peak-pressure 1 --half-width 3 --width 4 --height 4",
       "--width = 4: must be at least 6 mm, the width of the load"},
      {"stress --radius1 10 --load 1 --z=-1", "--z = -1: depths must be 0 or greater"},
      {"contact --radius1 10 --load 100 --domain 0.1",
       "--domain = 0.1: must be greater than 0.210093 mm, the width of Hertz's contact"},
      {"point-contact --radius1 10 --load 100 --domain 0.1",
       "--domain = 0.1: must be greater than 0.373251 mm, the width of Hertz's contact"},
      {"contact --radius1 10 --load 100 --method fft --tolerance 1e-15",
       "tolerance = 1e-15: must be from 1e-13, the rounding error, to 0.01"},
      {"point-contact --radius1 10 --load 100 --tolerance 1e-15",
       "tolerance = 1e-15: must be from 1e-12, the rounding error, to 0.01"},
  });
}

BOOST_AUTO_TEST_CASE(lists_and_ranges) {
  const std::string load = "displacement --peak-pressure 1 --half-width 1 --x ";
  const std::vector<std::pair<std::string, std::string>> lists = {
      {"0,,1", "--x = 0,,1: a number is missing"},
      {"1,", "--x = 1,: a number is missing"},
      {"0;1", "--x: \"0;1\" is not a number"},
      {"0,inf", "--x = inf: must be a finite number"},
      {"0:1", "--x = 0:1: a range must be BEGIN:END:STEP"},
      {"0:1:-0.1", "--x = 0:1:-0.1: STEP of BEGIN:END:STEP must lead from BEGIN to END"},
      {"0:1:0", "--x = 0:1:0: a range has at most 1000000 points"},
      {"0:1:1e-9", "--x = 0:1:1e-9: a range has at most 1000000 points"},
  };
  for (const auto& [list, message] : lists) check({{(load + list).c_str(), message.c_str()}});
}

BOOST_AUTO_TEST_CASE(all_missing_flags_are_listed) {
  check({
      {"contact", "--radius1 and --load are missing"},
      {"contact --load 100", "--radius1 is missing"},
      {"displacement", "--peak-pressure and --half-width are missing"},
      {"displacement --shape concentrated", "--line-load is missing"},
      {"displacement --shape concentrated --line-load 1", "--x is missing"},
      {"displacement --shape expression:p0 --half-width 1",
       "--peak-pressure, p0 in the formula, is missing"},
      {"block --peak-pressure 1 --half-width 1", "--width and --height are missing"},
      {"point-contact", "--radius1 and --load are missing"},
      {"point-contact --load 1 --radius1x 3", "--radius1y is missing"},
  });
}

BOOST_AUTO_TEST_CASE(flags_that_are_meaningless_for_the_choice) {
  const TemporaryFolder folder;
  folder.write("gap.csv", "x,gap\n-1,1\n0,0\n1,1\n2,4\n");
  folder.write("load.csv", "x,pressure\n0,0\n1,1\n");
  check(
      folder.path(),
      {
          {"contact --profile file:gap.csv --load 1 --radius1 3",
           "--radius1 has no meaning for --profile file:gap.csv"},
          {"contact --radius1 10 --load 1 --tolerance 1e-8",
           "--tolerance has no meaning for --method matrix-inversion"},
          {"displacement --shape file:load.csv --half-width 3",
           "--half-width has no meaning for --shape file:load.csv"},
          {"displacement --shape uniform --line-load 3",
           "--line-load has no meaning for --shape uniform"},
          {"displacement --shape concentrated --line-load 3 --x 1 --datum 9 --component tangential",
           "--component = tangential: has no meaning for --shape concentrated"},
          {"stress --shape uniform --peak-pressure 1 --half-width 1 --radius1 3",
           "--radius1 has no meaning for --shape uniform"},
          {"stress --shape uniform --peak-pressure 1 --half-width 1 --poisson1 0.4",
           "--poisson1 has no meaning for --shape uniform"},
          {"stress --shape uniform --peak-pressure 1 --half-width 1 --datum 3",
           "--datum has no meaning for --shape uniform"},
          {"stress --shape uniform --peak-pressure 1 --half-width 1 --element point",
           "--element has no meaning for --shape uniform"},
          {"stress --radius1 10 --load 1 --datum 1", "--datum has no meaning for stresses"},
          {"stress --radius1 10 --load 1 --half-width 3",
           "--half-width has no meaning for a contact; a pressure needs --shape"},
          {"stress --radius1 10 --load 1 --element uniform",
           "--element = uniform: stresses need triangular elements"},
          {"point-contact --radius1 10 --load 1 --spacing 1",
           "--spacing has no meaning for --profile sphere"},
          {"point-contact --radius1 10 --radius1x 3 --radius1y 3 --load 1",
           "--radius1 has no meaning for a body with two principal radii"},
      });
}

BOOST_AUTO_TEST_CASE(invalid_files_are_rejected_with_the_position_of_the_error) {
  const TemporaryFolder folder;
  const auto check_file = [&](const std::string& text, const char* arguments, const char* message) {
    folder.write("it.csv", text);
    check(folder.path(), {{arguments, message}});
  };
  const char* profile = "contact --load 1 --profile file:it.csv";
  check_file("x,gap\n0,1\n1,0\n0.5,1\n2,2\n", profile,
             "it.csv:4: x = 0.5: must be greater than the x before it, 1");
  check_file("# mine\nx,gap\n0,1\n1,low\n2,1\n3,2\n", profile,
             "it.csv:4:3: \"low\" is not a number");
  check_file("x,gap\n0,1\n1\n2,1\n3,2\n", profile, "it.csv:3: expected 2 numbers (x,gap), found 1");
  check_file("x,gap\n0,1\n1,0\n2,1\n", profile, "it.csv: expected at least 4 points, found 3");
  check_file("x,height\n0,1\n1,2\n", profile, "it.csv:1: the heading must be x,gap");
  check_file("", profile, "it.csv:1: the heading must be x,gap");
  const char* load = "displacement --shape file:it.csv";
  check_file("x,pressure\n0,0\n1,much\n2,0\n", load, "it.csv:3:3: \"much\" is not a number");
  check_file("x,pressure\n0,0\n", load, "it.csv: expected at least 2 points, found 1");
  const char* map = "point-contact --load 1 --spacing 1 --profile heights:it.csv";
  check_file("1,2,3,4\n1,,3,4\n1,2,3,4\n1,2,3,4\n", map, "it.csv:2:3: a number is missing");
  check_file("1,2,3,4\n1,2,3\n1,2,3,4\n1,2,3,4\n", map,
             "it.csv:2: expected 4 numbers as in line 1, found 3");
  check_file("1,2,3\n", map, "it.csv: expected at least 4 lines of 4 numbers, found 1 of 3");
  check(folder.path(), {
                           {"contact --load 1 --profile file:none.csv",
                            "cannot read 'none.csv': No such file or directory"},
                           {"contact --load 1 --profile file:.", ".: is a folder"},
                       });
}

BOOST_AUTO_TEST_CASE(invalid_formulas_are_rejected_with_the_reason) {
  check({
      {"displacement --peak-pressure 1 --half-width 1 --shape expression:p0*(1-(x/a)^4",
       "expression \"p0*(1-(x/a)^4\": Missing parenthesis"},
      {"displacement --peak-pressure 1 --half-width 1 --shape expression:p0*(1-(y/a)^4)",
       "expression \"p0*(1-(y/a)^4)\": Unexpected token \"y\" found at position 7."},
      {"displacement --peak-pressure 1 --half-width 1 --shape expression:p0,a",
       "expression \"p0,a\": 2 formulas, but one is needed"},
      {"displacement --peak-pressure 1 --half-width 1 --shape expression:p0/x",
       "expression \"p0/x\" has no finite value at x = 0"},
  });
}

BOOST_AUTO_TEST_CASE(invalid_cases_are_rejected_with_the_position_of_the_error) {
  const TemporaryFolder folder;
  const std::string paper = sys::read_file(papers_case);
  struct Change {
    const char* before;
    const char* after;
    Words parts;
  };
  const std::vector<Change> changes = {
      {"value = 2500", "value = -2500", {"contact.load", "-2500", "greater than 0"}},
      {"poisson = 0.30\n\n[contact.body2]",
       "poisson = 0.7\n\n[contact.body2]",
       {"poisson", "0.7", "between -1 and 0.5"}},
      {"radius = {value = 1,", "radius = {value = 0,", {"radius", "other than 0"}},
      {"nodes = 91", "nodez = 91", {"contact.nodes: missing; is 'nodez' misspelt?"}},
      {"nodes = 91", "nodes = 91.5", {"contact.nodes", "an integer"}},
      {"unit = \"lbf/in\"", "unit = \"lbf\"", {"contact.load", "\"lbf\""}},
      {"{value = 2500, unit = \"lbf/in\"}", "2500", {"contact.load", "{value = "}},
      {"units = \"in-lbf\"", "units = \"ft-lbf\"", {"units", "ft-lbf", "mm-N"}},
      {"[contact]", "[contct]", {"contact", "missing"}},
  };
  for (const auto& [before, after, parts] : changes) {
    const std::string file = folder.write("my case.toml", with(paper, before, after)).string();
    check_refused({"contact", "--case", file}, parts + Words{file});
  }
  check_refused({"contact", "--case", papers_case.string(), "--units", "mm-N"},
                {"--units = mm-N: the case is in in-lbf"});
  check_refused({"contact", "--case", (folder.path() / "none.toml").string()}, {"none.toml"});
}

BOOST_AUTO_TEST_CASE(contacts_that_the_nodes_do_not_resolve) {
  check_refused(words_of("contact --radius1 10 --load 100 --domain 100"),
                {"nodes in contact", "8 or more", "401", "domain"});
  check_refused(words_of("contact --radius1 10 --load 100 --nodes 20000 --method variational"),
                {"nodes = 20000: must be at most 10000"});
  for (const char* command : {"contact --radius1 10 --load 100 --nodes 15",
                              "point-contact --radius1 10 --load 100 --nodes 14"}) {
    const Outcome coarse = run_program(words_of(command));
    BOOST_TEST(coarse.status == 0);
    BOOST_TEST(coarse.errors.find("warning: only 1") != std::string::npos, coarse.errors);
    BOOST_TEST(coarse.errors.find(" nodes lie across the contact") != std::string::npos);
    BOOST_TEST(coarse.errors.find("accurate to about 1 %") != std::string::npos, coarse.errors);
  }
}

BOOST_AUTO_TEST_CASE(lost_output_is_an_error) {
  if (!fs::exists("/dev/full")) return;
  const auto result =
      run_shell(R"("$1" contact --radius1 10 --load 1 >/dev/full)", {HALFSPACE_PROGRAM});

  BOOST_TEST(result.exit_status == 2);
  BOOST_TEST(result.output == "halfspace: cannot write to standard output\n");
}

BOOST_AUTO_TEST_SUITE_END()
