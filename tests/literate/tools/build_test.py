# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules that a build runs after an edit, and its messages."""

import unittest

from paper import PaperTest, rules_in


class Rules(PaperTest):
    def test_each_edit_runs_only_the_rules_that_depend_on_it(self):
        everything = ["compute small", "draw line", "typeset small"]
        self.assertEqual(sorted(rules_in(self.make())), everything)
        paper = self.paper
        edits = {
            "nothing": (lambda: None, []),
            "a word": (lambda: paper.replace("paper/sections/more.tex", "More", "Much"), ["typeset small"]),
            "a script of a figure": (lambda: paper.replace("figures/line.gp", "lines", "points"), ["draw line", "typeset small"]),
            "a style, which is new": (lambda: paper.write("figures/style.gp", "set grid\n"), ["draw line", "typeset small"]),
            "a number of the case": (lambda: paper.replace("case.toml", "1.5", "1.6"), ["compute small", "typeset small"]),
            "the data of the figure": (lambda: paper.replace("case.toml", "slope = 2.0", "slope = 3.0"), everything),
            "code without effect": (lambda: paper.replace("compute.py", "import literate", "import literate # here"), ["compute small"]),
            "a figure, which is new": (lambda: (
                paper.replace("compute.py", 'document.claim(', 'document.figure("new", 6, 4, {"b": {"x": [1, 2]}}); document.claim('),
                paper.write("figures/new.gp", 'plot b using "x" notitle\n')), ["compute small", "draw new", "typeset small"]),
        }
        for edit, (act, rules) in edits.items():
            with self.subTest(edit):
                act()
                self.assertEqual(sorted(rules_in(self.make())), rules)
        self.assertEqual(paper.pdf.read_bytes(), paper.clean_pdf())

    def test_only_errors_of_cmake_are_printed_after_a_new_script(self):
        self.make()
        self.paper.write("figures/new.gp", "plot 1\n")
        code, output = self.paper.literate("build", "small")
        self.assertEqual((code, [line for line in output.splitlines() if not line.startswith("[")]), (0, []))
        self.paper.replace("CMakeLists.txt", "NAME small", "NAME small WHAT")
        code, output = self.paper.literate("build", "small")
        self.assertEqual(code, 1)
        self.assertIn("literate_add_paper: unknown arguments: WHAT", " ".join(output.split()))

    def test_a_commit_typesets_the_paper_again(self):
        self.make()
        self.paper.commit()
        self.assertEqual(rules_in(self.make()), ["typeset small"])
        self.assertEqual(rules_in(self.make()), [])
        self.assertEqual(self.paper.pdf.read_bytes(), self.paper.clean_pdf())

    def test_two_clones_give_the_same_bytes(self):
        self.paper.commit()
        self.make()
        self.assertEqual(self.paper.pdf.read_bytes(), self.paper.clean_pdf())

    def test_a_source_saved_while_latex_runs_is_typeset_again(self):
        self.paper.replace("paper/small.tex", r"\claimledger", r"\claimledger\immediate\write18{true}\input{late}")
        self.paper.write("paper/late.tex", r"\message{reading late}")
        tools = self.paper.folder.parent / "bin"
        tools.mkdir()
        (tools / "pdflatex").write_text(
            f"#!/bin/sh\nPATH=/usr/bin:/bin\npdflatex \"$@\" || exit\nsleep 0.01; echo later >>'{self.paper.folder}/paper/late.tex'\n")
        (tools / "pdflatex").chmod(0o755)
        path = self.paper.environment["PATH"]
        self.paper.environment["PATH"] = f"{tools}:{path}"
        self.make()
        self.paper.environment["PATH"] = path
        self.assertEqual(rules_in(self.make()), ["typeset small"])
        self.assertIn("later", self.paper.text())


class Failures(PaperTest):
    def test_a_failed_claim_publishes_a_stamped_pdf_and_fails_each_build_until_it_holds(self):
        self.paper.replace("case.toml", "limit = 10.0", "limit = 1.0")
        output = self.make(1)
        self.assertIn("claim 'short': fails, expected holds", output)
        self.assertIn("Not to be trusted: 1 check or claim failed", self.paper.text())
        again = self.make(1)
        self.assertIn("claim 'short': fails, expected holds", again)
        self.assertEqual(rules_in(again), [])
        self.paper.replace("case.toml", "limit = 1.0", "limit = 10.0")
        self.make()
        self.assertNotIn("Not to be trusted", self.paper.text())

    def test_errors_name_the_line_to_fix(self):
        cases = [
            ("an unknown value, and the nearest name", "paper/sections/more.tex", r"\val{share}", "\n\n\\val{shaer}",
             "paper/sections/more.tex:3: unknown value 'shaer', did you mean 'share'?"),
            ("an unknown table", "paper/small.tex", r"\tab{lengths}", r"\tab{length}",
             "paper/small.tex:10: unknown table 'length', did you mean 'lengths'?"),
            ("an unknown claim", "paper/small.tex", r"\claim{short}", r"\claim{shirt}",
             "paper/small.tex:8: unknown claim 'shirt', did you mean 'short'?"),
            ("an unknown flag", "paper/small.tex", r"\ifflag{big}", r"\ifflag{bug}", "paper/small.tex:8: unknown flag 'bug', did you mean 'big'?"),
            ("more digits than are earned", "paper/small.tex", r"\val[2]{x}", r"\val[9]{x}",
             r"paper/small.tex:8: \val[9]{x}: only 5 digits are earned"),
            ("an unknown command", "paper/small.tex", "It is", "It \\iss", "paper/small.tex:8: undefined command \\iss"),
            ("a missing file", "paper/small.tex", r"\input{sections/more}", r"\input{sections/moer}",
             "paper/small.tex:9: LaTeX Error: File `sections/moer.tex' not found"),
            ("a missing package", "paper/small.tex", r"\usepackage{lmodern}", r"\usepackage{lmodernn}",
             "paper/small.tex:4: LaTeX Error: File `lmodernn.sty' not found"),
            ("literate.sty is not loaded", "paper/small.tex", "\\usepackage{literate}\n", "",
             r"paper/small.tex:6: \usepackage{literate} is missing"),
            ("prose that is not UTF-8", "paper/small.tex", "It is", "It \udcffis", "paper/small.tex:8: LaTeX Error: Invalid UTF-8 byte"),
            ("an author's LaTeX in a table", "compute.py", 'literate.column("name")', 'literate.column("\\\\naem")',
             "compute.py:9: table 'lengths': undefined command \\naem"),
            ("gnuplot", "figures/line.gp", "plot points", "set xtics\nplot piont", 'figures/line.gp:2: undefined variable: piont'),
            ("a column that the data do not have", "figures/line.gp", '"b"', '"c"', "figures/line.gp:1: all points y value undefined"),
            ("a script that draws nothing", "figures/line.gp", "plot", "#", "figures/line.gp: gnuplot wrote no line.tex and line.pdf"),
            ("a Python script", "compute.py", "import literate", "import literat", "compute.py ended with exit code 1"),
            ("a value without its error", "compute.py", "error=1e-6, ", "", "compute.py:6"),
            ("a case that is not TOML", "case.toml", "x = 1.5", "x = = 1.5", "line 1"),
        ]
        for what, file, before, after, message in cases:
            with self.subTest(what):
                right = (self.paper.folder / file).read_text()
                self.paper.write(file, right)
                path = self.paper.folder / file
                path.write_bytes(right.replace(before, after).encode(errors="surrogateescape"))
                output = self.make(1)
                self.assertIn(message, output)
                path.write_text(right)
        self.make()
        self.assertEqual(self.paper.pdf.read_bytes(), self.paper.clean_pdf())

    def test_a_figure_needs_a_script_but_a_script_needs_no_figure(self):
        self.paper.write("figures/liin.gp", "plot points\n")
        self.make()
        self.assertEqual(rules_in(self.make()), [])
        self.assertIn("figures/liin.gp: unknown figure 'liin', did you mean 'line'?", self.paper.literate("check", str(self.paper.settings))[1])
        (self.paper.folder / "figures/line.gp").unlink()
        self.assertIn("paper/small.tex:11: figure 'line' is not drawn", self.make(1))

    def test_visible_defects_are_warnings(self):
        self.paper.replace("paper/sections/more.tex", "More", r"\ref{tab:none} \cite{nobody} \hbox to 1cm{\rule{3cm}{1ex}}" + "\n\nMore")
        output = self.make()
        self.assertIn("paper/sections/more.tex:1: undefined reference 'tab:none'", output)
        self.assertIn("paper/sections/more.tex:1: undefined citation 'nobody'", output)
        self.assertRegex(output, r"paper/sections/more.tex:1: a line is [\d.]+pt too wide")
        self.paper.replace("compute.py", '"a room"', r'r"\mbox{a room in which all who live in the house can sit down at one table}"')
        self.assertRegex(self.make(), r"compute.py:12: 'short': a line is [\d.]+pt too wide")

    def test_long_numbers_fit_into_the_ledger(self):
        self.paper.replace("compute.py", "x = literate.number(case[\"x\"], error=case[\"error\"], unit=\"m\", digits=3)",
                           "x = literate.number(1234.5678, standard=0.0012, unit='W/(m2.K)', format='uncertain()')")
        self.paper.replace("compute.py", 'literate.limit(case["limit"], "choice", "a room")', 'literate.limit(1234.6, "choice", "a room", counting=2)')
        self.assertNotIn("too wide", self.make())

    def test_invalid_settings_and_results_are_refused_in_one_line(self):
        self.make()
        results = self.paper.output / "generated" / "results.json"
        right = results.read_text()
        for what, text, message in [("half", right[:100], "not JSON, or incomplete"), ("foreign", '{"a": 1}', "not the results of a paper"),
                                    ("a list", "[]", "not the results of a paper"),
                                    ("of another version", right.replace('"schema": 1', '"schema": 2'), "schema 2, but this engine reads schema 1"),
                                    ("incomplete", '{"schema": 1, "values": {}}', "these results are incomplete")]:
            with self.subTest(what):
                results.write_text(text)
                code, output = self.paper.literate("changes", str(self.paper.settings), str(results))
                self.assertEqual((code, output.count("\n")), (2, 1), output)
                self.assertIn(message, output)
        for arguments, message in [(["check", "none.json"], "there is no such file"), (["chek"], "did you mean 'check'"),
                                   (["check", str(self.paper.folder / "case.toml")], "not the settings of a paper")]:
            code, output = self.paper.literate(*arguments)
            self.assertEqual(code, 2)
            self.assertIn(message, output)


if __name__ == "__main__":
    unittest.main()
