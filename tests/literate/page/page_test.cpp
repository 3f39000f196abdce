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
  document.claim("apples",
                 {.route = "weighing <twice> & adding up",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::at_most("mass", Value({2.612, 0.001}, fixed(2), "g"),
                                                  {LimitKind::stated, 2.65, "half a digit"})}});
  Table prices("prices", {Column::text("fruit"), Column("price", fixed(2), "{kr}").exact()});
  prices.add_row({"apple & pear", 1.5}).add_row({"\"plum\" µ", 2.75});
  document.table(std::move(prices));
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

}  // namespace

BOOST_AUTO_TEST_CASE(every_number_is_that_of_the_pdf) {
  const std::string html = page_of(body).html;

  for (const char* part : {"<span class=\"lit-number\">II</span> Weighing",
                           "href=\"#weighing\">II</a>", "href=\"#mass\">(2.7)</a>",
                           "<span class=\"lit-equation-number\" id=\"mass\">(2.7)</span>"}) {
    BOOST_TEST(holds(html, part), part << " in " << html);
  }
}

BOOST_AUTO_TEST_CASE(values_and_claims_keep_their_marks) {
  const std::string html = page_of(body).html;

  for (const char* part : {"data-key=\"mass\"", ">2.61 g</a></span>", "data-claim=\"apples\"",
                           "data-verdict=\"confirmed\"", "weighing &lt;twice&gt; &amp; adding up",
                           "market, stall 3", "data-table=\"prices\"", "apple &amp; pear"}) {
    BOOST_TEST(holds(html, part), part << " in " << html);
  }
}

BOOST_AUTO_TEST_CASE(a_unit_has_its_signs_and_powers) {
  const std::string html =
      page_of("\\val{flow} \\val{strength} \\qty{2}{m/s^2} \\qty{4}{\\percent}\n", "\\relax\n")
          .html;
  for (const char* part : {">2.5 µm<sup>2</sup> s<sup>−1</sup></a>", ">3 MPa m<sup>0.5</sup></a>",
                           "2 m/s<sup>2</sup>", "4 %"}) {
    BOOST_TEST(holds(html, part), part << " in " << html);
  }
  const std::string formula = page_of("\\(\\val{flow}\\)\n", "\\relax\n").html;
  BOOST_TEST(holds(formula, "µm"), formula);
  BOOST_TEST(holds(formula, "<msup>"), formula);
}

BOOST_AUTO_TEST_CASE(what_is_not_known_of_a_number_stands_behind_it) {
  const Page page =
      page_of("\\val{load} \\val{kinds} \\val{tiny} \\val{sides} \\valueindex\n", "\\relax\n");
  BOOST_TEST(page.errors == std::vector<std::string>{}, per_element());
  for (const char* part :
       {">(994(22)\u00A0±\u00A03)\u00A0µm s<sup>−2</sup></a>",
        ">(994\u00A0+21\u00A0−19)\u00A0µm</a>",
        ">994\u00A0±\u00A022 (scale)\u00A0±\u00A03 (at most)</a>",
        ">(4.73\u00A0±\u00A00.17)\u00A0×\u00A010<sup>−5</sup>\u00A0m<sup>2</sup></a>"}) {
    BOOST_TEST(holds(page.html, part), part << " in " << page.html);
  }
  const std::string formula = page_of("\\(\\val{tiny}\\)\n", "\\relax\n").html;
  BOOST_TEST(holds(formula, "<mo>×</mo>"), formula);
  BOOST_TEST(holds(formula, "<mo>±</mo>"), formula);
}

BOOST_AUTO_TEST_CASE(each_class_has_its_authors_one_by_one_without_what_stands_beside_them) {
  const std::vector<std::string> both{"Ada Lovelace", "Marie Curie"};
  const std::string labels = "\\newlabel{a}{{a}{1}{}{}{}}\n\\newlabel{b}{{b}{1}{}{}{}}\n";
  const auto authors_of = [&](const std::string& latex) {
    const Page page = page_of_document(latex + "Text.\n\\end{document}\n", labels);
    BOOST_TEST(page.errors == std::vector<std::string>{}, per_element());
    return page.authors;
  };
  BOOST_TEST(authors_of("\\documentclass{article}\n\\author{Ada Lovelace\\thanks{Of London, too.} "
                        "\\and Marie Curie}\n\\begin{document}\\maketitle\n") == both,
             per_element());
  BOOST_TEST(authors_of("\\documentclass{IEEEtran}\n\\author{\\IEEEauthorblockN{Ada Lovelace}"
                        "\\IEEEauthorblockA{Dept, City} \\and \\IEEEauthorblockN{Marie Curie}"
                        "\\IEEEauthorblockA{Lab}}\n\\begin{document}\\maketitle\n") == both,
             per_element());
  BOOST_TEST(authors_of("\\documentclass{elsarticle}\n\\begin{document}\n\\begin{frontmatter}\n"
                        "\\title{T}\\author[a]{Ada Lovelace}\\author[b]{Marie Curie}\n"
                        "\\affiliation[a]{organization={Dept},city={X}}\\affiliation[b]{Lab}\n"
                        "\\begin{abstract}We weigh.\\end{abstract}\\end{frontmatter}\n") == both,
             per_element());
  BOOST_TEST(authors_of("\\documentclass{revtex4-2}\n\\begin{document}\n\\title{T}\n"
                        "\\author{Ada Lovelace}\\affiliation{Dept, City}\\author{Marie Curie}\n"
                        "\\affiliation{Lab}\\maketitle\n") == both,
             per_element());
}

BOOST_AUTO_TEST_CASE(an_affiliation_in_keys_reads_as_in_the_pdf) {
  const Page page = page_of_document(
      "\\documentclass{elsarticle}\n\\begin{document}\n\\begin{frontmatter}\n\\title{T}"
      "\\author[a]{Ada}\\affiliation[a]{organization={Dept},city={X},country={Y}}\n"
      "\\begin{abstract}We weigh.\\end{abstract}\\end{frontmatter}\n\\end{document}\n",
      "\\newlabel{a}{{a}{1}{}{}{}}\n");
  BOOST_TEST(holds(page.html, "</sup>Dept, X, Y"), page.html);
  BOOST_TEST(!holds(page.html, "organization"));
}

BOOST_AUTO_TEST_CASE(the_abstract_of_revtex_stands_below_the_title_and_describes_the_page) {
  const Page page = page_of_document(
      "\\documentclass{revtex4-2}\n\\begin{document}\n\\title{Title}\n\\author{Ada}\n"
      "\\begin{abstract}We weigh.\\end{abstract}\n\\maketitle\nText.\n\\end{document}\n",
      "\\relax\n");
  BOOST_TEST(page.html.find("<h1>") < page.html.find("class=\"lit-abstract\""));
  BOOST_TEST(page.html.find("<h1>", page.html.find("lit-abstract")) == std::string::npos);
  BOOST_TEST(page.description == "We weigh.");
}

BOOST_AUTO_TEST_CASE(natbib_sorts_and_compresses_where_its_options_say_so) {
  const auto cited = [](const std::string& options) {
    return page_of_document("\\documentclass{article}\n\\usepackage[" + options +
                                "]{natbib}\n\\begin{document}\n\\cite{c,a,b}\n\\end{document}\n",
                            "\\bibcite{a}{{1}{2001}{{A}}{{}}}\n\\bibcite{b}{{2}{2002}{{B}}{{}}}\n"
                            "\\bibcite{c}{{3}{2003}{{C}}{{}}}\n")
        .html;
  };
  const auto text_of = [](std::string html) {
    static const std::regex tag("<[^>]*>");
    return std::regex_replace(html.substr(html.find("<body")), tag, "");
  };
  BOOST_TEST(holds(text_of(cited("numbers")), "[3, 1, 2]"), cited("numbers"));
  BOOST_TEST(holds(text_of(cited("numbers,sort")), "[1, 2, 3]"), cited("numbers,sort"));
  BOOST_TEST(holds(text_of(cited("numbers,sort&compress")), "[1–3]"),
             cited("numbers,sort&compress"));
}

BOOST_AUTO_TEST_CASE(every_sign_that_the_engine_writes_stands_on_the_page) {
  const Page page = page_of("\\val{signs} \\tab{prices}\n", "\\relax\n");
  BOOST_TEST(page.errors == std::vector<std::string>{}, per_element());
  BOOST_TEST(holds(page.html, "\"µ\" „x” • † © | ~ ^ &lt; &gt; § "), page.html);
  BOOST_TEST(holds(page.html, "\"plum\" µ"), page.html);
}

BOOST_AUTO_TEST_CASE(what_neither_engine_nor_pandoc_knows_is_told_with_its_place) {
  const std::vector<std::string> told{"main.tex:9:3: \\unheard is not known to the page"};

  BOOST_TEST(errors_of(body + "A \\unheard{b}.\n") == told, per_element());
}

BOOST_AUTO_TEST_CASE(what_a_definition_or_a_table_holds_is_told_where_the_document_asks_for_it) {
  const std::vector<std::string> told{"main.tex:5:3: \\unheard is not known to the page",
                                      "main.tex:6:1: \\unheardof is not known to the page"};

  BOOST_TEST(errors_of("\\newcommand\\mine{\\unheard{c}}\n\n"
                       "A \\mine{}.\n\\tab{notes}\n",
                       "\\relax\n") == told,
             per_element());
}

// Nothing is shown otherwise than in the PDF in silence.
BOOST_AUTO_TEST_CASE(what_only_latex_can_decide_is_told_with_its_place) {
  for (const auto& [latex, told] :
       {std::pair<std::string, std::string>{"\\ifdim1em<10pt a\\else b\\fi",
                                            "1: the page cannot decide \\ifdim1em<10pt"},
        {"\\ifnum\\value{run}=12 a\\else b\\fi", "1: the page cannot decide \\ifnum"},
        {"\\ifdim\\wide<10pt a\\else b\\fi", "1: the page cannot decide \\ifdim"},
        {"\\ifodd 3 a\\else b\\fi", "1: \\ifodd is not known to the page"},
        {"\\setcounter{run}{9}\\therun", "20: \\therun is not known to the page"},
        {"\\begin{tabular}{cl@{ m }r}\\multicolumn{2}{l}{a} & 3\\end{tabular}",
         "25: a cell behind \\multicolumn is joined to it by @{…}, which the page cannot show"}}) {
    const std::vector<std::string> errors = errors_of(latex + "\n", "\\relax\n");
    BOOST_TEST_CONTEXT(latex) {
      BOOST_REQUIRE(!errors.empty());
      BOOST_TEST(errors.front() == "main.tex:3:" + told);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_pdf_of_another_state_is_told) {
  const std::string other =
      "\\LiterateNumber{section}{II}{document}{}{1}\n\\newlabel{weighing}{{III}{1}{}{}{}}\n";
  const std::vector<std::string> told{
      "main.tex:3:10: 'weighing' has the number III in the PDF and II here: the PDF was made from "
      "another state of the document"};
  BOOST_TEST(errors_of("\\section{Weighing}\\label{weighing}\n", other) == told, per_element());

  const std::vector<std::string> more{
      "main.tex:1:1: the PDF has more numbers than the page: 1 equation"};
  BOOST_TEST(errors_of("\\section{Weighing}\\label{weighing}\n") == more, per_element());

  BOOST_TEST(message_of<sys::InputError>(
                 [] { page_of(body + "\\begin{equation}n = 4\\end{equation}\n"); }) ==
             "text/main.tex:9:17: the PDF has no further number of a equation: it was made from "
             "another state of the "
             "document");
}

BOOST_AUTO_TEST_CASE(a_parenthesis_is_as_large_as_in_the_pdf) {
  const std::string html =
      page_of("\\(f(x)\\), \\(\\bigl(y\\bigr)\\) and \\(\\left(\\frac12\\right)\\)\n", "\\relax\n")
          .html;

  BOOST_TEST(holds(html, "<mo stretchy=\"false\" form=\"prefix\">(</mo><mi>x</mi>"), html);
  BOOST_TEST(holds(html, "<mo stretchy=\"true\" form=\"prefix\">(</mo><mfrac>"), html);
  BOOST_TEST(holds(html, "maxsize=\"1.2em\" stretchy=\"true\" form=\"prefix\">(</mo><mi>y</mi>"),
             html);
}

// Each was once read otherwise than by LaTeX.
BOOST_AUTO_TEST_CASE(what_pandoc_reads_otherwise_is_as_in_the_pdf) {
  const auto number = [](const char* counter, const char* shown, int order) {
    return fmt::format("\\LiterateNumber{{{0}}}{{{1}}}{{document}}{{{1}}}{{{2}}}\n", counter, shown,
                       order);
  };
  const std::string equations =
      number("equation", "7", 1) + number("equation", "8", 2) + number("equation", "8", 3);
  struct Construct {
    std::string latex, numbers, html;
  };
  for (const auto& [latex, numbers, wanted] : std::vector<Construct>{
           {"\\ifdim1cm>10pt more\\else less\\fi", "", "<p>more</p>"},
           {"\\ifdim72.2pt<1in less\\else more\\fi", "", "<p>less</p>"},
           {"\\url{https://e.org/a%20b} goes on", "", "goes on"},
           {"\\unit{\\joule\\per\\mole\\squared}", "", "J/mol<sup>2</sup>"},
           {"\\unit{\\watt\\per\\metre\\per\\kelvin}", "", "W/(m K)"},
           {"\\(\\unit{\\watt\\per\\metre\\per\\kelvin}\\)", "",
            "m</mtext><mspace width=\"0.167em\"></mspace><mtext mathvariant=\"normal\">K"},
           {"\\makebox[4em][l]{$a$}width", "", "style=\"min-width:4em\"><math"},
           {"\\part{A}\\section*{B}\\bookmarksetup{startatroot}\\section*{C}",
            "\\LiterateNumber{part}{I}{document}{Part}{1}\n", "<li class=\"lit-toc-root\">"},
           {"\\qty{7}{\\per\\metre}", "", "7/m"},
           {"a\\footnotemark[7] b\\footnotemark[8] \\footnotetext[7]{one}", "",
            "id=\"note-1\" role=\"note\">one"},
           {"\\begin{tabular}{r@{.}l}1 & 5\\end{tabular}", "", ">1.5</td>"},
           {"\\stepcounter{run}\\therun", number("run", "2-b", 1), "2-b"},
           {"\\begin{eqnarray}a & = & b\\end{eqnarray}\\begin{equation}c\\end{equation}", equations,
            "(8)"},
           {"\\begin{enumerate}\\item[*] a\\end{enumerate}", "", "lit-item\">*<"},
           {"\\begin{enumerate}\\item a\\end{enumerate}", number("enumi", "(a)", 1),
            "lit-item\">(a)<"},
           {"\\author{A \\and B}\\maketitle", "", "A</span>, <span class=\"lit-author\">B"}}) {
    const Page page = page_of(latex + "\n", numbers + "\\relax\n");
    BOOST_TEST_CONTEXT(latex) {
      BOOST_TEST(page.errors.empty());
      BOOST_TEST(holds(page.html, wanted), page.html);
    }
  }
}

BOOST_AUTO_TEST_CASE(plain_text_keeps_exponents_indices_and_fractions) {
  BOOST_TEST(text_of_html("at most 7.5 × 10<sup>−5</sup>, by CO<sub>2</sub>") ==
             "at most 7.5 × 10⁻⁵, by CO₂");
  BOOST_TEST(text_of_html("order <math><mfrac><mn>1</mn><mn>2</mn></mfrac></math> of "
                          "<msub><mi>p</mi><mn>0</mn></msub>") == "order 1/2 of p₀");
  BOOST_TEST(text_of_html("<msup><mi>m</mi><mrow><mo>−</mo><mn>2</mn></mrow></msup>") == "m⁻²");
}

BOOST_AUTO_TEST_CASE(rows_of_a_display_are_as_large_as_one_line) {
  const std::string html = page_of(
                               "\\begin{align*} a &= \\frac12 \\\\ b &= 3 \\end{align*} "
                               "and \\[\\begin{pmatrix} 1 & 2 \\end{pmatrix}\\]\n",
                               "\\relax\n")
                               .html;

  BOOST_TEST(holds(html, "<mtable displaystyle=\"true\"><mtr><mtd columnalign=\"right\""), html);
  BOOST_TEST(holds(html, "<mtable><mtr>"), html);
}

BOOST_AUTO_TEST_CASE(no_line_breaks_between_a_formula_and_the_sign_behind_it) {
  const std::string html = page_of("Of \\(a\\), (\\(b\\)) and \\(c\\) more.\n", "\\relax\n").html;

  BOOST_TEST(holds(html, "<mi>a</mi></math>,</span> "), html);
  BOOST_TEST(holds(html, "<span class=\"lit-close\">(<math"), html);
  BOOST_TEST(holds(html, "<mi>b</mi></math>)</span> and <math"), html);
}

BOOST_AUTO_TEST_CASE(letters_are_upright_where_tex_has_them_so) {
  const std::string html =
      page_of("\\(p_{\\mathrm{max}}\\), \\(\\mathrm d\\Delta\\)\n", "\\relax\n").html;

  BOOST_TEST(holds(html, "<mi mathvariant=\"normal\">max</mi>"), html);
  BOOST_TEST(holds(html, "<mi mathvariant=\"normal\">d</mi>"), html);
  BOOST_TEST(holds(html, "<mi mathvariant=\"normal\">Δ</mi>"), html);
}

BOOST_AUTO_TEST_CASE(the_name_of_an_operator_has_a_thin_space_beside_letters_alone) {
  const std::string html = page_of("\\[a\\ln x = \\ln(x) + \\sin^2 y\\]\n", "\\relax\n").html;

  for (const char* part : {"<mi>a</mi><mo lspace=\"0.167em\" rspace=\"0.167em\">ln</mo><mi>x</mi>",
                           "<mo>=</mo><mo lspace=\"0em\" rspace=\"0em\">ln</mo><mrow>",
                           "<mo>+</mo><msup><mo lspace=\"0em\" rspace=\"0.167em\">sin</mo>"}) {
    BOOST_TEST(holds(html, part), part << " in " << html);
  }
}

BOOST_AUTO_TEST_CASE(drawings_of_one_line_stay_beside_each_other) {
  const std::string drawing = "\\includegraphics{main.tex}";
  const std::string html = page_of(drawing + "\\hfill" + drawing + "\n", "\\relax\n").html;

  BOOST_TEST(holds(html, "<div class=\"lit-row\" tabindex=\"0\""), html);
}

BOOST_AUTO_TEST_CASE(a_minus_of_a_number_stands_close_to_it) {
  const std::string html = page_of("\\[a=-b-c\\]\n", "\\relax\n").html;

  BOOST_TEST(holds(html, "<mo>=</mo><mo form=\"prefix\">−</mo><mi>b</mi><mo>−</mo><mi>c</mi>"),
             html);
}

BOOST_AUTO_TEST_SUITE_END()
