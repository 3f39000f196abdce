# SPDX-License-Identifier: GPL-3.0-or-later
"""The real handout is proved from scratch, and its project works at home. prove_test.py ROOT JUDGE"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import real_assignment
from real_assignment import ASSIGNMENT, PROJECT, ROOT, WRONG
from toy_course import ARGUMENTS, require_bubblewrap, skip, write


class Proof(unittest.TestCase):
    def test_all_claims_about_the_handout_hold(self):
        with tempfile.TemporaryDirectory(prefix="course test ") as folder:
            done = subprocess.run([sys.executable, "-B", ROOT / "src/course/course.py", "prove", "--judge", ARGUMENTS[0], "--build", folder,
                                   "--salt-file", f"{folder}/salt.txt"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"3. the solution scores all {ASSIGNMENT.points:g} points", done.stdout)
            self.assertIn(f"4. each of {len(WRONG)} wrong solutions scores its listed points", done.stdout)
            self.assertTrue(Path(folder, "handout/sheet.pdf").exists())


class AtHome(unittest.TestCase):
    """The students' project, with the solution."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="course test "))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        write({name: file.solution for name, file in PROJECT.items()}, cls.folder)
        cls.run_here("cmake", "-B", "build", "-DSTUDENT=ada@uni.edu")
        cls.build()

    @classmethod
    def run_here(cls, *words):
        done = subprocess.run(words, cwd=cls.folder, capture_output=True, text=True, check=False, env={**os.environ, "TMPDIR": str(cls.folder)})
        if done.returncode != 0:
            raise AssertionError(done.stdout + done.stderr)
        return done.stdout

    @classmethod
    def build(cls):
        return cls.run_here("cmake", "--build", "build", "--parallel")

    def edit(self, name, before, after):
        file = self.folder / name
        text = file.read_text(encoding="utf-8")
        self.assertIn(before, text)
        file.write_text(text.replace(before, after), encoding="utf-8")
        self.addCleanup(file.write_text, text, encoding="utf-8")
        self.build()

    def lengths(self):
        """Returns half-width and approach as printed in the report."""
        self.run_here("build/figures", "numbers", "ada@uni.edu")
        return re.findall(r"\{([\d.]+)\\,mm\}", (self.folder / "numbers/numbers.tex").read_text())

    def test_the_solution_passes_every_public_check(self):
        self.assertIn("100% tests passed, 0 tests failed out of 16", self.run_here("ctest", "--test-dir", "build"))

    def test_a_check_reports_a_mistake(self):
        self.edit("src/influence.cpp", "k = std::abs(k);", "")
        with self.assertRaisesRegex(AssertionError, r"influence-shape\t.*k and −k give the same"):
            self.run_here("ctest", "--test-dir", "build", "--output-on-failure", "-R", "influence")

    def test_a_finer_grid_confirms_the_printed_digits(self):
        coarse = self.lengths()
        self.edit("report/figures.cpp", "const exercise::Grid grid{static_cast<int>(std::lround(own.nodes)), own.spacing};",
                  "const exercise::Grid grid{8 * static_cast<int>(std::lround(own.nodes)) - 7, own.spacing / 8};")
        for one, other in zip(coarse, self.lengths(), strict=True):
            self.assertGreater(len(other), len(one))
            self.assertLessEqual(abs(float(one) - float(other)), 1.0001 * 10.0 ** -len(one.split(".")[1]))


if __name__ == "__main__":
    require_bubblewrap()
    for tool in ("cmake", "latexmk", "gnuplot"):
        if not shutil.which(tool):
            skip(f"{tool} is not installed")
    real_assignment.main()
