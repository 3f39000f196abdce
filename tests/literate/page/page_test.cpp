// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <regex>
#include <vector>

#include "literate/document/document.hpp"
#include "literate/page/html_text.hpp"
#include "message_of.hpp"
#include "needed_tool.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(page_test)

using namespace literate;
using boost::test_tools::per_element;

namespace {

// What LaTeX wrote of «\section{Weighing}\label{weighing}» and an equation, by a class of its own.
const std::string aux =
    "\\LiterateNumber{section}{II}{document}{}{1}\n\\newlabel{weighing}{{II}{1}{}{}{}}\n"
    "\\LiterateNumber{equation}{2.7}{equation}{}{2}\n\\newlabel{mass}{{2.7}{1}{}{}{}}\n";
const std::string body =
    "\\section{Weighing}\\label{weighing}\n"
    "By section~\\ref{weighing} and eq.~\\eqref{mass} an apple has \\val{mass}\\claim{apples}.\n"
    "\\begin{equation}\\label{mass}m = 3\\end{equation}\n"
    "\\statement[market, stall~3]{apples}{An apple weighs 2.6 g.}\n\\tab{prices}\n\\claimledger\n";

void register_apples(Document& document) {
  document.value("mass", Value({2.612, 0.001}, fixed(2), "g"));
  document.value("flow", Value(2.5, exact(), "um2.s-1"));
  document.value("strength", Value(3, exact(), "MPa.m^0.5"));
  const numerics::Measured load =
      numerics::Measured(993.63, 21.9, "scale") + numerics::Measured::bounded({0, 2.1});
  document.value("load", Value(load, uncertain(), "um.s-2"));
  document.value("kinds", Value(load, uncertain().by_kind()));
  document.value("sides", Value(993.5, Uncertainty::to_sides(18.2, 21.4), uncertain(), "um"));
  document.value("tiny", Value(numerics::Estimate{4.73e-5, 1.7e-6}, uncertain(), "m2"));
  document.value("signs", Value::text("\"µ\" „x” • † © | ~ ^ < > § ½ – — & # \\ ° Å × ≤ é"));
  document.flag("ripe", true);
  document.claim("apples",
                 {.route = "weighing <twice> & adding up",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::at_most("mass", Value({2.612, 0.001}, fixed(2), "g"),
                                                  {LimitKind::data, 2.65, "half a digit"})}});
  Table prices("prices", {Column::text("fruit"), Column("price", fixed(2), "{kr}").exact()});
  prices.add_row({"apple & pear", 1.5}).add_row({"\"plum\" µ", 2.75});
  document.table(std::move(prices));
  Table over_pages("long", {Column::text("fruit")});
  over_pages.add_row({"plum"}).break_over_pages();
  document.table(std::move(over_pages));
  Table notes("notes", {Column::text("fruit")});
  notes.add_row({Cell::latex("\\unheardof{d}")});
  document.table(std::move(notes));
}

Page page_of_document(const std::string& latex, const std::string& numbers) {
  need_tool("pandoc", "pages");
  const TemporaryFolder scratch;
  Document document;
  register_apples(document);
  document.write(scratch / "generated");
  scratch.write("text/main.tex", latex);
  scratch.write("text/part.tex", "part,%\n");
  scratch.write("main.aux", numbers);
  const std::filesystem::path engine = LITERATE_PAGE_DIR;
  return write_page({.document = scratch / "text",
                     .main_file = "main.tex",
                     .generated = scratch / "generated",
                     .aux = scratch / "main.aux",
                     .engine = engine,
                     .build = scratch.path(),
                     .known = sys::read_file(engine / "known.tex")});
}

Page page_of(const std::string& text, const std::string& numbers = aux) {
  return page_of_document(
      "\\documentclass{article}\n\\begin{document}\n" + text + "\\end{document}\n", numbers);
}

// Errors, from the place in the file on.
std::vector<std::string> errors_of(const std::string& text, const std::string& numbers = aux) {
  std::vector<std::string> errors = page_of(text, numbers).errors;
  for (std::string& error : errors) error.erase(0, error.find("main.tex:"));
  return errors;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A construct was once read otherwise than by LaTeX, or is what a reader sees first.
struct Construct {
  std::string latex;
  std::vector<std::string> wanted;
  std::string numbers = "\\relax\n";
};

void require_shown(const std::vector<Construct>& constructs) {
  for (const auto& [latex, wanted, numbers] : constructs) {
    const Page page = page_of(latex + "\n", numbers);
    BOOST_TEST_CONTEXT(latex) {
      BOOST_TEST(page.errors == std::vector<std::string>{}, per_element());
      for (const std::string& part : wanted) {
        BOOST_TEST(holds(page.html, part), part << " in " << page.html);
      }
    }
  }
}

std::string number(const char* counter, const char* shown, int order = 1) {
  return fmt::format("\\LiterateNumber{{{0}}}{{{1}}}{{document}}{{{1}}}{{{2}}}\n", counter, shown,
                     order);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_number_is_that_of_the_pdf_and_values_and_claims_keep_their_marks) {
  require_shown(
      {{body,
        {"<span class=\"lit-number\">II</span> Weighing", "href=\"#weighing\">II</a>",
         "href=\"#mass\">(2.7)</a>", "<span class=\"lit-equation-number\" id=\"mass\">(2.7)</span>",
         "data-key=\"mass\"", ">2.61 g</a></span>", "data-claim=\"apples\"",
         "data-verdict=\"confirmed\"", "weighing &lt;twice&gt; &amp; adding up", "market, stall 3",
         "data-table=\"prices\"", "apple &amp; pear"},
        aux}});
}

BOOST_AUTO_TEST_CASE(a_number_has_its_signs_powers_and_what_is_not_known_of_it) {
  require_shown({
      {"\\val{flow} \\val{strength} \\qty{2}{m/s^2} \\qty{4}{\\percent}",
       {">2.5 µm<sup>2</sup> s<sup>−1</sup></a>", ">3 MPa m<sup>0.5</sup></a>", "2 m/s<sup>2</sup>",
        "4 %"}},
      {"\\(\\val{flow}\\)", {"µm", "<msup>"}},
      {"\\val{load} \\val{kinds} \\val{tiny} \\val{sides} \\valueindex",
       {">(994(22)\u00A0±\u00A03)\u00A0µm s<sup>−2</sup></a>",
        ">(994\u00A0+21\u00A0−19)\u00A0µm</a>",
        ">994\u00A0±\u00A022 (scale)\u00A0±\u00A03 (at most)</a>",
        ">(4.73\u00A0±\u00A00.17)\u00A0×\u00A010<sup>−5</sup>\u00A0m</span><sup>2</sup></a>"}},
      {"\\(\\val{tiny}\\)", {"<mo>×</mo>", "<mo>±</mo>"}},
      {"\\(\\val{kinds}\\)", {"<mtext mathvariant=\"normal\"> (scale)</mtext>"}},
      {"\\unit{\\joule\\per\\mole\\squared}", {"J/mol<sup>2</sup>"}},
      {"\\unit{\\watt\\per\\metre\\per\\kelvin}", {"W/(m K)"}},
      {"\\(\\unit{\\watt\\per\\metre\\per\\kelvin}\\)",
       {"m</mtext><mspace width=\"0.167em\"></mspace><mtext mathvariant=\"normal\">K"}},
      {"\\qty{7}{\\per\\metre}", {"7/m"}},
      {"\\unit{ms.d^{-1}.K^{-2}}", {"ms d<sup>−1</sup> K<sup>−2</sup>"}},
      {"\\num{ 1,5 }, \\num{.5D3}, \\num{5.}, \\num{\\rawval{mass}}, \\num{1.2(3)E-4}",
       {">0.5\u00A0×\u00A010<sup>3</sup>,</span> 5, 2.612, ",
        ">1.2(3)\u00A0×\u00A010<sup>−4</sup>"}},
      {"\\num{-12345.67891}, \\num{e-3}",
       {">−12\u2006345.678\u200691,</span> ", ">10<sup>−3</sup>"}},
  });
}

BOOST_AUTO_TEST_CASE(every_sign_that_the_engine_writes_stands_on_the_page) {
  require_shown(
      {{"\\val{signs} \\tab{prices}", {"\"µ\" „x” • † © | ~ ^ &lt; &gt; § ", "\"plum\" µ"}}});
}

BOOST_AUTO_TEST_CASE(what_pandoc_reads_otherwise_is_as_in_the_pdf) {
  require_shown({
      {"a\\quad b\\qquad{}c \\fontsize{8}{9}\\selectfont d", {"a\u2003b\u2003\u2003c d"}},
      {"\\ifdim1cm>10pt more\\else less\\fi", {"<p>more</p>"}},
      {"\\ifdim72.2pt<1in less\\else more\\fi", {"<p>less</p>"}},
      {"\\newcommand\\n{12}\\ifnum\\n=12 more\\else less\\fi", {"<p>more</p>"}},
      {"\\ifflag{ripe}{now}{later}", {"<p>now</p>"}},
      {"\\newcommand\\who{one}{\\renewcommand\\who{two}\\who, {\\def\\who{three}\\who, "
       "\\gdef\\new{six}}\\who,} \\who, \\begingroup\\def\\who{four}\\who\\endgroup, \\who, \\new",
       {"two, <span>three, </span>two,</span> one, <span>four</span>, one, six"}},
      {"\\newcommand\\one{4.2 kJ}\\let\\same\\one \\same{}, \\renewcommand\\one{five}\\one{} and "
       "\\same.",
       {"4.2 kJ, five and 4.2 kJ."}},
      {"\\let\\eps=\\varepsilon $\\eps$ \\let\\gone\\relax\\gone \\let\\up\\MakeUppercase\\up{act}",
       {"ε", "ACT"}},
      {"\\newcommand\\two{a}\\begin{quote}\\renewcommand\\two{b}Then \\two.\\end{quote}After "
       "\\two.",
       {"Then b.", "After a."}},
      {"\\MakeUppercase{Act i}", {"ACT I"}},
      {"\\tab{prices} and \\tab[All.]{long}",
       {"Table\u00A02"},
       "\\LiterateNumber{table}{2}{longtable}{Table}{1}\n"},
      {"\\input{part}\n\\input{part}\nand more", {"<p>part, part, and more</p>"}},
      {"\\url{https://e.org/a%20b} goes on", {"goes on"}},
      {"\\makebox[4em][l]{$a$}width", {"style=\"min-width:4em\"><math"}},
      {"\\part{A}\\section*{B}\\bookmarksetup{startatroot}\\section*{C}",
       {"class=\"lit-toc-part\">Part\u00A0I A</a>", "</ul></li>\n<li><a href=\"#c\"> C</a></li>"},
       "\\LiterateNumber{part}{I}{document}{Part}{1}\n"},
      {"a\\footnotemark[7] b\\footnotemark[8] \\footnotetext[7]{one}",
       {"id=\"note-1\" role=\"note\">one"}},
      {"\\stepcounter{run}\\therun", {"2-b"}, number("run", "2-b")},
      {"\\begin{eqnarray}a & = & b\\end{eqnarray}\\begin{equation}c\\end{equation}",
       {"(8)"},
       number("equation", "7", 1) + number("equation", "8", 2) + number("equation", "8", 3)},
      {"\\begin{enumerate}\\item[*] a\\end{enumerate}", {"lit-item\">*<"}},
      {"\\begin{enumerate}\\item a\\end{enumerate}", {"lit-item\">(a)<"}, number("enumi", "(a)")},
      {"\\includegraphics{main.tex}\\hfill\\includegraphics{main.tex}",
       {"<div class=\"lit-row\" tabindex=\"0\""}},
      {"Of \\(a\\), (\\(b\\)) and \\(c\\) more.",
       {"</math>,</span> ", "<span class=\"lit-close\">(<math", "</math>)</span> and <math"}},
      {"By \\num{1e-5}, \\num{1234567}.",
       {"10<sup>−5</sup>,</span> ", "<span class=\"lit-close\">1\u2006234\u2006567.</span>"}},
  });
}

BOOST_AUTO_TEST_CASE(formulas_are_set_as_tex_sets_them) {
  require_shown({
      {"\\(f(x)\\), \\(\\bigl(y\\bigr)\\) and \\(\\left(\\frac12\\right)\\)",
       {"<mo stretchy=\"false\" form=\"prefix\">(</mo><mi>x</mi>",
        "<mo stretchy=\"true\" form=\"prefix\">(</mo><mfrac>",
        "maxsize=\"1.2em\" stretchy=\"true\" form=\"prefix\">(</mo><mi>y</mi>"}},
      {"\\begin{align*} a &= \\frac12 \\\\ b &= 3 \\end{align*} and "
       "\\[\\begin{pmatrix} 1 & 2 \\end{pmatrix}\\]",
       {"<mtable displaystyle=\"true\"><mtr><mtd columnalign=\"right\"", "<mtable><mtr>"}},
      {"\\(p_{\\mathrm{max}}\\), \\(\\mathrm d\\Delta\\)",
       {"<mi mathvariant=\"normal\">max</mi>", "<mi mathvariant=\"normal\">d</mi>",
        "<mi mathvariant=\"normal\">Δ</mi>"}},
      {"\\[a\\ln x = \\ln(x) + \\sin^2 y\\]",
       {"<mi>a</mi><mo lspace=\"0.167em\" rspace=\"0.167em\">ln</mo><mi>x</mi>",
        "<mo>=</mo><mo lspace=\"0em\" rspace=\"0em\">ln</mo><mrow>",
        "<mo>+</mo><msup><mo lspace=\"0em\" rspace=\"0.167em\">sin</mo>"}},
      {"$\\le$~5 at \\[x=\\pm a\\]",
       {"<mo lspace=\"0em\" rspace=\"0em\">≤</mo>", "<mo form=\"prefix\">±</mo><mi>a</mi>"}},
      {"\\[a=-b-c\\]", {"<mo>=</mo><mo form=\"prefix\">−</mo><mi>b</mi><mo>−</mo><mi>c</mi>"}},
  });
}

// Nothing is shown otherwise than in the PDF in silence.
BOOST_AUTO_TEST_CASE(what_the_page_cannot_show_is_told_with_its_place) {
  struct Wrong {
    std::string latex, told;
  };
  for (const auto& [latex, told] : std::vector<Wrong>{
           {"A \\unheard{b}.", "3: \\unheard is not known to the page"},
           {"\\newcommand\\mine{\\unheard{c}}A \\mine{}.",
            "32: \\unheard is not known to the page"},
           {"\\tab{notes}", "1: \\unheardof is not known to the page"},
           {"A \\(\\unheard x\\)", "13: pandoc cannot read the formula \\unheard x"},
           {"\\ifdim1em<10pt a\\else b\\fi", "1: the page cannot decide \\ifdim"},
           {"\\ifnum\\value{run}=12 a\\else b\\fi", "1: the page cannot decide \\ifnum"},
           {"\\ifdim\\wide<10pt a\\else b\\fi", "1: the page cannot decide \\ifdim"},
           {"\\ifodd 3 a\\else b\\fi", "1: \\ifodd is not known to the page"},
           {"\\setcounter{run}{9}\\therun", "20: \\therun is not known to the page"},
           {"\\MakeUppercase{at \\val{mass}}",
            "1: the page cannot set 'at \\val{mass}' in capitals, but plain letters alone"},
           {"\\num{1.2(3)(4)}",
            "6: the page cannot set the number '1.2(3)(4)'; write it as -1.2(3)e-4"},
           {"\\qty[round-mode=places]{1.2}{m}",
            "1: the page cannot set a number or a unit with the options 'round-mode=places'"},
           {"\\quoted{nobody}", "1: unknown quotation 'nobody'"},
           {"\\begin{tabular}{r@{.}l}1 & 5\\end{tabular}",
            "22: the page cannot join columns by @{…}; \\LiteratePicture{tabular} has LaTeX set "
            "them"}}) {
    const std::vector<std::string> errors = errors_of(latex + "\n", "\\relax\n");
    BOOST_TEST_CONTEXT(latex) {
      BOOST_REQUIRE(!errors.empty());
      BOOST_TEST(errors.front() == "main.tex:3:" + told);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_pdf_of_another_state_is_told) {
  const std::string heading = "\\section{Weighing}\\label{weighing}\n";
  BOOST_TEST(errors_of(heading, number("section", "II") + "\\newlabel{weighing}{{III}{1}{}{}{}}\n")
                 .at(0) ==
             "main.tex:3:10: 'weighing' has the number III in the PDF and II here: the "
             "PDF was made from another state of the document");
  BOOST_TEST(errors_of(heading).at(0) ==
             "main.tex:1:1: the PDF has more numbers than the page: 1 equation");
  BOOST_TEST(message_of<sys::InputError>(
                 [] { page_of(body + "\\begin{equation}n = 4\\end{equation}\n"); }) ==
             "text/main.tex:9:17: the PDF has no further number of a equation: it was made from "
             "another state of the document");
}

BOOST_AUTO_TEST_CASE(each_class_has_its_authors_one_by_one_and_its_title_above_the_abstract) {
  const std::string abstract = "\\begin{abstract}We weigh.\\end{abstract}";
  for (const std::string& latex :
       {"\\documentclass{article}\n\\author{Ada Lovelace\\thanks{Of London, too.} \\and Marie "
        "Curie}\n\\begin{document}\\maketitle\n" +
            abstract,
        "\\documentclass{IEEEtran}\n\\author{\\IEEEauthorblockN{Ada Lovelace}"
        "\\IEEEauthorblockA{Dept, X, Y} \\and \\IEEEauthorblockN{Marie Curie}"
        "\\IEEEauthorblockA{Lab}}\n\\begin{document}\\maketitle\n" +
            abstract,
        "\\documentclass{IEEEtran}\n\\author{Ada Lovelace,~\\IEEEmembership{Fellow} and "
        "Marie Curie%\n\\thanks{Of Dept, X, Y}}\n\\begin{document}\\maketitle\n" +
            abstract,
        "\\documentclass{elsarticle}\n\\begin{document}\n\\begin{frontmatter}\n\\title{T}"
        "\\author[a]{Ada Lovelace}\\author[b]{Marie Curie}\n\\affiliation[a]{organization={Dept},"
        "city={X},country={Y}}\\affiliation[b]{Lab}\n" +
            abstract + "\\end{frontmatter}\n",
        "\\documentclass{revtex4-2}\n\\begin{document}\n\\title{T}\n\\author{Ada Lovelace}"
        "\\affiliation{Dept, X, Y}\\author{Marie Curie}\n\\affiliation{Lab}" +
            abstract + "\\maketitle\n"}) {
    const Page page =
        page_of_document(latex + "Text.\n\\end{document}\n",
                         "\\newlabel{a}{{a}{1}{}{}{}}\n\\newlabel{b}{{b}{1}{}{}{}}\n");
    BOOST_TEST_CONTEXT(latex) {
      BOOST_TEST(page.errors == std::vector<std::string>{}, per_element());
      BOOST_TEST(page.authors == (std::vector<std::string>{"Ada Lovelace", "Marie Curie"}),
                 per_element());
      BOOST_TEST((holds(page.html, "Dept, X, Y") || holds(page.html, "Of London, too.")));
      BOOST_TEST(page.description == "We weigh.");
      BOOST_TEST(page.html.find("<h1>") < page.html.find("class=\"lit-abstract\""));
      BOOST_TEST(page.html.find("<h1>", page.html.find("lit-abstract")) == std::string::npos);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_part_of_a_figure_is_told_as_subcaption_and_subfig_do) {
  const std::string label = "\\newlabel{fig:a}{{1a}{1}}\n";
  require_shown({{"as \\subref{fig:a} shows",
                  {"href=\"#fig:a\">(a)</a> shows"},
                  label + "\\newlabel{sub@fig:a}{{(a)}{a}}\n"},
                 {"as \\subref*{fig:a} shows",
                  {"href=\"#fig:a\">a</a> shows"},
                  label + "\\newlabel{sub@fig:a}{{(a)}{a}}\n"},
                 {"\\onecolumngrid as \\subref{fig:a} shows\\twocolumngrid",
                  {"href=\"#fig:a\">a</a> shows"},
                  label + "\\newlabel{sub@fig:a}{{a}{1}}\n"}});
}

BOOST_AUTO_TEST_CASE(the_one_appendix_of_ieeetran_has_no_headings_of_sections) {
  const std::string html =
      page_of_document(
          "\\documentclass{IEEEtran}\n\\begin{document}\n\\appendix[Of apples]\\label{app}\n"
          "\\section{Lost}\nBy \\ref{app}.\n\\section*{Acknowledgment}\n\\end{document}\n",
          number("section", "A") + "\\newlabel{app}{{A}{1}{}{}{}}\n")
          .html;

  BOOST_TEST(holds(html, "Appendix Of apples"));
  BOOST_TEST(holds(html, "Acknowledgment"));
  BOOST_TEST(!holds(html, "Lost"));
}

BOOST_AUTO_TEST_CASE(bare_digits_are_no_print_of_their_value_as_in_the_index_of_the_pdf) {
  const Page page = page_of("\\ifdim\\rawval{mass}pt>1pt more\\fi\\valueindex", "\\relax\n");

  BOOST_TEST(!holds(page.html, "used in"), page.html);
  BOOST_TEST(holds(
      page_of("\\val{mass} \\ifdim\\rawval{mass}pt>1pt more\\fi\\valueindex", "\\relax\n").html,
      "used in <a class=\"lit-ref\" href=\"#use-val-mass-1\">the text</a>"));
}

// A link into a formula would lead nowhere.
BOOST_AUTO_TEST_CASE(a_value_in_a_formula_is_used_there_without_a_link) {
  const std::string html = page_of("$m = \\val{mass}$\\valueindex", "\\relax\n").html;

  BOOST_TEST(holds(html, "used in the text<"));
  BOOST_TEST(!holds(html, "#use-val-mass"), html);
}

BOOST_AUTO_TEST_CASE(natbib_sorts_and_compresses_where_its_options_say_so) {
  for (const auto& [options, cited] : {std::pair{"numbers", "[3, 1, 2]"},
                                       {"numbers,sort", "[1, 2, 3]"},
                                       {"numbers,sort&compress", "[1–3]"}}) {
    const std::string html =
        page_of_document(fmt::format("\\documentclass{{article}}\n\\usepackage[{}]{{natbib}}\n"
                                     "\\begin{{document}}\n\\cite{{c,a,b}}\n\\end{{document}}\n",
                                     options),
                         "\\bibcite{a}{{1}{2001}{{A}}{{}}}\n\\bibcite{b}{{2}{2002}{{B}}{{}}}\n"
                         "\\bibcite{c}{{3}{2003}{{C}}{{}}}\n")
            .html;
    static const std::regex tag("<[^>]*>");
    BOOST_TEST(holds(std::regex_replace(html.substr(html.find("<body")), tag, ""), cited));
  }
}

BOOST_AUTO_TEST_CASE(plain_text_keeps_exponents_indices_and_fractions) {
  BOOST_TEST(text_of_html("at most 7.5 × 10<sup>−5</sup>, by CO<sub>2</sub>") ==
             "at most 7.5 × 10⁻⁵, by CO₂");
  BOOST_TEST(text_of_html("order <math><mfrac><mn>1</mn><mn>2</mn></mfrac></math> of "
                          "<msub><mi>p</mi><mn>0</mn></msub>") == "order 1/2 of p₀");
  BOOST_TEST(text_of_html("<msup><mi>m</mi><mrow><mo>−</mo><mn>2</mn></mrow></msup>") == "m⁻²");
  BOOST_TEST(text_of_html("<mn>5</mn><mspace width=\"0.167em\"></mspace><mi>m</mi>") == "5 m");
}

BOOST_AUTO_TEST_SUITE_END()
