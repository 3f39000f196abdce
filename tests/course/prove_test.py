# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `prove` from end to end, with the toy assignment: each of its claims can fail. prove_test.py ROOT JUDGE"""
import os
import shutil
import unittest
import zipfile

import toy_course
from toy_course import ARGUMENTS, Work, bubblewrap_problem, skip, write

SANDBOX = [] if not bubblewrap_problem() else ["--sandbox", "user"]


class Prove(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = Work(ARGUMENTS[0])
        cls.addClassCleanup(cls.work.remove)
        (cls.work.private / "salt.txt").unlink()
        cls.first = cls.prove()

    @classmethod
    def prove(cls, *options):
        return cls.work.course("prove", *SANDBOX, *options)

    def setUp(self):
        toy = self.work.folder / "toy"
        shutil.rmtree(toy)
        shutil.copytree(toy_course.TOY, toy)

    def edit(self, name, before, after):
        file = self.work.folder / "toy" / name
        text = file.read_text(encoding="utf-8")
        self.assertIn(before, text)
        file.write_text(text.replace(before, after, 1), encoding="utf-8")

    def fails(self, claim, text):
        """Requires that this claim is the first one that does not hold, and that the handout stays as it was."""
        before = (self.work.folder / "build/handout.zip").read_bytes()
        status, said = self.prove()
        self.assertEqual(status, 1, said)
        self.assertRegex(said, text)
        self.assertEqual([line[0] for line in said.splitlines() if line[1:3] == ". "], [str(i) for i in range(1, claim)], said)
        self.assertEqual((self.work.folder / "build/handout.zip").read_bytes(), before)

    def without(self, tool):
        """Has a tool fail that must not be called."""
        write({f"bin/{tool}": "#!/bin/sh\nexit 9\n"}, self.work.folder)
        (self.work.folder / "bin" / tool).chmod(0o755)
        self.addCleanup(os.environ.__setitem__, "PATH", os.environ["PATH"])
        os.environ["PATH"] = f"{self.work.folder}/bin:{os.environ['PATH']}"

    def test_five_claims_are_proved_and_the_handout_is_written(self):
        status, said = self.first
        self.assertEqual(status, 0, said)
        self.assertIn("a new salt for the hidden checks; keep it, and keep it secret\n", said)
        self.assertIn("3. the solution scores all 30 points, with the nominal numbers and those of 20 ids\n", said)
        self.assertIn("4. each of 2 wrong solutions scores what is listed\n5. nothing secret is in any file\n", said)
        handout = self.work.folder / "build/handout"
        self.assertIn("YOUR SOLUTION HERE", (handout / "src/square.cpp").read_text())
        self.assertEqual((handout / "sheet.pdf").read_bytes()[:5], b"%PDF-")
        names = zipfile.ZipFile(self.work.folder / "build/handout.zip").namelist()
        self.assertEqual(len(names), len([path for path in handout.rglob("*") if path.is_file()]))
        self.assertTrue(all(name.startswith("handout/") for name in names))
        self.assertEqual((self.work.private / "salt.txt").stat().st_mode & 0o777, 0o600)

    def test_what_has_not_changed_is_not_proved_again(self):
        for tool in ("cmake", "latexmk", "gnuplot"):
            self.without(tool)
        self.assertEqual(self.prove()[0], 0)
        self.edit("wrong_solutions.toml", "return 2 * x;", "return 5 * x;")
        status, said = self.prove()
        self.assertEqual(status, 0, said)

    def test_1_a_warning_of_the_compiler(self):
        self.edit("template/src/sum.cpp", "STUB: return 0;", "STUB: int unused; return 0;")
        self.fails(1, "the handout builds with a warning:(.|\n)*unused variable")

    def test_1_a_check_that_ctest_does_not_name(self):
        self.edit("template/CMakeLists.txt", "    # EACH PUBLIC CHECK: @check@\n", "    sum-commutes\n")
        self.fails(1, "ctest of the handout does not name the public check 'square-even'")

    def test_2_a_stub_that_scores(self):
        self.edit("template/src/sum.cpp", "STUB: return 0;", "STUB: return a + b;")
        self.fails(2, "the untouched handout scores 10 points, not 0")

    def test_3_a_solution_that_does_not_score_all(self):
        self.edit("template/src/cube.cpp", "return x * square(x);", "return x * x;")
        self.fails(3, "with the numbers of '' the solution scores 20 points(.|\n)*cube-right: 0 of 6: the cube is wrong")

    def test_4_a_wrong_solution_with_different_points(self):
        self.edit("wrong_solutions.toml", "points = 10", "points = 12")
        self.fails(4, "'doubled' scores 10 points, and 12 are listed. If that is right, prove --update writes it")
        status, said = self.prove("--update")
        self.assertEqual(status, 0, said)
        self.assertEqual((self.work.folder / "toy/wrong_solutions.toml").read_text(), (toy_course.TOY / "wrong_solutions.toml").read_text())

    def test_5_a_secret_in_a_text(self):
        self.edit("template/README.md", "# Toy", "# Toy\nThe check square-right is hidden.")
        self.fails(5, 'README.md has "square-right" \\(the id of a hidden check\\)')

    def test_code_and_list_of_the_checks_must_agree(self):
        self.edit("assignment.toml", 'id = "sum-right"', 'id = "sum-wrong"')
        status, said = self.prove()
        self.assertEqual(status, 2, said)
        self.assertIn("the hidden check 'sum-right' of exercise 'sum' is not listed", said)

    def test_a_folder_that_holds_no_handout_is_not_overwritten(self):
        write({"thesis.tex": "mine"}, self.work.folder / "elsewhere")
        status, said = self.prove("--output", self.work.folder / "elsewhere")
        self.assertEqual(status, 2)
        self.assertIn("this folder does not hold a handout; nothing was written", said)
        self.assertEqual((self.work.folder / "elsewhere/thesis.tex").read_text(), "mine")


if __name__ == "__main__":
    if SANDBOX and os.geteuid() != 0:
        skip(f"nothing was proved: {bubblewrap_problem()}")
    for tool in ("cmake", "latexmk", "gnuplot", "pdftotext"):
        if not shutil.which(tool):
            skip(f"there is no {tool}")
    toy_course.main()
