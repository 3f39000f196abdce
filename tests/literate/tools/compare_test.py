# SPDX-License-Identifier: GPL-3.0-or-later
"""changes, verify and dist: comparisons with an earlier state, a different machine and an empty folder."""

import csv
import json
import shutil
import subprocess
import tarfile
import unittest

from paper import PaperTest

from literate_tools.changes import compare
from literate_tools.marked import expand
from literate_tools.settings import PARTS


def results(**parts) -> dict:
    """Returns results that consist of these parts."""
    return {"schema": 1, "failed": []} | {part: {} for part in PARTS} | parts


def number(value: float, bound: float = 0, **more) -> dict:
    """Returns a value."""
    return {"number": value, "bound": bound, "printed": f"{value:g}", "place": "a.py:1"} | more


class Compare(unittest.TestCase):
    def test_numbers_move_beyond_or_within_the_sum_of_both_errors(self):
        cases = [
            (number(1, 0.1), number(1.15, 0.1), "within"), (number(1, 0.1), number(1.25, 0.1), "beyond"),
            (number(1, 0.1), number(1, 0.1), None), (number(1, 0.1), number(1, 0.2), None),
            (number(1, standard=0.1), number(1.19), "within"), (number(1, standard=0.1), number(1.21), "beyond"),
            (number(1), number(1.001), "beyond"), (number(1, 0.1, unit="m"), number(1, 0.1, unit="mm"), "changed"),
            (number(1, 0.1, printed="1.0"), number(1, 0.1, printed="1.00"), "within"),
            ({"text": "a", "printed": "a"}, {"text": "b", "printed": "b"}, "changed"),
        ]
        for before, after, change in cases:
            with self.subTest(before=before, after=after):
                found = compare(results(values={"x": before}), results(values={"x": after}))
                self.assertEqual([one.change for one in found], [change] if change else [])

    def test_new_and_gone_names_verdicts_limits_and_cells_are_listed(self):
        def claim(verdict: str, limit: str) -> dict:
            return {"verdict": verdict, "criteria": [{"name": "c", "limit": limit}]}

        def table(*cells) -> dict:
            return {"columns": [{"heading": "h"}], "rows": [[cell] for cell in cells], "notes": []}
        old = results(values={"gone": number(1)}, flags={"f": {"value": True}}, claims={"c": claim("holds", "≤ 1"), "d": claim("holds", "≤ 1")},
                      checks={"k": {"passed": True, "criteria": []}}, tables={"t": table(number(1), None), "s": table(None)})
        new = results(values={"new": number(2)}, flags={"f": {"value": False}}, claims={"c": claim("fails", "≤ 1"), "d": claim("holds", "≤ 2")},
                      checks={"k": {"passed": False, "criteria": []}}, tables={"t": table(number(3), {"text": "x"}), "s": table(None, None)})
        self.assertEqual({(one.change, one.name, one.before, one.after) for one in compare(old, new)}, {
            ("new", "new", "", "2"), ("gone", "gone", "1", ""), ("verdict", "f", "True", "False"), ("verdict", "c", "holds", "fails"),
            ("limit", "d: c", "≤ 1", "≤ 2"), ("verdict", "k", "True", "False"), ("beyond", "t: row 1, h", "1", "3"),
            ("changed", "t: row 2, h", "", "x"), ("changed", "s", "1 rows of h", "2 rows of h")})

    def test_values_and_flags_are_replaced_by_their_printed_text(self):
        text = r"It \ifflag{a}{is \val{x} \ifflag{b}{and}{or \val{x}}}{is \{not\}} \val[2]{x} % \val{x}"
        self.assertEqual(expand(text, {"x": r"1\,m", "x[2]": "1.0"}, {"a": True, "b": False}).rstrip(),
                         r"It is \LiteratePrinted{1\,m} or \LiteratePrinted{1\,m} \LiteratePrinted{1.0}")
        self.assertEqual(expand(text, {}, {"a": False}).rstrip(), r"It is \{not\} \val[2]{x}")


class Changes(PaperTest):
    def test_changes_since_a_commit_or_a_file_name_the_lines_that_print_them(self):
        self.paper.commit()
        self.make()
        shutil.copy(self.paper.output / "small.manifest.json", self.paper.folder / "old.json")
        self.paper.replace("case.toml", "x = 1.5", "x = 0.5")
        self.paper.replace("case.toml", "slope = 2.0", "slope = 3.0")
        self.paper.replace("paper/small.tex", "It is", "Now it is")
        self.make()
        values = ["verdict  flag   big: True → False   paper/small.tex:8",
                  "beyond   value  x: 1.50 m → 0.500 m   paper/small.tex:8, paper/small.tex:10",
                  "beyond   table  lengths: row 1, length: 1.50 → 0.50   paper/small.tex:10"]
        data = ["changed  figure line: its data changed   paper/small.tex:11"]
        code, output = self.paper.literate("changes", str(self.paper.settings), "old.json")
        self.assertEqual((code, output.splitlines()), (0, values))
        for _ in range(2):  # the second time the commit is not computed again
            code, output = self.paper.literate("changes", str(self.paper.settings), "HEAD")
            self.assertEqual((code, output.splitlines()), (0, values + data))
        with open(self.paper.output / "changes.csv") as file:
            self.assertEqual(list(csv.reader(file))[2], ["beyond", "values", "x", "1.50 m", "0.500 m", "paper/small.tex:8 paper/small.tex:10"])
        code, output = self.paper.literate("changes", str(self.paper.settings), "none")
        self.assertEqual(code, 2)
        self.assertIn("none: neither a file nor a commit", output)

    @unittest.skipUnless(shutil.which("latexdiff"), "latexdiff is not installed")
    def test_the_marked_pdf_shows_changed_words_and_values(self):
        self.paper.commit()
        self.paper.replace("case.toml", "x = 1.5", "x = 0.5")
        self.paper.replace("paper/sections/more.tex", "More", "Much")
        self.make()
        code, output = self.paper.literate("changes", str(self.paper.settings), "HEAD", "--pdf")
        self.assertEqual(code, 0, output)
        words = subprocess.run(["pdftotext", self.paper.output / "small.changes.pdf", "-"], capture_output=True, text=True).stdout
        words = " ".join(words.split())
        self.assertIn("It is 1.50 m, or 1.5 m, big 0.500 m, or 0.50 m, small .", words)
        self.assertIn("More Much is", words)


class Verify(PaperTest):
    def test_a_clone_elsewhere_gives_the_same_bytes(self):
        self.paper.commit()
        self.make()
        self.assertEqual(self.paper.literate("verify", str(self.paper.settings)), (0, "small: the same bytes\n"))

    def test_output_that_depends_on_the_folder_is_found(self):
        self.paper.replace("compute.py", 'document.value("title", "A & B")', 'document.value("title", __file__)')
        self.paper.commit()
        self.make()
        code, output = self.paper.literate("verify", str(self.paper.settings))
        self.assertEqual(code, 1, output)
        self.assertIn("small.pdf: different bytes", output)
        self.assertIn("changed values title:", output)

    def test_a_state_that_is_not_committed_is_refused(self):
        self.make()
        code, output = self.paper.literate("verify", str(self.paper.settings))
        self.assertEqual(code, 2)
        self.assertIn("needs a git repository with a commit", output)
        self.paper.commit()
        self.paper.replace("case.toml", "1.5", "1.6")
        code, output = self.paper.literate("verify", str(self.paper.settings))
        self.assertIn("case.toml", output)

    def test_a_manifest_is_compared_by_results_or_by_hashes(self):
        self.make()
        manifest = self.paper.folder / "theirs.json"
        data = json.loads((self.paper.output / "small.manifest.json").read_text())
        self.assertEqual(set(data["sources"]), {"case.toml", "compute.py", "paper/small.tex", "paper/sections/more.tex", "figures/line.gp"})
        self.assertLessEqual({"pdfTeX", "LaTeX", "gnuplot", "CMake"}, set(data["tools"]))
        data["results"]["values"]["x"]["number"] += 1e-4
        manifest.write_text(json.dumps(data))
        verify = ["verify", str(self.paper.settings)]
        self.assertEqual(self.paper.literate(*verify, "--manifest", "theirs.json"),
                         (0, "small: the same results; different within their errors: 1\n"))
        data["results"]["values"]["x"]["number"] += 1e-3
        manifest.write_text(json.dumps(data))
        self.assertEqual(self.paper.literate(*verify, "--manifest", "theirs.json"), (1, "beyond values x: 1.50 m there, 1.50 m here\n"))
        self.assertEqual(self.paper.literate(*verify, "--files", "theirs.json"), (0, "small: all files have the hashes of the manifest\n"))
        self.paper.replace("paper/small.tex", "It is", "It was")
        (self.paper.output / "generated" / "values.csv").unlink()
        self.assertEqual(self.paper.literate(*verify, "--files", "theirs.json"),
                         (1, "paper/small.tex: different\nbuild/small/generated/values.csv: missing\n"))


class Dist(PaperTest):
    def test_the_archive_needs_no_engine_and_is_the_same_each_time(self):
        self.paper.write("paper/small.bib", "@book{b, author={A. Uthor}, title={Title}, year=2001, publisher={P}}\n")
        self.paper.replace("paper/small.tex", r"\claimledger", "\\claimledger\\attachdata\\cite{b}\n\\bibliographystyle{plain}\\bibliography{small}")
        self.make()
        code, output = self.paper.literate("dist", str(self.paper.settings))
        self.assertEqual((code, output), (0, f"{self.paper.output}/small.tar.gz\n"))
        archive = self.paper.output / "small.tar.gz"
        with tarfile.open(archive) as tar:
            self.assertLessEqual({"small.tex", "small.bbl", "literate.sty", "sections/more.tex", "generated/values.tex", "generated/tables/lengths.tex",
                                  "generated/figures/line/line.pdf", "generated/values.csv"}, set(tar.getnames()))
        data = archive.read_bytes()
        self.paper.literate("dist", str(self.paper.settings))
        self.assertEqual(archive.read_bytes(), data)


if __name__ == "__main__":
    unittest.main()
