# SPDX-License-Identifier: GPL-3.0-or-later
"""The output of literate.sty in the PDF, and the uses that it records."""

import subprocess
import unittest

from paper import PaperTest

from literate_tools.settings import read_settings
from literate_tools.uses import read_uses

HEAD = r"""\documentclass[a4paper]{%s}
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage{literate}
%s
\begin{document}
"""


class Sty(PaperTest):
    def typeset(self, body: str, packages: str = "", document_class: str = "article") -> str:
        """Typesets a document and returns its words."""
        self.paper.write("paper/small.tex", HEAD % (document_class, packages) + body + "\n\\end{document}\n")
        self.make()
        return self.paper.text()

    def uses(self) -> list[tuple[str, str, str]]:
        """Returns the recorded uses with their places."""
        return [(use.kind, use.name, use.place) for use in read_uses(read_settings(self.paper.settings))]

    def test_values_are_printed_wherever_latex_prints(self):
        words = self.typeset(
            r"\tableofcontents\newpage\section{Head \val{x}, flag \ifflag{big}{big}{small}} Text\footnote{Foot \val[2]{x}.}, math $a = \val{x}$,"
            r"\textbf{bold \val{x}}, \textsc{small \val{share}}, {\rawval{x}}, \ifdim\rawval{x}pt>1pt more\fi."
            "\n\\begin{figure}\\caption{Caption \\val{x}.}\\end{figure}\\newpage\\markright{\\MakeUppercase{run \\val{title}}}end",
            r"\usepackage[bookmarksnumbered]{hyperref}\pagestyle{headings}")
        for part in ("1 Head 1.50 m, flag big", "Foot 1.5 m", "a = 1.50 m", "bold 1.50 m", "1.5", "more", "Caption 1.50 m", "RUN A & B"):
            self.assertIn(part, words)
        bookmarks = (self.paper.output / "latex" / "small.out").read_text()
        self.assertIn(r"\0001\000.\0005\0000\000\040\000m", bookmarks)
        self.assertIn(r"\000b\000i\000g", bookmarks)

    def test_each_use_is_recorded_once_with_its_place(self):
        self.typeset("\\tableofcontents\n\\section{\\val{x}}\n\\ifflag{big}{\\quoted{the words, 5\\,\\%}}{\\val{share}}\n\\input{sections/more}\n"
                     "\\statement[us]{short}{It is \\val[2]{x}.}\n\n\\fig{line}\\claim{short} \\parbox{1cm}{\\val{x}}\\claimledger")
        self.assertEqual(sorted(self.uses()), sorted([
            ("val", "x", "paper/small.tex:8"), ("ifflag", "big", "paper/small.tex:9"),
            ("quoted", "the words, 5\\,\\%", "paper/small.tex:9"), ("val", "share", "paper/sections/more.tex:1"),
            ("val", "title", "paper/sections/more.tex:1"), ("statement", "short", "paper/small.tex:11"),
            ("fig", "line", "paper/small.tex:13"), ("claim", "short", "paper/small.tex:13"),
            ("val", "x", "paper/small.tex:13"), ("val", "x", "paper/small.tex:11")]))  # the last one is printed by the ledger

    def test_a_verdict_is_in_the_margin_or_without_one_in_the_text(self):
        words = self.typeset("A sentence \\claim{short}.\n\nA box \\fbox{\\parbox{5cm}{boxed \\claim{short}}}, a note\\footnote{noted \\claim{short}}, "
                             "$x$ \\mbox{kept \\claim{short}}.\n\n\\claim{short} begins.\n\\begin{figure}\\caption{Captioned \\claim{short}.}\\end{figure}"
                             "\n\\begin{tabular}{p{5cm}}celled \\claim{short}\\end{tabular}")
        self.assertRegex(words, r"A sentence\. +C1 holds")
        for word in ("boxed", "noted", "kept", "Captioned", "celled"):
            self.assertRegex(words, rf"{word} +\[C1 holds\]")
        self.assertRegex(words, r"(?m)^ ?begins\.")

    @unittest.skipIf(subprocess.run(["kpsewhich", "IEEEtran.cls"], capture_output=True).returncode, "texlive-publishers is not installed")
    def test_in_two_narrow_columns_the_verdict_is_in_the_text(self):
        words = self.typeset("A sentence \\claim{short}. \\claimledger", "", "IEEEtran")
        self.assertRegex(words, r"A sentence +\[C1 holds\]\.")
        self.assertIn("1.50 m", words)

    def test_the_ledger_prints_sentence_source_test_and_planted_faults(self):
        self.paper.write("paper/severity.tex", "\\LiterateTurned{short}{big}\n")
        words = " ".join(self.typeset("\\statement[folklore, p.~3]{short}{It fits \\emph{well}, 5\\,\\%.}\n\\claimledger").split())
        for part in ("C1 holds. It fits well, 5 %. (folklore, p. 3)", "Route: the number itself; compute.py:12. Turned by these planted faults: big.",
                     "length (limit from choice: a", "room)", "1.50 m", "≤ 10 m"):
            self.assertIn(part, words)
        self.paper.replace("paper/small.tex", "It fits", "It does fit")
        self.make()
        self.assertIn("It does fit well", " ".join(self.paper.text().split()))

    def test_a_statement_leaves_no_space(self):
        words = self.typeset("One \\statement{short}{S.} two.\n\\[ x \\]\n\\statement{short}{S.}\nThree.")
        self.assertIn("One two.", words)
        self.assertRegex(words, r"(?m)^Three\.$")

    def test_attachdata_attaches_the_csv_files(self):
        self.typeset("\\attachdata text")
        listed = subprocess.run(["pdfdetach", "-list", self.paper.pdf], capture_output=True, text=True, check=True).stdout
        self.assertEqual([line.split()[-1] for line in listed.splitlines()[1:]], ["claims.csv", "tables.csv", "values.csv"])
        for name in ("claims.csv", "tables.csv", "values.csv"):
            saved = self.paper.folder / name
            subprocess.run(["pdfdetach", "-savefile", name, "-o", saved, self.paper.pdf], check=True, capture_output=True)
            self.assertEqual(saved.read_bytes(), (self.paper.output / "generated" / name).read_bytes())

    def test_case_commit_and_day_come_from_the_repository(self):
        self.assertIn("case.toml, no commit, undated, undated.", self.typeset("\\papercase, \\papercommit, \\paperday, \\today."))
        self.paper.environment |= {"GIT_COMMITTER_DATE": "2026-03-09T23:30:00-11:00", "TZ": "Asia/Tokyo"}
        environment = self.paper.environment
        subprocess.run("git init -q && git add -A && git -c user.name=a -c user.email=b commit -qm c", shell=True, cwd=self.paper.folder,
                       env=environment, check=True)
        self.make()
        self.assertRegex(self.paper.text(), r"case.toml, [0-9a-f]{12}, 9 March 2026, March 9, 2026\.")
        self.paper.replace("compute.py", "import literate", "import literate # edited")
        self.make()
        self.assertRegex(self.paper.text(), r"[0-9a-f]{12} with changes,")

    def test_tables_have_notes_and_drawings_come_from_the_folder_of_the_figure(self):
        self.paper.replace("compute.py", '["second", (2.5, 1e-3)]])', '["second", (2.5, 1e-3)]], ["Below the table, 100\\\\,\\\\%."])')
        self.paper.write("paper/line.tex", "not this")
        self.paper.write("paper/generated/tables/lengths.tex", "not this")
        words = self.typeset("\\tab{lengths} \\fig{line}")
        self.assertIn("Below the table, 100 %.", words)
        self.assertNotIn("not this", words)

    def test_the_basic_packages_of_tex_live_suffice(self):
        self.typeset("\\val{x}\\claim{short}\\claimledger\\tab{lengths}\\fig{line}", "\\usepackage{hyperref}")
        fls = (self.paper.output / "latex" / "small.fls").read_text()
        files = {line[6:] for line in fls.splitlines() if line.startswith("INPUT /usr/share/tex") and line.endswith((".sty", ".def", ".cfg"))}
        owners = subprocess.run(["dpkg", "-S", *files], capture_output=True, text=True).stdout
        packages = {line.partition(":")[0] for line in owners.splitlines()}
        self.assertLessEqual(packages, {"texlive-latex-base", "texlive-latex-recommended", "texlive-base", "lmodern"})


if __name__ == "__main__":
    unittest.main()
