# SPDX-License-Identifier: GPL-3.0-or-later
"""The program of the report, halfspace-report compute CASE FOLDER, and the documents of several cases. report_test.py SOURCE
PROGRAM SETTINGS"""

import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE, PROGRAM, SETTINGS = map(Path, sys.argv[1:])
PAPER = (SOURCE / "report/ruggiero2001.toml").read_text()
STEEL = (SOURCE / "tests/end_to_end/steel_mm.toml").read_text()


def changed(text: str, *changes: tuple[str, str]) -> str:
    """Returns the text with the first occurrence of each `before` replaced by `after`."""
    for before, after in changes:
        assert before in text, before
        text = text.replace(before, after, 1)
    return text


OWN_CONTACT = changed(PAPER, ("radius = {value = 1,", "radius = {value = 2,"), ("radius = {value = 3,", "radius = {value = 5,"),
                      ("load = {value = 2500,", "load = {value = 1200,"))


class InFolder(unittest.TestCase):
    """A test in a separate folder, whose name contains a space."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="report test ")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def case(self, text: str) -> Path:
        """Writes a case and returns its file."""
        file = self.folder / "mine.toml"
        file.write_text(text)
        return file


class Program(InFolder):
    """Exit codes, messages, and files that depend only on the case."""

    def compute(self, text, folder="out", **surroundings):
        """Runs the program; returns exit code, lines of standard error and the folder."""
        ran = subprocess.run([PROGRAM, "compute", str(self.case(text)), str(self.folder / folder)],
                             capture_output=True, text=True, cwd=surroundings.pop("cwd", SOURCE), env=os.environ | surroundings)
        self.assertEqual(ran.stdout, "")
        return ran.returncode, ran.stderr.splitlines(), self.folder / folder

    def results(self, folder):
        return json.loads((folder / "results.json").read_text())

    def test_the_papers_case_holds_without_messages(self):
        code, errors, folder = self.compute(PAPER)
        self.assertEqual((code, errors), (0, []))
        self.assertEqual(self.results(folder)["failed"], [])

    def test_the_files_depend_only_on_the_case(self):
        digests = []
        for name, surroundings in {"one": {}, "two": {"LC_ALL": "C.UTF-8", "TZ": "Asia/Tokyo", "cwd": "/"}}.items():
            folder = self.compute(STEEL, name, **surroundings)[2]
            digests.append({str(f.relative_to(folder)): hashlib.sha256(f.read_bytes()).hexdigest()
                            for f in folder.rglob("*") if f.is_file()})
        self.assertEqual(digests[0], digests[1])

    def test_a_changed_print_fails_its_claim_and_the_folder_is_complete(self):
        code, errors, folder = self.compute(changed(PAPER, ('max_stress_zz = "-5.914541e+02"', 'max_stress_zz = "-5.915541e+02"')))
        self.assertEqual(code, 1)
        self.assertEqual(len(errors), 1)
        self.assertRegex(errors[0], r"^src/paper/run\.cpp:\d+: .*plane-strain.*0\.300051")
        self.assertTrue(self.results(folder)["failed"])

    def test_a_users_case_omits_the_print_with_the_reason_in_one_line(self):
        code, errors, folder = self.compute(OWN_CONTACT)
        self.assertEqual(code, 0)
        self.assertEqual(len(errors), 1)
        self.assertTrue(errors[0].endswith("mine.toml: contact.load, 1200 lbf/in, is not the paper's 2500; "
                                           "the report omits the sections about the paper's numbers"), errors)
        results = self.results(folder)
        self.assertFalse(results["flags"]["printed"]["value"])
        self.assertEqual(set(results["claims"]), {"equation-3-follows", "hertz-verifies", "pressure-at-the-nodes",
                                                  "triangles-gain-between-nodes"})

    def test_bad_input_exits_with_2_and_one_line_with_its_position_and_writes_nothing(self):
        for text, end in ((changed(PAPER, ("poisson = 0.30", "poisson = 0.6")), "poisson"),
                          (changed(PAPER, ("nodes = 91", "nodes = 402")), "contact.nodes: 402: must be at most 401 for the report"),
                          (changed(STEEL, ("[contact.body2]", "[contact.body3]")), "contact.body2"),
                          (changed(PAPER, ('zero_node = "9"', "")), "printed.contact_m.zero_node: missing")):
            code, errors, folder = self.compute(text)
            self.assertEqual(code, 2, errors)
            self.assertEqual(len(errors), 1, errors)
            self.assertRegex(errors[0], r"mine\.toml:\d+")
            self.assertIn(end, errors[0])
            self.assertFalse((folder / "results.json").exists())


OF_THE_PRINT = ["The run", "Three findings", "Contact.m", "Tri_dist.m", "The copy of the paper", "inferred load"]


class Documents(InFolder):
    """They are typeset, and every sentence in them applies to the case."""

    def text(self, case):
        """Typesets a case and returns the words of the PDF, separated by single spaces."""
        made = subprocess.run([sys.executable, SOURCE / "src/literate/tools/literate", "case", SETTINGS, self.case(case),
                               self.folder / "out"], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertNotIn("too wide", made.stderr)
        words = subprocess.run(["pdftotext", str(self.folder / "out/report.pdf"), "-"], capture_output=True, text=True, check=True)
        text = re.sub(r"\s+", " ", words.stdout.replace("\u2212", "-"))
        self.assertNotIn("??", text)
        self.assertNotRegex(text, r"\b(nan|inf)\b")
        return text

    def check(self, case, said, not_said):
        text = self.text(case)
        for sentence in said:
            self.assertIn(sentence, text)
        for sentence in not_said:
            self.assertNotIn(sentence, text)

    def test_the_papers_case_has_every_section(self):
        self.check(PAPER, [*OF_THE_PRINT, "has four errors", "Two spheres with the radii"], ["left out"])

    def test_a_users_case_omits_the_printed_numbers(self):
        self.check(OWN_CONTACT, ["The block of this case is 2 in wide", "pressed together by P = 1200 lbf/in", "left out"],
                   OF_THE_PRINT)

    def test_a_plane_in_other_units_without_block_and_spheres(self):
        self.check(STEEL, ["R2 = \u221e", "780 N/mm"], [*OF_THE_PRINT, " psi", " lbf", "The finite block", "Two spheres"])

    def test_a_hollow(self):
        self.check(changed(STEEL, ('radius = "plane"', 'radius = {value = -61, unit = "mm"}')), ["R2 = -61 mm"], OF_THE_PRINT)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
