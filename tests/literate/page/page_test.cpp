// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(page_test)

using namespace literate;

namespace {

const std::string values = R"(\LiterateValue{period}{\qty{1.2}{s}}{1.2 s}
\LiterateRaw{period}{1.23}
\LiterateValue{angle}{\num{-90}}{-90}
\LiterateFlag{is-wide}{true}
\LiterateClaim{longer}{refuted}
\LiterateClaim{short}{partly confirmed}
)";
const std::string statements =
    R"(\LiterateStatement{longer}{C1}{cited}{paper, p.~8}{It is \quoted{long}.}
\LiterateStatement{short}{R1}{own}{}{It is short.}
\LiterateQuotation{long}{8}{longer than long}
\LiterateCount{cited}{all}{1}\LiterateCount{cited}{confirmed}{0}\LiterateCount{cited}{partly confirmed}{0}
\LiterateCount{cited}{refuted}{1}\LiterateCount{cited}{undecided}{0}\LiterateCount{cited}{unexpected}{0}
\LiterateCount{own}{all}{1}\LiterateCount{own}{confirmed}{0}\LiterateCount{own}{partly confirmed}{1}
\LiterateCount{own}{refuted}{0}\LiterateCount{own}{undecided}{0}\LiterateCount{own}{unexpected}{0}
)";
const std::string claims =
    R"(\LiterateLedgerEntry{longer}{by measuring}{refuted}{refuted}{src/main.cpp:3}{%
  \LiterateCriterion{length}{\num{2}}{$\le$~\num{1}}{derived}{so}{fails}{}%
  \LiterateCriterion{width}{\num{3}}{$\le$~\num{4}}{regression band}{since}{holds}{}%
}
\LiterateLedgerEntry{short}{by eye}{partly confirmed}{partly confirmed}{src/main.cpp:9}{}
)";
const std::string periods = R"(\begin{tabular}{cc}
  \toprule
   & \multicolumn{1}{c}{found} \\
  \cmidrule(lr){2-2}
  $x$ & $T$ \\
  \midrule
  \LiterateCell{1.1}{0.5}{0.5} & \textendash{} \\
  \bottomrule
\end{tabular})";

/// A document whose body is `body`, with what a program generated.
class Document {
 public:
  explicit Document(const std::string& body, const std::string& preamble = {}) {
    folder_.write("paper/paper.tex", "\\documentclass{article}\n\\usepackage{unheard-of}\n" +
                                         preamble + "\\begin{document}\n" + body +
                                         "\n\\end{document}\nignored");
    folder_.write("generated/values.tex", values);
    folder_.write("generated/claims.tex", claims);
    folder_.write("generated/tables/periods.tex", periods);
    folder_.write("generated/figures/period/period.tex", "");
    folder_.write("generated/figures/other/other.tex", "");
    folder_.write("generated/excerpts/rule.txt", "int x;\n");
    folder_.write("generated/excerpts/rule.tex",
                  "\\LiterateListing{rule}{src/\\allowbreak{}main\\_a.cpp}{7}{7}{[20]C++}");
  }

  const TemporaryFolder& folder() const { return folder_; }

  Page page() const {
    return write_page({.document = folder_ / "paper",
                       .main_file = "paper.tex",
                       .generated = folder_ / "generated",
                       .statements = statements,
                       .restyled = "\\LiterateRestyled{period}{[digits=1]}{\\qty{1}{s}}{1 s}\n",
                       .bibliography = [](const std::string& aux) {
                         return "% " + aux.substr(0, 0) +
                                "\n\\begin{thebibliography}{1}\n\\bibitem{landau} L.~Landau.\n"
                                "\\newblock {\\em Mechanics}.\n\\end{thebibliography}\n";
                       }});
  }

 private:
  TemporaryFolder folder_;
};

std::string html_of(const std::string& body, const std::string& preamble = {}) {
  const Page page = Document(body, preamble).page();
  BOOST_TEST(page.errors.empty(), (page.errors.empty() ? "" : page.errors.front()));
  const std::size_t begin = page.html.find("<main");
  return page.html.substr(begin, page.html.find("</main>") - begin);
}

std::vector<std::string> errors_of(const std::string& body) {
  return Document(body).page().errors;
}

bool contains(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  if (!found) BOOST_TEST_MESSAGE("not in: " << text);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(paragraphs_end_at_empty_lines_and_go_on_behind_a_displayed_formula) {
  const std::string html = html_of("a\nb\n\nc \\[x\\] d\n\ne");

  BOOST_TEST(contains(html,
                      "<p>a b</p>\n<p>c</p>\n<div class=\"lit-equation\" tabindex=\"0\" "
                      "role=\"group\" aria-label=\"Formula\"><math display=\"block\""));
  BOOST_TEST(contains(html, "</div>\n<p class=\"lit-continued\">d</p>\n<p>e</p>"));
}

BOOST_AUTO_TEST_CASE(quotation_marks_and_dashes_are_those_of_print) {
  BOOST_TEST(contains(html_of("``a'' 1--2 it's <x> \\& \\%"), "“a” 1–2 it’s &lt;x&gt; &amp; %"));
  BOOST_TEST(contains(html_of("\\texttt{a--b}"), "<code>a--b</code>"));
}

BOOST_AUTO_TEST_CASE(a_style_ends_with_its_group_and_goes_on_in_the_next_paragraph) {
  BOOST_TEST(contains(html_of("{\\em a\n\nb} c"), "<p><em>a</em></p>\n<p><em>b</em> c</p>"));
}

BOOST_AUTO_TEST_CASE(a_value_has_its_key) {
  const std::string html = html_of("It is \\val{period}, some \\val[digits=1]{period}.");

  BOOST_TEST(contains(html,
                      "<span class=\"lit-value\" data-key=\"period\" id=\"use-val-period-1\"><span "
                      "class=\"lit-nowrap\">1.2\u202Fs</span></span>, some"));
  BOOST_TEST(contains(html, ">1\u202Fs</span></span>."));
}

BOOST_AUTO_TEST_CASE(a_value_in_a_formula_has_its_key_too) {
  BOOST_TEST(contains(html_of("$x = \\val{angle}$"),
                      "<mo>=</mo><mtext><span class=\"lit-value\" data-key=\"angle\""));
}

BOOST_AUTO_TEST_CASE(a_flag_chooses_its_branch) {
  BOOST_TEST(contains(html_of("a \\ifflag{is-wide}{wide}{narrow} b"), "<p>a wide b</p>"));
}

BOOST_AUTO_TEST_CASE(a_claim_leads_to_its_entry_in_the_ledger_and_the_entry_back) {
  const std::string html = html_of("\\section{One}Long.\\claim{longer}\n\\claimledger");

  BOOST_TEST(contains(html,
                      "<a class=\"lit-claim\" id=\"use-claim-longer-1\" data-claim=\"longer\" "
                      "data-verdict=\"refuted\" href=\"#claim-longer\""));
  BOOST_TEST(contains(html,
                      "id=\"claim-longer\" data-claim=\"longer\" data-verdict=\"refuted\" "
                      "data-origin=\"paper\""));
  BOOST_TEST(contains(html,
                      "id=\"claim-short\" data-claim=\"short\" data-verdict=\"partly\" "
                      "data-origin=\"ours\""));
  BOOST_TEST(contains(html, "used in <a class=\"lit-ref\" href=\"#use-claim-longer-1\">§ 1</a>"));
  BOOST_TEST(contains(html, "<li data-outcome=\"fails\">length: "));
}

BOOST_AUTO_TEST_CASE(a_criterion_tells_what_was_found_and_its_limit_with_kind_and_reason) {
  const std::string html = html_of("Long.\\claim{longer}\n\\claimledger");

  BOOST_TEST(contains(html,
                      "<li data-outcome=\"fails\">length: <strong><span "
                      "class=\"lit-nowrap\">2</span></strong> <span class=\"lit-nowrap\">["));
  BOOST_TEST(
      contains(html,
               "1</span></span>, derived: so]. <span class=\"lit-outcome\">Fails.</span></li>"),
      html);
  BOOST_TEST(contains(
      html, "4</span></span>, regression band: since]. <span class=\"lit-outcome\">Holds.</span>"));
}

BOOST_AUTO_TEST_CASE(a_sign_by_itself_has_no_room_around_it) {
  BOOST_TEST(contains(html_of("$\\le$ 1"), "<mo lspace=\"0em\" rspace=\"0em\">≤</mo></math> 1"));
  BOOST_TEST(contains(html_of("$a\\le b$"), "<mo>≤</mo>"));
}

BOOST_AUTO_TEST_CASE(a_kind_of_limit_may_be_a_letter_that_tells_its_name) {
  const std::string html = html_of("\\limitkind{derived}{\\textbf{d}}\\claimledger");

  BOOST_TEST(
      contains(html, "1</span></span>, <abbr title=\"derived\"><strong>d</strong></abbr> so]."),
      html);
  BOOST_TEST(contains(html, "4</span></span>, regression band: since]."));
  BOOST_TEST(contains(errors_of("\\limitkind{guess}{g}").at(0),
                      "\\limitkind{guess}: there is no kind of limit of this name"));
}

BOOST_AUTO_TEST_CASE(a_finding_has_the_sentence_of_its_claim_or_shorter_words) {
  const std::string table = "\\begin{findings}\\finding{longer}{It is.}\\end{findings}";

  const std::string whole = html_of(table);
  BOOST_TEST(contains(whole,
                      "It is <span class=\"lit-quoted\">“longer than long”</span>. <span "
                      "class=\"lit-ledger-source\">(paper, "),
             whole);
  BOOST_TEST(contains(html_of("\\findingsays{longer}{Long (\\quotedpage{long}).}" + table),
                      "Long (p.\u00A08).</td>"));
  BOOST_TEST(contains(errors_of("\\findingsays{unheard}{x}").at(0),
                      "\\findingsays{unheard}: there is no claim of this name"));
}

BOOST_AUTO_TEST_CASE(the_day_of_the_commit_is_told_in_words) {
  BOOST_TEST(
      contains(html_of("\\LiterateRepository{abc}{false}{2026-11-05T12:00:00Z}Of \\paperday."),
               "Of 5 November 2026."));
  BOOST_TEST(
      contains(html_of("\\LiterateRepository{abc}{false}{unknown}Of \\paperday."), "Of unknown."));
  BOOST_TEST(contains(html_of("Of \\paperday."), "Of unknown."));
}

BOOST_AUTO_TEST_CASE(a_figure_beside_a_table_is_a_figure_by_itself) {
  const std::string html = html_of(
      "\\begin{table}\\begin{minipage}{4cm}\\captionsetup{type=figure,width=3cm}\\fig{period}"
      "\\caption{Drawn.}\\label{a}"
      "\\end{minipage}\\begin{minipage}{4cm}\\caption{Told.}\\label{b}\\tab{periods}\\end{minipage}"
      "\\end{table}"
      "See \\ref{a} and \\cref{b}.");

  BOOST_TEST(contains(html, "<figure class=\"lit-figure\" id=\"a\" data-figure=\"period\">"), html);
  BOOST_TEST(contains(html, "<figure class=\"lit-table-float\" id=\"b\">"));
  BOOST_TEST(contains(html, "Figure 1</span>: Drawn."));
  BOOST_TEST(contains(html, "Table 1</span>: Told."));
  BOOST_TEST(contains(html, "alt=\"Drawn.\""));
}

BOOST_AUTO_TEST_CASE(without_a_ledger_a_claim_leads_nowhere) {
  const std::string html = html_of("Long.\\claim{longer}");

  BOOST_TEST(contains(html, "data-claim=\"longer\""));
  BOOST_TEST(html.find("#claim-longer") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(levels_of_headings_are_never_skipped) {
  const std::string html = html_of(
      "\\maketitle\\section{A}\\subsubsection{B}\\part{P}\\section{C}\\subsection{D}"
      "\\appendix\\section{E}",
      "\\title{T}\\author{}\\date{}\n");

  BOOST_TEST(contains(html, "<h1>T</h1>"));
  BOOST_TEST(contains(
      html, "<h2 id=\"a\" class=\"lit-section\"><span class=\"lit-number\">1</span> A</h2>"));
  BOOST_TEST(contains(html, "<h3 id=\"b\" class=\"lit-subsubsection\">"));
  BOOST_TEST(contains(
      html, "<h2 id=\"p\" class=\"lit-part\"><span class=\"lit-number\">Part I</span> P</h2>"));
  BOOST_TEST(
      contains(html, "<h3 id=\"c\" class=\"lit-section\"><span class=\"lit-number\">2</span>"));
  BOOST_TEST(contains(
      html, "<h4 id=\"d\" class=\"lit-subsection\"><span class=\"lit-number\">2.1</span>"));
  BOOST_TEST(
      contains(html, "<h2 id=\"e\" class=\"lit-section\"><span class=\"lit-number\">A</span>"));
}

BOOST_AUTO_TEST_CASE(a_formula_in_a_heading_is_whole_in_the_contents) {
  const Page page = Document("\\section{The ratio $\\Delta p/p_0$}").page();
  const std::string formula = page.html.substr(page.html.find("<math"),
                                               page.html.find("</math>") - page.html.find("<math"));

  BOOST_TEST(contains(page.html, "<nav id=\"contents\""));
  BOOST_TEST(page.html.find(formula) != page.html.rfind(formula));
}

BOOST_AUTO_TEST_CASE(references_of_two_kinds_have_a_number_each) {
  const std::string floats =
      "\\begin{table}\\caption{T.}\\label{tab:a}\\tab{periods}\\end{table}\n"
      "\\begin{table}\\caption{T.}\\label{tab:b}\\tab{periods}\\end{table}\n"
      "\\begin{figure}\\fig{period}\\caption{F.}\\label{fig:a}\\end{figure}\n";

  BOOST_TEST(
      contains(html_of(floats + "\\Cref{tab:b,fig:a}"),
               "<p><a class=\"lit-ref\" href=\"#tab:b\">Table\u00A02</a> and <a class=\"lit-ref\" "
               "href=\"#fig:a\">Figure\u00A01</a></p>"));
  BOOST_TEST(
      contains(html_of(floats + "\\cref{tab:a,tab:b}"),
               "href=\"#tab:a\">tables\u00A01</a> and <a class=\"lit-ref\" href=\"#tab:b\">2</a>"));
}

BOOST_AUTO_TEST_CASE(three_references_in_a_row_are_a_range) {
  const std::string equations =
      "\\begin{align}a\\label{e:1}\\\\b\\label{e:2}\\\\c\\label{e:3}\\end{align}";

  BOOST_TEST(contains(html_of(equations + "\\cref{e:1,e:2,e:3}"),
                      ">eqs.\u00A0(1)</a> to <a class=\"lit-ref\" "
                      "href=\"#e:3\">(3)</a>"));
}

BOOST_AUTO_TEST_CASE(a_tag_is_the_number_of_its_equation) {
  const std::string html =
      html_of("\\begin{equation}a\\tag{3$'$}\\label{eq:p}\\end{equation} \\ref{eq:p}");

  BOOST_TEST(contains(html,
                      "<div class=\"lit-equation\" id=\"eq:p\" tabindex=\"0\" role=\"group\" "
                      "aria-label=\"Equation (3"));
  BOOST_TEST(contains(html, "<span class=\"lit-equation-number\">(3<math"));
}

BOOST_AUTO_TEST_CASE(a_heading_that_is_a_formula_has_its_letters_as_name) {
  const std::string html =
      html_of("\\begin{tabular}{lr}$x$&cost of $x$\\\\\\midrule 1&2\\\\\\end{tabular}");

  BOOST_TEST(contains(html, "scope=\"col\"><math aria-label=\"x\""));
  BOOST_TEST(contains(html, "scope=\"col\">cost of <math"));
}

BOOST_AUTO_TEST_CASE(a_figure_has_its_name_and_its_caption_as_description) {
  const std::string html =
      html_of("\\begin{figure}\\fig{period}\\caption{At \\val{angle}.}\\label{fig:p}\\end{figure}");

  BOOST_TEST(
      contains(html, "<figure class=\"lit-figure\" id=\"fig:p\" data-figure=\"period\">\n<img"));
  BOOST_TEST(contains(html, "src=\"figures/period.svg\" alt=\"At \u221290.\">"));
  BOOST_TEST(contains(html, "<figcaption><span class=\"lit-label\">Figure 1</span>: At "));
}

BOOST_AUTO_TEST_CASE(a_table_has_its_name_and_no_heading_without_words) {
  const std::string html = html_of("\\begin{table}\\caption{T.}\\tab{periods}\\end{table}");

  BOOST_TEST(contains(html, "<figure class=\"lit-table-float\" id=\"table-1\">\n<figcaption>"));
  BOOST_TEST(contains(html,
                      "<table class=\"lit-table\" data-table=\"periods\">\n<thead>\n<tr><td "
                      "class=\"lit-middle\"></td><th class=\"lit-middle lit-rule-below\" "
                      "scope=\"col\">found</th></tr>"));
  BOOST_TEST(contains(
      html, "<td class=\"lit-middle lit-numeric\">0.5</td><td class=\"lit-middle\">–</td>"));
}

BOOST_AUTO_TEST_CASE(a_listing_has_its_place_in_the_sources) {
  const std::string html = html_of("\\excerpt[The rule]{rule} \\ref{lst:rule}");

  BOOST_TEST(
      contains(html, "id=\"lst:rule\" data-listing=\"src/main_a.cpp:7-7\" data-language=\"C++\""));
  BOOST_TEST(contains(html, "The rule. <code>src/main_a.cpp</code>, line\u00A07"));
  BOOST_TEST(contains(html, "data-line=\"7\"><span class=\"lit-keyword\">int</span> x;"));
}

BOOST_AUTO_TEST_CASE(a_footnote_stands_beside_its_mark) {
  BOOST_TEST(
      contains(html_of("a\\footnote{Not \\emph{b}.} c"),
               "<a id=\"noteref-1\" href=\"#note-1\" aria-label=\"footnote 1\">1</a></sup><span "
               "class=\"lit-note\" id=\"note-1\" role=\"note\"><span class=\"lit-number\">1</span> "
               "Not <em>b</em>.</span> c</p>"));
}

BOOST_AUTO_TEST_CASE(citations_lead_to_the_bibliography) {
  const std::string html = html_of("\\cite[p.~3]{landau}\n\\bibliography{x}");

  BOOST_TEST(contains(html, "[<a class=\"lit-cite\" href=\"#bib-landau\">1</a>, p.\u00A03]"));
  BOOST_TEST(
      contains(html,
               "<li id=\"bib-landau\"><span class=\"lit-bib-label\">[1]</span> L.\u00A0Landau. "
               "<em>Mechanics</em>.</li>"));
}

BOOST_AUTO_TEST_CASE(lists_hold_paragraphs_and_labels) {
  BOOST_TEST(contains(html_of("\\begin{itemize}\\item a\\item b\n\nc\\end{itemize}"),
                      "<ul>\n<li>a</li>\n<li><p>b</p>\n<p>c</p>\n</li>\n</ul>"));
  BOOST_TEST(contains(html_of("\\begin{description}\\item[k] v\\end{description}"),
                      "<dl>\n<dt>k</dt><dd>v</dd>\n</dl>"));
  BOOST_TEST(contains(html_of("\\begin{enumerate}\\item\\label{i} a\\end{enumerate}\\ref{i}"),
                      "<li id=\"i\">a</li>"));
}

BOOST_AUTO_TEST_CASE(environments_and_theorems_of_the_document_are_known) {
  const std::string preamble =
      "\\newenvironment{loud}[1]{\\textbf{#1}: }{!}\n\\newtheorem{lemma}{Lemma}\n";

  BOOST_TEST(contains(html_of("\\begin{loud}{a}b\\end{loud}", preamble), "<strong>a</strong>: b!"));
  BOOST_TEST(contains(html_of("\\begin{lemma}\\label{l}b\\end{lemma}\\cref{l}", preamble),
                      "<div class=\"lit-theorem\" id=\"l\">\n<p><strong>Lemma 1</strong>. b</p>"));
}

BOOST_AUTO_TEST_CASE(a_comparison_of_numbers_is_made) {
  BOOST_TEST(contains(html_of("\\ifdim\\rawval{period}pt>1pt long\\else short\\fi"), "long"));
  BOOST_TEST(contains(html_of("\\ifdim\\rawval{period}pt>2pt long\\else short\\fi"), "short"));
}

BOOST_AUTO_TEST_CASE(what_the_page_does_not_know_is_told_with_its_place) {
  const auto errors = errors_of("a\n \\unheard{x}");

  BOOST_REQUIRE(errors.size() == 1U);
  BOOST_TEST(errors.front() == "paper/paper.tex:5:2: \\unheard is not known to the page");
}

BOOST_AUTO_TEST_CASE(unknown_names_are_told) {
  BOOST_TEST(errors_of("\\val{none}").size() == 1U);
  BOOST_TEST(errors_of("\\claim{none}").size() == 1U);
  BOOST_TEST(errors_of("\\fig{none}").size() == 1U);
  BOOST_TEST(errors_of("\\tab{none}").size() == 1U);
  BOOST_TEST(errors_of("\\ref{none}").size() == 1U);
  BOOST_TEST(errors_of("\\cite{none}").size() == 1U);
  BOOST_TEST(errors_of("\\begin{none}a\\end{none}").size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_file_for_the_page_alone_defines_what_packages_do) {
  const Document document("\\unheard{x}");
  document.folder().write("paper/page.tex", "\\newcommand\\unheard[1]{heard #1}");

  const Page page = document.page();

  BOOST_TEST(page.errors.empty());
  BOOST_TEST(contains(page.html, "<p>heard x</p>"));
}

BOOST_AUTO_TEST_CASE(figures_and_pictures_are_listed) {
  const Document document("\\fig{period} \\fig{other} \\image{rig.png}");
  document.folder().write("paper/rig.png", "");

  const Page page = document.page();

  BOOST_TEST(page.figures.size() == 2U);
  BOOST_REQUIRE(page.pictures.size() == 1U);
  BOOST_TEST(page.pictures.front() == "rig.png");
}

BOOST_AUTO_TEST_CASE(no_mark_is_left_and_no_id_is_given_twice) {
  const Page page =
      Document("\\section{A}\\section{A}\\val{period}\\claim{longer}\\claimledger").page();

  BOOST_TEST(page.html.find('\x01') == std::string::npos);
  BOOST_TEST(contains(page.html, "<h2 id=\"a-2\""));
}

BOOST_AUTO_TEST_SUITE_END()
