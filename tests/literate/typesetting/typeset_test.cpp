// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/typesetting/typeset.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdlib>

#include "holds.hpp"
#include "literate/document/document.hpp"
#include "literate/document/names.hpp"
#include "literate/figures/draw.hpp"
#include "literate/prose/restyle.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(typeset_test)

using namespace literate;
namespace fs = std::filesystem;

namespace {

/// A small document in folders with spaces in their names.
class Paper {
 public:
  explicit Paper(const std::string& body) {
    Document document;
    document.value("load_1.a-b", Value({1.6236054e-6, 3e-10}, supported(), "in^2"));
    document.flag("ok", true);
    document.table(Table("t", {Column("$v$", fixed(3), "in").scaled(-6)})
                       .add_row({numerics::Estimate{-1.5e-6, 1e-12}}));
    document.figure("f", {.width_cm = 5, .height_cm = 4, .texts = {{"name", "$\\nu$"}}});
    options.figures = document.figure_places();
    document.write(options.generated_dir,
                   {{"x", "src/a_b.cpp", 3, "// 2πx ≤ ∫ σν² → √, E* − 1\nreturn x;\n"}});
    sys::write_file_atomically(scratch_ / "figures/style.gp", "");
    sys::write_file_atomically(scratch_ / "figures/f.gp", "plot sin(x) title name\n");
    draw_figures(options.generated_dir, scratch_ / "figures", document.figure_places());
    write(body);
  }

  void write(const std::string& body) const {
    sys::write_file_atomically(options.source_dir / "main.tex",
                               "\\pdfinfoomitdate=1 \\pdftrailerid{} \\pdfsuppressptexinfo=-1\n"
                               "\\documentclass{article}\n\\usepackage{literate}\n"
                               "\\usepackage{hyperref}\n\\begin{document}\n" +
                                   body + "\n\\end{document}\n");
  }

  std::string error() const {
    return message_of<sys::ToolError>([this] { typeset(options); });
  }

 private:
  TemporaryFolder scratch_;

 public:
  TypesetOptions options{.source_dir = scratch_ / "my report",
                         .main_file = "main.tex",
                         .generated_dir = scratch_ / "out put/generated",
                         .build_dir = scratch_ / "out put/tex",
                         .output_pdf = scratch_ / "out put/report.pdf",
                         .source_date_epoch = 1000000000};
};

const char* const full_body =
    "\\begin{abstract}\\val{load_1.a-b}\\end{abstract}\\tableofcontents\n"
    "\\section{Load \\val{load_1.a-b} \\ifflag{ok}{yes}{no}}\n"
    "$a=\\val{load_1.a-b}$ \\today\n"
    "\\begin{table}\\caption{\\val{load_1.a-b}}\\tab{t}\\end{table}\n"
    "\\begin{figure}\\fig{f}\\caption{\\ifflag{ok}{yes}{no}}\\end{figure}\n"
    "\\excerpt{x} See listing~\\ref{lst:x}.";

}  // namespace

BOOST_AUTO_TEST_CASE(a_whole_document_has_the_same_bytes_in_another_folder) {
  const Paper paper(full_body);
  const Paper other(full_body);

  typeset(paper.options);
  typeset(other.options);

  BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) ==
             sys::sha256_of_file(other.options.output_pdf));
}

BOOST_AUTO_TEST_CASE(restyled_values_reach_text_formulas_captions_and_bookmarks) {
  const Paper paper(
      "\\tableofcontents\\section{Area \\val[digits=2]{load_1.a-b}}\n"
      "$a=\\val[unit=cm^2, digits=3]{load_1.a-b}$ \\val[unit={cm²},digits=2]{load_1.a-b} "
      "\\textbf{\\val[format=scientific]{load_1.a-b}}\n"
      "\\begin{table}\\caption{\\val[decimals=9]{load_1.a-b}}\\tab{t}\\end{table}\n"
      "\\rule{\\rawval[unit=mm^2]{load_1.a-b}pt}{1pt}\\ifdim\\rawval{load_1.a-b}pt<1pt small\\fi");
  const Names names = read_names(paper.options.generated_dir / "names.json");
  const Restyled restyled = restyled_values(paper.options.source_dir, names);
  BOOST_TEST(restyled.errors.empty());
  sys::write_file_atomically(paper.options.build_dir / "restyled.tex", restyled.latex);

  typeset(paper.options);

  const std::string bookmarks = sys::read_file(paper.options.build_dir / "main.out");
  BOOST_TEST(holds(bookmarks, "\\0001\\000.\\0006\\000e\\000-\\0006"));
  const std::string contents = sys::read_file(paper.options.build_dir / "main.toc");
  BOOST_TEST(holds(contents, "\\val [digits=2]{load_1.a-b}"));
}

BOOST_AUTO_TEST_CASE(a_unit_has_its_signs_in_text_and_in_formulas) {
  const Paper paper(
      "\\val[unit=um^2,digits=2]{load_1.a-b} $a = \\val[unit=um^2,digits=2]{load_1.a-b}$\n"
      "\\qty{2}{\\LiterateAngstrom}\n\n"
      "a \\val[unit=um km,digits=2]{load_1.a-b} b \\val[unit=um2,digits=2]{load_1.a-b} c "
      "$\\val[unit={1/cm⁻²},digits=2]{load_1.a-b}$ d "
      "{\\fontfamily{ptm}\\scshape\\val[unit={cm²},digits=2]{load_1.a-b}} e");
  const Names names = read_names(paper.options.generated_dir / "names.json");
  sys::write_file_atomically(paper.options.build_dir / "restyled.tex",
                             restyled_values(paper.options.source_dir, names).latex);

  typeset(paper.options);

  const sys::ProcessResult text =
      sys::run({.program = "pdftotext", .arguments = {paper.options.output_pdf.string(), "-"}});
  const auto first = text.output.find("µm");
  BOOST_TEST(first != std::string::npos, text.output);
  BOOST_TEST(text.output.find("µm", first + 1) != std::string::npos, text.output);
  // A power is raised, and a blank stands between two names.
  for (const char* part : {"µm km b", "µm2 c", "cm2 d", "cm2 e"}) {
    BOOST_TEST(holds(text.output, part));
  }
  const bool has_ring = text.output.find("2 Å") != std::string::npos ||
                        text.output.find("2 A\u030A") != std::string::npos;
  BOOST_TEST(has_ring, text.output);
}

BOOST_AUTO_TEST_CASE(tables_break_over_pages_and_have_notes) {
  const Paper paper(
      "\\tab[All.\\label{tab:long}]{long} Table~\\ref{tab:long}. \\tab{noted} \\provenance");
  Document document;
  Table of_many("long", {Column("$n$", integer()), Column::text("of")});
  for (int i = 0; i < 150; ++i) of_many.add_row({i, "many"});
  document.table(of_many.note("Counted.").break_over_pages());
  Table noted("noted",
              {Column("$x$", fixed(1)).under("both"), Column("$y$", fixed(1)).under("both")});
  noted.add_row({Cell(1).marked("a"), 2}).note("a", "by hand").note("In SI units.");
  document.table(noted);
  document.write(paper.options.generated_dir);

  typeset(paper.options);

  const std::string log = sys::read_file(paper.options.build_dir / "main.log");
  BOOST_TEST(holds(log, " pages, "));
  const sys::ProcessResult text =
      sys::run({.program = "pdftotext", .arguments = {paper.options.output_pdf.string(), "-"}});
  BOOST_TEST(holds(text.output, "table long, pp. 1, 2, 3, 4:"));
  BOOST_TEST(holds(Paper("\\tab[All.]{t}").error(), "table 't' does not break over pages"));
}

BOOST_AUTO_TEST_CASE(a_kept_preamble_changes_no_byte) {
  const Paper paper(full_body);
  const Paper other(full_body);
  const fs::path main = other.options.source_dir / "main.tex";
  std::string text = sys::read_file(main);
  text.insert(text.find("\\begin{document}"), "\\relax ");  // so that it cannot be kept
  sys::write_file_atomically(main, text);

  typeset(paper.options);
  typeset(other.options);

  BOOST_TEST(fs::exists(paper.options.build_dir / "preamble/preamble.fmt"));
  BOOST_TEST(!fs::exists(other.options.build_dir / "preamble/preamble.fmt"));
  BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) ==
             sys::sha256_of_file(other.options.output_pdf));
}

BOOST_AUTO_TEST_CASE(a_changed_preamble_shows_in_the_next_pdf) {
  const Paper paper("\\word");
  const fs::path own = paper.options.source_dir / "literate-own.sty";
  sys::write_file_atomically(own, "\\newcommand\\word{one}\n");
  const fs::path main = paper.options.source_dir / "main.tex";
  std::string text = sys::read_file(main);
  text.insert(text.find("\\usepackage{hyperref}"), "\\usepackage{literate-own}");
  sys::write_file_atomically(main, text);
  typeset(paper.options);
  const std::string before = sys::sha256_of_file(paper.options.output_pdf);

  sys::write_file_atomically(own, "\\newcommand\\word{two}\n");
  typeset(paper.options);

  BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) != before);
}

BOOST_AUTO_TEST_CASE(an_error_in_the_preamble_has_file_and_line) {
  const Paper paper("Text.");
  typeset(paper.options);
  const fs::path main = paper.options.source_dir / "main.tex";
  std::string text = sys::read_file(main);
  text.insert(text.find("\\begin{document}"), "\\nonsense\n");
  sys::write_file_atomically(main, text);

  BOOST_TEST(paper.error() ==
             "my report/main.tex:5: Undefined control sequence.\n  l.5 \\nonsense");
}

BOOST_AUTO_TEST_CASE(the_document_tells_the_state_of_its_repository) {
  Paper paper("\\typeout{It is \\papercommit\\ifpapermodified{ changed}{} of \\paperdate.}Text.");
  paper.options.repository_dir = paper.options.build_dir / "re pository";
  sys::write_file_atomically(paper.options.repository_dir / "repository.tex",
                             "\\LiterateRepository{0123456789ab}{true}{2001}\n");

  typeset(paper.options);

  BOOST_TEST(holds(sys::read_file(paper.options.build_dir / "main.log"),
                   "It is 0123456789ab changed of 2001."));
  BOOST_TEST(!keep_preamble(paper.options).is_new);
  sys::write_file_atomically(paper.options.repository_dir / "repository.tex",
                             "\\LiterateRepository{ba9876543210}{false}{2002}\n");
  BOOST_TEST(!keep_preamble(paper.options).is_new);  // a commit leaves the preamble as it is
  typeset(paper.options);
  BOOST_TEST(
      holds(sys::read_file(paper.options.build_dir / "main.log"), "It is ba9876543210 of 2002."));
}

BOOST_AUTO_TEST_CASE(a_new_date_of_the_document_is_part_of_its_input) {
  Paper paper("\\today");
  typeset(paper.options);
  const std::string before = sys::sha256_of_file(paper.options.output_pdf);
  paper.options.source_date_epoch += 86400;

  typeset(paper.options);

  BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) != before);
}

BOOST_AUTO_TEST_CASE(an_error_of_tex_has_file_and_line_and_leaves_the_old_pdf) {
  const Paper paper("Text.");
  typeset(paper.options);
  const std::string before = sys::sha256_of_file(paper.options.output_pdf);
  paper.write("Text.\n\n\\nonsense here");

  BOOST_TEST(paper.error() ==
             "my report/main.tex:8: Undefined control sequence.\n  l.8 \\nonsense");
  BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) == before);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_in_the_document_is_told_at_its_line) {
  const auto check = [](const std::string& body, const std::string& said) {
    const std::string error = Paper(body).error();
    BOOST_TEST(holds(error, said));
  };
  const std::string file = "my report/main.tex:";

  check("\\val{none}", file + "6: Package literate Error: unknown value 'none'.");
  check("\\fig{none}", "unknown figure 'none'");
  check("\n\\fig[heigth=3cm]{f}", file + "7: Package keyval Error: heigth undefined.");
  check("\n\\fig[width=4]{f}", file + "7: Illegal unit of measure");
  check("\\fig[width=0.1\\columnwidth-1cm]{f}",
        file + "6: Package literate Error: figure 'f' cannot be 6.04936pt wide.");
  check("\\fig[width=2\\paperwidth]{f}", "cannot be 1228.");
  check("\n\\val[digits=2]{load_1.a-b}", file + "7: ");  // a variant that was not made
  check("\n\\ref{fig:x}", file + "7: LaTeX Warning: Reference `fig:x'");
  check("\\section{A}\\label{x}\n\n\\section{B}\\label{x}",
        file + "6 and " + file + "8: label 'x' is defined more than once");
  check("One.\n\nA \\emph{word \\emph{or} more.",
        file + "8:8: this brace is not closed\n  ! File ended");
  check("\\noindent\\mbox{\\rule{20cm}{1pt}}\n", file + "6: Overfull \\hbox (");
  check("Text.\n\\begin{figure}\n\\rule{1cm}{30cm}\n\\end{figure}\n",
        file + "9: LaTeX Warning: Float too large for page by ");
}

BOOST_AUTO_TEST_CASE(a_file_that_is_read_from_outside_the_document_is_told_where_it_is_named) {
  const Paper paper("Text.\n\\input{../notes}");
  sys::write_file_atomically(paper.options.source_dir / "../notes.tex", "Notes.\n");
  const std::string error = message_of<sys::InputError>([&] { typeset(paper.options); });
  BOOST_TEST(error.starts_with("my report/main.tex:7:8: '../notes.tex' lies outside the folder"),
             error);
  BOOST_TEST(!fs::exists(paper.options.output_pdf));

  sys::write_file_atomically(paper.options.source_dir / "notes.tex", "Notes.\n");
  paper.write("Text.\n\\input{notes}");
  typeset(paper.options);
  BOOST_TEST(fs::exists(paper.options.output_pdf));
}

BOOST_AUTO_TEST_CASE(an_overfull_box_is_a_warning_for_who_is_still_writing) {
  Paper paper("\\noindent\\mbox{\\rule{20cm}{1pt}}\n");
  paper.options.tolerates_overfull = true;

  const Typeset done = typeset(paper.options);

  BOOST_REQUIRE(done.warnings.size() == 1U);
  BOOST_TEST(done.warnings.front().starts_with("my report/main.tex:6: Overfull \\hbox ("));
  BOOST_TEST(fs::exists(paper.options.output_pdf));
  paper.options.tolerates_overfull = false;
  BOOST_CHECK_THROW(typeset(paper.options), sys::ToolError);
}

BOOST_AUTO_TEST_CASE(a_figure_is_drawn_at_each_width_that_the_document_wants) {
  const Paper paper(
      "\\begin{figure}\\fig[width=\\columnwidth]{f}\\end{figure}\n"
      "\\begin{figure}\\fig[width=72.27pt*2]{f}\\end{figure}\n"
      "\\begin{figure}\\fig{f}\\end{figure}\n"
      "\\newbox\\drawn\\setbox\\drawn\\hbox{\\fig[width=72.27pt*2]{f}}\n"
      "\\typeout{wide \\the\\wd\\drawn, high \\the\\ht\\drawn}\n");

  const Typeset first = typeset(paper.options);
  const std::string before = sys::sha256_of_file(paper.options.output_pdf);
  const Typeset second = typeset(paper.options);

  // \columnwidth is 345 pt, two inches are 144.54 pt.
  const std::vector<std::string> drawn{"drawn/f-22609920/f.pdf", "drawn/f-22609920/f.tex",
                                       "drawn/f-9472574/f.pdf", "drawn/f-9472574/f.tex"};
  BOOST_TEST(first.drawn == drawn, boost::test_tools::per_element());
  BOOST_TEST(second.drawn == drawn, boost::test_tools::per_element());
  BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) == before);
  const std::string log = sys::read_file(paper.options.build_dir / "main.log");
  BOOST_TEST(holds(log, "wide 144.54"));
  BOOST_TEST(holds(log, "high 115.4"));  // 4/5 of it
}

BOOST_AUTO_TEST_CASE(a_width_that_is_no_longer_wanted_is_removed) {
  const Paper paper("\\fig[width=3cm]{f}");
  const std::string former = typeset(paper.options).drawn.front();
  paper.write("\\fig[width=4cm]{f}");

  const Typeset done = typeset(paper.options);

  BOOST_TEST(done.drawn.size() == 2U);
  BOOST_TEST(!fs::exists(at_width_dir(paper.options) / former));
}

BOOST_AUTO_TEST_CASE(a_figure_that_was_mended_is_drawn_anew_at_its_width) {
  const Paper paper("\\fig[width=3cm]{f}");
  const fs::path drawing = at_width_dir(paper.options) / typeset(paper.options).drawn.back();
  BOOST_REQUIRE(drawing.extension() == ".tex");
  sys::write_file_atomically(drawing, "\\gplgaddtomacro{");
  sys::write_file_atomically(paper.options.build_dir / "main.aux",
                             "");  // as a run that failed left it
  BOOST_TEST(paper.error() == "(no error)");
}

BOOST_AUTO_TEST_CASE(a_listing_of_every_language_is_typeset) {
  Paper paper("");
  std::string body;
  std::vector<Excerpt> excerpts;
  for (const std::string file :
       {"a.cpp", "a.c",    "a.m",    "a.py",    "a.jl",           "a.R",      "a.f",
        "a.f90", "a.f03",  "a.f08",  "a.java",  "a.hs",           "a.lua",    "a.pl",
        "a.rb",  "a.sql",  "a.awk",  "a.gp",    "a.sh",           "a.tex",    "a.html",
        "a.xml", "a.json", "a.toml", "a.cmake", "CMakeLists.txt", "Makefile", "notes"}) {
    excerpts.push_back({"x" + std::to_string(excerpts.size()), file, 1, "if (a) end # 2\n"});
    body += "\\excerpt{" + excerpts.back().name + "}\n";
  }
  Document().write(paper.options.generated_dir, excerpts);
  paper.write(body);

  typeset(paper.options);

  BOOST_TEST(fs::exists(paper.options.output_pdf));
}

// A viewer finds an attachment by halving the PDF's list of names, so it must be in order.
BOOST_AUTO_TEST_CASE(attachments_are_listed_in_order_by_their_names) {
  const Paper paper("\\provenance");
  Document document;
  for (const char* name : {"b_2", "a-b", "a", "B"}) {
    document.table(Table(name, {Column("$v$", exact())}).add_row({1.0}));
  }
  document.write(paper.options.generated_dir);
  const fs::path main = paper.options.source_dir / "main.tex";
  sys::write_file_atomically(main, "\\pdfobjcompresslevel=0 " + sys::read_file(main));

  typeset(paper.options);

  const std::string pdf = sys::read_file(paper.options.output_pdf);
  std::size_t place = pdf.find("/Names[");
  for (const std::string name : {"B", "a-b", "a", "b_2"}) {
    const std::size_t next = pdf.find("(tables-" + name + ".csv)", place);
    BOOST_TEST(next < pdf.find(']', place), name);
    place = next;
  }

  const sys::ProcessResult list =  // by the names that viewers show
      sys::run({.program = "pdfdetach", .arguments = {"-list", paper.options.output_pdf.string()}});
  BOOST_TEST(list.output ==
             "4 embedded files\n1: tables-B.csv\n2: tables-a-b.csv\n3: tables-a.csv\n"
             "4: tables-b_2.csv\n");
  // Into a folder that is empty, which has no folder for each of their names.
  const TemporaryFolder saved;
  sys::run(
      {.program = "pdfdetach",
       .arguments = {"-saveall", "-o", saved.path().string(), paper.options.output_pdf.string()}});
  BOOST_TEST(sys::read_file(saved / "tables-b_2.csv") == document.tables().at("b_2").csv());
}

BOOST_AUTO_TEST_CASE(two_attachments_of_one_name_are_refused) {
  const Paper paper(
      "\\makeatletter\\lit@attach{a-b/c.csv}\\lit@attach{a-b/c.csv}\n\\lit@attach{a/b-c.csv}");
  for (const char* file : {"a-b/c.csv", "a/b-c.csv"}) {
    sys::write_file_atomically(paper.options.generated_dir / file, "1\n");
  }

  const std::string error = paper.error();

  BOOST_TEST(holds(error, "main.tex:7: "));
  BOOST_TEST(holds(error, "'a-b/c.csv' and 'a/b-c.csv' would both be attached as 'a-b-c.csv'"));
}

BOOST_AUTO_TEST_CASE(lualatex_typesets_the_same_document_with_the_same_bytes_each_time) {
  const std::string body =
      "\\val{load_1.a-b} \\begin{figure}\\fig{f}\\end{figure}\\today\\provenance";
  Paper paper(body);
  Paper other(body);
  for (Paper* each : {&paper, &other}) {
    each->options.engine = "lualatex";
    const fs::path main = each->options.source_dir / "main.tex";
    std::string text = sys::read_file(main);
    text.erase(0, text.find('\n'));  // pdfTeX's own lines
    sys::write_file_atomically(main, text);

    typeset(each->options);
  }

  BOOST_TEST(sys::read_file(paper.options.build_dir / "main.log").starts_with("This is LuaHBTeX"));
  BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) ==
             sys::sha256_of_file(other.options.output_pdf));
}

BOOST_AUTO_TEST_CASE(a_missing_tool_or_file_is_told_by_name) {
  Paper paper("Text.");
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const std::string message = paper.error();
  setenv("PATH", path.c_str(), 1);

  BOOST_TEST(message.starts_with("pdflatex is not installed"));
  paper.options.main_file = "none.tex";
  BOOST_CHECK_THROW(typeset(paper.options), sys::OutputError);
}

BOOST_AUTO_TEST_CASE(page_numbers_are_right_however_fast_passes_and_saves_follow_each_other) {
  // All within one second, as far as anybody can tell by the time stamps.
  const TemporaryFolder tools;
  const Paper paper("");
  sys::write_file_atomically(
      tools / "pdflatex",
      fmt::format("#!/bin/sh\n'{}' \"$@\" || exit\ntouch -c -d @1000000000 '{}'/*.aux\n",
                  sys::find_tool("pdflatex").string(), paper.options.build_dir.string()));
  fs::permissions(tools / "pdflatex", fs::perms::owner_all);
  const auto stamp = fs::last_write_time(tools / "pdflatex");
  const std::string path = std::getenv("PATH");
  setenv("PATH", (tools.path().string() + ":" + path).c_str(), 1);

  for (int i = 0; i < 6; ++i) {
    paper.write(fmt::format("x{}y\\label{{a}}\\typeout{{a is on \\getpagerefnumber{{a}}.}}",
                            i % 2 == 0 ? "\\newpage " : "\\relax   "));
    fs::last_write_time(paper.options.source_dir / "main.tex", stamp);
    typeset(paper.options);
    const std::string log = sys::read_file(paper.options.build_dir / "main.log");
    BOOST_TEST(holds(log, fmt::format("a is on {}.", i % 2 == 0 ? 2 : 1)));
  }

  setenv("PATH", path.c_str(), 1);
}

BOOST_AUTO_TEST_CASE(a_document_that_never_settles_is_an_error_that_names_the_label) {
  const Paper paper("x\\ifnum\\getpagerefnumber{odd}=1 \\newpage\\fi y\\label{odd}");

  BOOST_TEST(paper.error() ==
             (paper.options.source_dir / "main.tex").string() +
                 ": LaTeX asks for another run after each one\n"
                 "  label 'odd' is '' on page 1 in one pass and '' on page 2 in the next");
}

BOOST_AUTO_TEST_CASE(an_engine_that_does_nothing_and_succeeds_is_not_believed) {
  const TemporaryFolder tools;
  Paper paper("Text.");
  typeset(paper.options);
  paper.write("Another text.");
  sys::write_file_atomically(tools / "pdflatex",
                             "#!/bin/sh\ncase \"$*\" in *-ini*) exit 1;; esac\n");
  fs::permissions(tools / "pdflatex", fs::perms::owner_all);

  const std::string path = std::getenv("PATH");
  setenv("PATH", (tools.path().string() + ":" + path).c_str(), 1);
  const std::string message = paper.error();
  setenv("PATH", path.c_str(), 1);

  BOOST_TEST(holds(message, "didn't generate the expected log file"));
}

BOOST_AUTO_TEST_CASE(what_latex_left_is_begun_anew_if_a_run_was_interrupted_or_a_file_damaged) {
  const Paper paper(full_body);
  typeset(paper.options);
  const std::string pdf = sys::sha256_of_file(paper.options.output_pdf);

  for (const std::string file :
       {"main.aux", "main.toc", "main.out", "main.fdb_latexmk", "main.pdf", "as-left.sha256"}) {
    const std::string text = sys::read_file(paper.options.build_dir / file);
    sys::write_file_atomically(paper.options.build_dir / file, text.substr(0, text.size() / 2));
    fs::remove(paper.options.output_pdf);

    typeset(paper.options);

    BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) == pdf, file);
  }
}

BOOST_AUTO_TEST_CASE(an_error_whose_cause_is_what_an_earlier_run_left_is_not_told) {
  const Paper paper("\\newcommand\\once{1}\\tableofcontents\\section{\\protect\\once}");
  typeset(paper.options);

  // The heading in the .toc knows a macro that is gone.
  paper.write("\\tableofcontents\\section{2}");

  BOOST_TEST(paper.error() == "(no error)");
}

BOOST_AUTO_TEST_CASE(after_an_error_was_mended_the_document_is_that_of_a_first_run) {
  const Paper fresh(full_body);
  typeset(fresh.options);
  const Paper paper(full_body);
  typeset(paper.options);

  paper.write("\\section{x}\\nonsense");
  BOOST_TEST(holds(paper.error(), "main.tex:6: Undefined control sequence"));
  paper.write(full_body);
  typeset(paper.options);

  BOOST_TEST(sys::sha256_of_file(paper.options.output_pdf) ==
             sys::sha256_of_file(fresh.options.output_pdf));
}

BOOST_AUTO_TEST_CASE(an_error_of_bibtex_is_told_at_its_line) {
  const Paper paper("A book~\\cite{a}.\\bibliographystyle{plain}\\bibliography{books}");
  sys::write_file_atomically(paper.options.source_dir / "books.bib",
                             "@book{a,\n  author = {A. B.}\n  title = {C}\n}\n");

  const std::string error = paper.error();

  BOOST_TEST(holds(error, "my report/books.bib:3: BibTeX: I was expecting"));
}

BOOST_AUTO_TEST_CASE(parts_may_be_included_from_folders) {
  const Paper paper("\\include{parts/one}");
  sys::write_file_atomically(paper.options.source_dir / "parts/one.tex", "One.");

  typeset(paper.options);

  BOOST_TEST(fs::exists(paper.options.build_dir / "parts/one.aux"));
}

BOOST_AUTO_TEST_CASE(a_drawing_is_its_own_whatever_else_is_called_like_it) {
  const Paper paper("\\fig{f}\\fig[width=2cm]{f}");
  sys::write_file_atomically(paper.options.source_dir / "f.pdf", "another picture");

  typeset(paper.options);

  BOOST_TEST(fs::exists(paper.options.output_pdf));
}

BOOST_AUTO_TEST_CASE(today_is_the_day_of_the_commit) {
  const Paper paper("\\typeout{day \\today}\\today");
  const auto day_by = [&](const std::string& date) {
    sys::write_file_atomically(paper.options.source_dir / "repository.tex",
                               "\\LiterateRepository{unknown}{false}{" + date + "}\n");
    typeset(paper.options);
    const std::string log = sys::read_file(paper.options.build_dir / "main.log");
    const auto begin = log.find("\nday ") + 5;
    return log.substr(begin, log.find('\n', begin) - begin);
  };

  BOOST_TEST(day_by("2026-09-08T03:36:45Z") == "September 8, 2026");
  BOOST_TEST(day_by("unknown") == "undated");
}

BOOST_AUTO_TEST_CASE(an_overfull_box_is_told_at_the_line_of_its_table) {
  const Paper paper("\n\\begin{table}\n\\centering\n\\caption{A.}\n\\tab{wide}\n\\end{table}\n");
  Document document;
  document.table(Table("wide", {Column::text("text")}).add_row({std::string(200, 'x')}));
  document.write(paper.options.generated_dir);

  const std::string error = paper.error();

  BOOST_TEST(holds(error, "my report/main.tex:10: in table 'wide': Overfull"));
}

BOOST_AUTO_TEST_SUITE_END()
