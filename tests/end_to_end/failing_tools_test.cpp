// SPDX-License-Identifier: GPL-3.0-or-later
// gnuplot and LaTeX that are missing or fail: exit code 3, their message with file and line, the
// outputs as they were.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(failing_tools_test)

namespace fs = std::filesystem;

namespace {

constexpr int tool_failed = 3;

// A PATH that leads to nothing but the named programs.
class Tools {
 public:
  explicit Tools(const Words& programs) {
    fs::create_directory(folder_.path() / "bin");
    for (const std::string& program : programs) {
      fs::create_symlink(sys::find_tool(program), folder_.path() / "bin" / program);
    }
  }
  // Adds a shell script under a program's name.
  void fake(const std::string& program, const std::string& script) {
    const fs::path file = folder_.write("bin/" + program, "#!/bin/sh\n" + script);
    fs::permissions(file, fs::perms::owner_all);
  }
  Surroundings surroundings() const {
    return {.environment = {{"PATH", (folder_.path() / "bin").string()}}};
  }

 private:
  TemporaryFolder folder_;
};

// A folder for one report and a copy of the document.
class Workplace {
 public:
  fs::path generated() const { return settings_.generated(); }
  fs::path pdf() const { return settings_.pdf(); }
  Words stage(const std::string& name) const { return settings_.stage(name); }

  // The document with a first line added to its introduction.
  void copy_document(const std::string& first_line = "%") const {
    fs::remove_all(settings_.document);
    fs::copy(source_dir / "report", settings_.document, fs::copy_options::recursive);
    const fs::path changed = settings_.document / "sections/introduction.tex";
    sys::write_file_atomically(changed, first_line + "\n" + sys::read_file(changed));
  }

 private:
  TemporaryFolder folder_;
  ReportSettings settings_{steel_case, folder_.path(), folder_.path() / "report"};
};

// The run ends with 3, names `parts` on standard error, and says nothing of success.
void check_tool_failed(const Words& words, const Words& parts, const Surroundings& surroundings) {
  const Outcome outcome = run_program(words, surroundings);
  BOOST_TEST(outcome.status == tool_failed);
  BOOST_TEST(outcome.errors.starts_with("halfspace: "), outcome.errors);
  for (const std::string& part : parts) {
    BOOST_TEST(outcome.errors.find(part) != std::string::npos,
               "\"" << part << "\" is not in: " << outcome.errors);
  }
  BOOST_TEST(outcome.output.find("draw") == std::string::npos);
  BOOST_TEST(outcome.output.find("typeset") == std::string::npos);
}

}  // namespace

BOOST_AUTO_TEST_CASE(gnuplot_that_is_missing_or_refuses_a_figure_leaves_all_figures_as_they_were) {
  // Computed once, since none of the failures may change what is there.
  const Workplace workplace;
  BOOST_TEST_REQUIRE(run_program(workplace.stage("compute")).status == 0);
  const Words computed = sys::files_below(workplace.generated());
  const Words draw = workplace.stage("draw");
  const auto check_undrawn = [&] {
    BOOST_TEST(sys::files_below(workplace.generated()) == computed,
               boost::test_tools::per_element());
    BOOST_TEST(!fs::exists(workplace.generated().string() + ".part"));
  };
  const Tools none({"sh", "pdflatex", "latexmk"});
  check_tool_failed(draw, {"gnuplot is not installed"}, none.surroundings());
  check_undrawn();

  // The real gnuplot, with one wrong command at the end of each script.
  Tools tools({"sh", "env", "setpriv", "pdflatex", "latexmk"});
  tools.fake("gnuplot", "if [ \"$1\" != --version ]; then echo 'plott x' >>script.gp; fi\nexec '" +
                            sys::find_tool("gnuplot").string() + "' \"$@\"\n");
  check_tool_failed(draw,
                    {"figures/cylinder-pressure.gp:", "invalid command", "cylinders_section.cpp:"},
                    tools.surroundings());
  check_undrawn();

  tools.fake("gnuplot", "[ \"$1\" = --version ] || kill -9 $$\n");
  check_tool_failed(draw, {"figures/cylinder-pressure.gp: gnuplot ended with signal"},
                    tools.surroundings());
  check_undrawn();
  tools.fake("gnuplot", "exit 0\n");
  check_tool_failed(draw, {"figures/cylinder-pressure.gp: gnuplot drew nothing"},
                    tools.surroundings());
  check_undrawn();
}

BOOST_AUTO_TEST_CASE(a_report_is_not_typeset_before_its_figures_are_drawn) {
  const Workplace workplace;
  BOOST_TEST_REQUIRE(run_program(workplace.stage("compute")).status == 0);
  workplace.copy_document();

  check_refused(2, workplace.stage("typeset"), {"figure 'cylinder-pressure'", "not drawn"});
  BOOST_TEST(!fs::exists(workplace.pdf()));
}

BOOST_AUTO_TEST_CASE(what_the_prose_names_wrongly_is_bad_input_at_its_place) {
  const Workplace workplace;
  BOOST_TEST_REQUIRE(run_program(workplace.stage("compute")).status == 0);
  BOOST_TEST_REQUIRE(run_program(workplace.stage("draw")).status == 0);
  workplace.copy_document("  \\val{half-widht}");

  check_refused(2, workplace.stage("typeset"),
                {"report/sections/introduction.tex:1:3: ", "unknown value 'half-widht'",
                 "did you mean 'half-width'?"});
  BOOST_TEST(!fs::exists(workplace.pdf()));
}

BOOST_AUTO_TEST_CASE(an_error_of_latex_is_shown_with_file_and_line_and_no_pdf_is_written) {
  const Workplace workplace;
  BOOST_TEST_REQUIRE(run_program(workplace.stage("compute")).status == 0);
  BOOST_TEST_REQUIRE(run_program(workplace.stage("draw")).status == 0);
  workplace.copy_document("\\nosuchmacro");

  check_tool_failed(workplace.stage("typeset"),
                    {"sections/introduction.tex:1: ", "Undefined control sequence"}, {});
  BOOST_TEST(!fs::exists(workplace.pdf()));
}

BOOST_AUTO_TEST_CASE(a_reference_to_nowhere_stops_typesetting_and_mending_it_goes_on) {
  const Workplace workplace;
  BOOST_TEST_REQUIRE(run_program(workplace.stage("compute")).status == 0);
  BOOST_TEST_REQUIRE(run_program(workplace.stage("draw")).status == 0);
  workplace.copy_document("\\cref{eq:nowhere}");

  check_tool_failed(workplace.stage("typeset"), {"eq:nowhere"}, {});
  BOOST_TEST(!fs::exists(workplace.pdf()));
  workplace.copy_document();
  BOOST_TEST(run_program(workplace.stage("typeset")).status == 0);
  BOOST_TEST(fs::exists(workplace.pdf()));
}

BOOST_AUTO_TEST_CASE(without_latex_typesetting_says_so) {
  const Workplace workplace;
  BOOST_TEST_REQUIRE(run_program(workplace.stage("compute")).status == 0);
  BOOST_TEST_REQUIRE(run_program(workplace.stage("draw")).status == 0);
  workplace.copy_document();
  const Tools no_pdflatex({"sh", "latexmk", "gnuplot"});
  const Tools no_latexmk({"sh", "pdflatex", "gnuplot"});

  check_tool_failed(workplace.stage("typeset"), {"pdflatex is not installed"},
                    no_pdflatex.surroundings());
  check_tool_failed(workplace.stage("typeset"), {"latexmk is not installed"},
                    no_latexmk.surroundings());
  BOOST_TEST(!fs::exists(workplace.pdf()));
}

BOOST_AUTO_TEST_SUITE_END()
