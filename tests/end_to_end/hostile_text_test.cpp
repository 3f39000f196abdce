// SPDX-License-Identifier: GPL-3.0-or-later
// Text that means something to TeX or to a shell is printed as it stands, or refused; never run.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <regex>
#include <string>

#include "literate/document/document.hpp"
#include "program.hpp"

BOOST_AUTO_TEST_SUITE(hostile_text_test)

namespace fs = std::filesystem;

namespace {

// A place for one report, and for what an injected command would leave.
struct Workplace {
  TemporaryFolder folder;
  fs::path generated = folder.path() / "generated";
  fs::path pdf = folder.path() / "report.pdf";

  Words stage(const std::string& name, const fs::path& case_file = papers_case,
              const fs::path& document = source_dir / "report") const {
    return ReportSettings{case_file, folder.path(), document}.stage(name);
  }
};

std::string without_blanks(const std::string& text) {
  return std::regex_replace(text, std::regex("[ \\n\\r\\f\\t]+"), "");
}

// The PDF as text, without blanks, since lines may break anywhere.
std::string text_of(const fs::path& pdf) {
  const auto read = sys::run({.program = "pdftotext", .arguments = {pdf.string(), "-"}});
  BOOST_TEST_REQUIRE(read.exit_status == 0, read.output);
  return without_blanks(read.output);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_title_full_of_tex_is_printed_and_not_run) {
  const Workplace workplace;
  const std::string others = sys::read_file(steel_case);
  workplace.folder.write("secret.tex", "REVEALED");
  // Each would change what follows, read a file or start a shell, were it not plain text.
  for (const std::string title :
       {R"(50% of_it #1 & ~x^2 $y$ {z} \% \\ \end{document})",
        R"(\def\val#1{no} \csname stop\endcsname)",
        R"(\input{secret} \input secret |cat secret.tex)", R"(\immediate\write18{touch ran})",
        R"($(touch ran) ; touch ran & \iffalse)"}) {
    const fs::path file = workplace.folder.write(
        "my_case % #1 $x$.toml", with(others, "title = ", "title = '''" + title + "'''\n#"));

    output_of(workplace.stage("compute", file), {.folder = workplace.folder.path()});
    output_of(workplace.stage("draw"), {.folder = workplace.folder.path()});
    output_of(workplace.stage("typeset", file), {.folder = workplace.folder.path()});

    const std::string printed = text_of(workplace.pdf);
    BOOST_TEST(printed.find(without_blanks(title)) != std::string::npos, title);
    BOOST_TEST(printed.find("my_case%#1$x$.toml") != std::string::npos);
    BOOST_TEST(printed.find("REVEALED") == std::string::npos);
    for (const std::string& made : sys::files_below(workplace.folder.path())) {
      BOOST_TEST(fs::path(made).filename() != "ran");
    }
  }
}

BOOST_AUTO_TEST_CASE(a_source_full_of_tex_does_not_stop_the_report) {
  const Workplace workplace;
  const std::string text =
      with(sys::read_file(papers_case), "Fig. 5, p. 9", R"(\\input{x} 5% #1 \\write18{ls}_)");
  const fs::path file = workplace.folder.write("case.toml", text);

  output_of(workplace.stage("compute", file));
  output_of(workplace.stage("draw"));
  output_of(workplace.stage("typeset", file));

  BOOST_TEST(fs::exists(workplace.pdf));
}

BOOST_AUTO_TEST_CASE(a_unit_full_of_tex_is_refused) {
  const Workplace workplace;
  for (const char* unit : {R"(in\\input{x})", "%", "in_2", R"(\\write18{ls})", "in#1"}) {
    const std::string text = with(sys::read_file(papers_case), "value = 10, unit = \"in\"",
                                  "value = 10, unit = \"" + std::string(unit) + "\"");
    check_refused(2, workplace.stage("compute", workplace.folder.write("case.toml", text)),
                  {"case.toml:", "unit"});
  }
}

BOOST_AUTO_TEST_CASE(what_the_prose_leaves_out_is_a_warning) {
  const Workplace workplace;
  const fs::path document =
      workplace.folder.write("report/report.tex",
                             "\\documentclass{article}\\usepackage{literate}\n"
                             "\\begin{document}\nNothing is used.\n\\end{document}\n");
  literate::Document registered;
  registered.value("peak", literate::Value(1.5, literate::exact()));
  registered.write(workplace.generated);
  output_of(workplace.stage("draw"));

  const Outcome outcome =
      run_program(workplace.stage("typeset", papers_case, document.parent_path()));

  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(
      outcome.errors.starts_with("halfspace: warning: tests/end_to_end/hostile_text_test.cpp:"),
      outcome.errors);
  BOOST_TEST(outcome.errors.ends_with(": value 'peak' is registered and not used\n"),
             outcome.errors);
}

BOOST_AUTO_TEST_SUITE_END()
