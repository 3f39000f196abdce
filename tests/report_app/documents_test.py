# SPDX-License-Identifier: GPL-3.0-or-later
"""The documents of several cases are typeset, and every sentence in them applies to the case."""

import os
import re
import subprocess
import sys
import unittest

from cases import OWN_CONTACT, PAPER, SOURCE, STEEL, InFolder, changed

OF_THE_PRINT = ["The run", "Three findings", "Contact.m", "Tri_dist.m", "The copy of the paper", "inferred load"]


class Documents(InFolder):
    def text(self, case):
        """Typesets a case and returns the words of the PDF, separated by single spaces."""
        made = subprocess.run([sys.executable, str(SOURCE / "src/literate/tools/literate"), "case", os.environ["SETTINGS"],
                               str(self.case(case)), str(self.folder / "out")], capture_output=True, text=True)
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
    unittest.main()
