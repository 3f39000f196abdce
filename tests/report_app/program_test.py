# SPDX-License-Identifier: GPL-3.0-or-later
"""halfspace-report compute CASE FOLDER: exit codes, messages, and files that depend only on the case."""

import hashlib
import json
import os
import subprocess
import unittest

from cases import OWN_CONTACT, PAPER, SOURCE, STEEL, InFolder, changed


class Program(InFolder):
    def compute(self, text, folder="out", **surroundings):
        """Runs the program; returns exit code, lines of standard error and the folder."""
        ran = subprocess.run([os.environ["PROGRAM"], "compute", str(self.case(text)), str(self.folder / folder)],
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


if __name__ == "__main__":
    unittest.main()
