#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""page_test.py: papers of four classes become complete pages, and documents that cannot be converted are refused."""

import base64
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import browser
import text

HERE = Path(__file__).resolve().parent
TESTS = HERE.parent
ENGINE = TESTS.parents[1] / "src/literate"
TOOLS = ("latexml", "pdflatex", "gnuplot", "pdftocairo", "woff2_compress")
SKIPPED = 77

PICTURE = "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAAAAABX3VL4AAAADklEQVR4nGNwaGBoOAAABQYCAQmUMwAAAAAASUVORK5CYII="  # a PNG of four points
MAIN = r"""\documentclass%s
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage{amsmath}
\usepackage{literate}
\hyphenpenalty10000\sloppy
\usepackage[hidelinks]{hyperref}
\title{What a swing of \val{length} takes}
\author{Ada Lovelace\thanks{To whom letters go.} \and Marie Curie}
\begin{document}
\maketitle
\begin{abstract}
It takes \val{period}, not less~\cite{euler}.
\end{abstract}
%s
\section{Claims}\label{sec:claims}
\claimledger
\attachdata
\begin{thebibliography}{9}
\bibitem{huygens} C. Huygens, \emph{Horologium}, 1673.
\bibitem{euler} L. Euler, \textbf{12}, 3--4 (1749).
\end{thebibliography}
\end{document}
"""
CLASSES = {
    "article": ("[a4paper]{article}", r"\tableofcontents\input{body}\appendix"),
    "columns": ("[a4paper,twocolumn]{article}", r"\input{body}\appendix"),
    "ieeetran": ("[journal]{IEEEtran}", r"\input{body}\appendices"),
    "chapters": ("{report}", r"\tableofcontents\chapter{One}\label{ch:one}\include{body}\appendix\chapter{Two}"),
}


class Paper:
    """A paper in a folder: the results of the test pendulum with separate prose."""

    def __init__(self, folder, kind="article"):
        self.folder, self.output = folder, folder / "build" / kind
        self.generated, self.latex = self.output / "generated", self.output / "latex"
        self.page, self.settings = self.output / f"{kind}.html", folder / f"build/{kind}.json"
        for part in re.split("^=== ", (TESTS / "pendulum/folder.txt").read_text(), flags=re.MULTILINE)[1:]:
            name, text = part.split("\n", 1)
            (self.generated / name).parent.mkdir(parents=True, exist_ok=True)
            (self.generated / name).write_text(text)
        (self.generated / "repository.tex").write_text("\\LiterateRepository{0123abc}{2028-11-28}\n")
        (folder / "picture.png").write_bytes(base64.b64decode(PICTURE))
        (folder / "case.toml").write_text("\n")
        shutil.copy(HERE / "body.tex", folder)
        self.write(kind + ".tex", MAIN % CLASSES[kind])
        self.settings.write_text(json.dumps({
            "name": kind, "source": str(folder), "document": str(folder), "main": f"{kind}.tex", "case": str(folder / "case.toml"),
            "output": str(self.output), "build": str(folder / "build"), "scripts": str(folder / "period.gp")}
            | dict.fromkeys(("faults", "results_program", "program", "script", "sources", "configure", "versions"), "")))
        self.draw('plot periods using "angle":"integral" with lines title "$T$"')

    def write(self, name, content):
        (self.folder / name).write_text(content, encoding="utf-8")

    def replace(self, file, old, new):
        content = file.read_text(encoding="utf-8")
        assert old in content, old
        file.write_text(content.replace(old, new), encoding="utf-8")

    def draw(self, script):
        self.write("period.gp", script + "\n")
        ended = self.literate("draw", self.settings, "period")
        assert ended.returncode == 0, ended.stderr

    def literate(self, *arguments):
        return subprocess.run([sys.executable, "-S", ENGINE / "tools/literate", *map(str, arguments)], cwd=self.folder,
                              capture_output=True, text=True)

    def typeset(self):
        ended = self.literate("typeset", self.settings, self.output / "stamp", self.output / "stamp.d")
        assert ended.returncode == 0, ended.stderr

    def html(self):
        return self.literate("html", self.settings)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="a paper ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def refused(self, paper, *parts):
        ended = paper.html()
        self.assertEqual(ended.returncode, 2, ended.stderr)
        for part in parts:
            self.assertIn(part, ended.stderr)
        self.assertFalse(paper.page.exists())


class Pages(Case):
    def page_of(self, kind):
        paper = Paper(self.folder, kind)
        paper.typeset()
        ended = paper.html()
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        self.assertEqual(ended.stdout, f"build/{kind}/{kind}.html\n")
        return paper

    def has_the_same_words(self, paper, *apart):
        """Compares words and decimals, except the ledger's column heads and the words `apart`, which the page spells differently."""
        missing, in_pdf, on_page = text.differences(paper.output / f"{paper.output.name}.pdf", paper.page, paper.output / "page/pdf.pdf",
                                                    paper.generated / "ledger.tex")
        self.assertLessEqual(set(missing), {"statement", "and", "test", "limit", "from", "dφ", *apart})
        self.assertEqual((list(in_pdf), list(on_page)), ([], []))

    def can_be_read(self, paper):
        for width, scheme, background in ((1280, "light", "rgb(255, 255, 255)"), (390, "dark", "rgb(23, 25, 28)")):
            for opens_card in (False, True):
                with self.subTest(width=width, opens_card=opens_card):
                    found = browser.look(paper.page, width, scheme, opens_card)
                    self.assertEqual(found["violations"], [])
                    self.assertEqual((found["requests"], found["dead"], found["blind"]), ([], [], 0))
                    self.assertEqual((found["width"], found["background"], found["cards"]), (width, background, 2))
                    for part in ("C1", "Wide swings", "18.0", "a tenth", "1.8 times") if opens_card else ():
                        self.assertIn(part, found["card"])

    def test_article_gives_the_same_page_twice(self):
        paper = self.page_of("article")
        self.has_the_same_words(paper)
        self.can_be_read(paper)
        page = paper.page.read_text(encoding="utf-8")
        for what, pattern in (
                ("a space between number and unit", r'<mn>10</mn><mn>7</mn></msup><mo lspace="0\.1\d*em">\u2062</mo><mi>psi</mi>'),
                ("all rows of a table's head", r"<thead(?:(?!</thead>).)*<th[^>]*>(<[^>]*>)?integral<"),
                ("the level of a heading", r"<h2[^>]*>\s*<span[^>]*>2 </span>Theory</h2>"),
                ("the font of formulas", r'url\("data:font/woff2;base64,'),
                ("a drawing as SVG with its caption", r'<img src="data:image/svg[^>]* alt="The period over that of small swings, T/T0 \."')):
            self.assertTrue(re.search(pattern, page, re.DOTALL), what)
        self.assertNotIn("expl3", (paper.output / "page/latexml.log").read_text(encoding="utf-8"))
        with tempfile.NamedTemporaryFile() as of_others:
            self.assertEqual(paper.html().returncode, 0)
            self.assertTrue(Path(of_others.name).exists(), "an empty temporary file of a different program was deleted")
        self.assertEqual(paper.page.read_text(encoding="utf-8"), page)

    def test_two_columns(self):
        self.has_the_same_words(self.page_of("columns"))

    @unittest.skipUnless(subprocess.run(["kpsewhich", "IEEEtran.cls"], capture_output=True).stdout, "texlive-publishers is missing")
    def test_ieeetran(self):
        paper = self.page_of("ieeetran")
        # This class prints capitals of two sizes, so that the PDF has the first letter of a word apart.
        self.has_the_same_words(paper, "eriods", "heory", "laims", "eferences", "ppendix", "mall", "swhat", "fig")
        self.can_be_read(paper)

    def test_report_with_chapters_in_separate_files(self):
        paper = self.page_of("chapters")
        self.has_the_same_words(paper)
        self.can_be_read(paper)

    def test_large_drawing_is_a_picture(self):
        paper = Paper(self.folder)
        paper.draw("set samples 40000\nplot [0:1] for [k=1:4] sin(9*k*x+rand(0)) notitle")
        paper.typeset()
        self.assertEqual(paper.html().returncode, 0)
        self.assertEqual(paper.page.read_text(encoding="utf-8").count("data:image/png"), 2)

    def test_failed_claim_is_on_the_page(self):
        paper = Paper(self.folder)
        with (paper.generated / "values.tex").open("a") as file:
            file.write("\\LiterateFailed{1}\n")
        paper.replace(paper.generated / "results.json", '"failed": []', '"failed": ["claim longer: fails, expected: holds"]')
        paper.typeset()
        ended = paper.html()
        self.assertEqual((ended.returncode, ended.stderr), (1, "claim longer: fails, expected: holds\n"))
        self.assertIn("Not to be trusted: 1 check or claim failed", paper.page.read_text(encoding="utf-8"))

    def test_site_has_page_pdf_and_data(self):
        paper = Paper(self.folder)
        paper.typeset()
        self.assertEqual(paper.literate("site", paper.settings, "case.toml").returncode, 0)
        site = paper.output / "site"
        files = {str(file.relative_to(site)) for file in site.rglob("*") if file.is_file()}
        self.assertLessEqual({"index.html", "article.pdf", "case.toml", "data/results.json", "data/values.csv", "data/claims.csv",
                              "data/tables/periods.csv", "data/figures/period/periods.csv"}, files)
        links = re.findall(r'href="([^"#:]+)"', (site / "index.html").read_text(encoding="utf-8"))
        self.assertTrue(links and set(links) <= files, links)

    def test_document_may_bring_a_binding_for_a_package(self):
        paper = Paper(self.folder)
        paper.write("swings.sty", r"\NewDocumentCommand\swing{m}{swing of #1}")
        paper.write("swings.sty.ltxml", "package LaTeXML::Package::Pool;\nuse LaTeXML::Package;\nDefMacro('\\swing{}', 'swing of #1');\n1;\n")
        paper.replace(self.folder / "article.tex", r"\maketitle", r"\maketitle A \swing{mine}.")
        paper.replace(self.folder / "article.tex", r"\title", r"\usepackage{swings}\title")
        paper.typeset()
        self.assertEqual(paper.html().returncode, 0)
        self.assertIn("A swing of mine.", paper.page.read_text(encoding="utf-8"))


class Refusals(Case):
    def test_numbers_that_differ_from_the_pdf(self):
        paper = Paper(self.folder)
        paper.typeset()
        aux = paper.latex / "article.aux"
        whole = aux.read_text(encoding="utf-8")
        lines = (self.folder / "body.tex").read_text(encoding="utf-8").splitlines()
        for label, begins, number in (("tab:periods", r"\begin{table}", "5"), ("sec:theory", r"\section{Theory}", "3"),
                                      ("eq:series", r"\begin{align}", "7")):
            with self.subTest(label=label):
                aux.write_text(re.sub(rf"(\\newlabel{{{label}}}{{{{)\d", rf"\g<1>{number}", whole), encoding="utf-8")
                ended = paper.html()
                self.assertEqual(ended.returncode, 2)
                place = re.search(rf"^body\.tex:(\d+):\d+: {label} has the number \d on the page and {number} in the PDF", ended.stderr)
                self.assertTrue(place, ended.stderr)
                self.assertAlmostEqual(int(place[1]), 1 + next(i for i, line in enumerate(lines) if begins in line), delta=3)
                self.assertFalse(paper.page.exists())
        aux.write_text(whole.replace(r"\bibcite{euler}{2}", r"\bibcite{euler}{3}"), encoding="utf-8")
        self.refused(paper, "euler has the number 2 on the page and 3 in the PDF")
        aux.write_text(re.sub(r"\\newlabel{fig:picture}.*\n", "", whole), encoding="utf-8")
        self.refused(paper, "body.tex:", "the PDF has no number for the label fig:picture")

    def test_label_that_latexml_loses(self):
        paper = Paper(self.folder)
        paper.replace(self.folder / "body.tex", "It is long.", r"It is long.\hypersetup{pdfsubject={\label{lost}}}\protect\ref{lost}")
        paper.typeset()
        paper.replace(paper.latex / "article.aux", r"\newlabel{sec:values}", "\\newlabel{lost}{{1}{1}{}{}{}}\n\\newlabel{sec:values}")
        self.refused(paper, "body.tex:6:", "the page has no label lost")

    def test_unknown_command(self):
        paper = Paper(self.folder)
        paper.replace(self.folder / "body.tex", "It is long.", r"\NewDocumentCommand\swing{}{swing}It is long.")
        paper.typeset()
        self.refused(paper, r"body.tex:6:", r"LaTeXML does not know \NewDocumentCommand")

    def test_package_in_expl3(self):
        paper = Paper(self.folder)
        paper.write("swings.sty", "\\ProvidesExplPackage{swings}{2028-11-28}{1}{}\n")
        paper.write("swings.sty.ltxml", "package LaTeXML::Package::Pool;\nuse LaTeXML::Package;\nRequirePackage('expl3');\n1;\n")
        paper.replace(self.folder / "article.tex", r"\title", "\\usepackage{swings}\n\\title")
        paper.typeset()
        self.refused(paper, "article.tex:", "a package uses expl3")

    def test_pdf_that_is_not_up_to_date(self):
        paper = Paper(self.folder)
        self.refused(paper, "build/article/article.pdf: the PDF is not up to date")
        paper.typeset()
        paper.page.write_text("an old page")
        paper.replace(self.folder / "body.tex", "It is long.", "It is very long.")
        self.refused(paper, "build/article/article.pdf: the PDF is not up to date")


if __name__ == "__main__":
    missing = [f"{name} is not installed" for name in TOOLS if not shutil.which(name)] or [browser.missing_tool()]
    if missing != [None]:
        print(f"skipped: {missing[0]}")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
