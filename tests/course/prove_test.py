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
        """Requires that this claim is the first that does not hold, and that the handout is unchanged."""
        before = (self.work.folder / "build/handout.zip").read_bytes()
        status, output = self.prove()
        self.assertEqual(status, 1, output)
        self.assertRegex(output, text)
        self.assertEqual([line[0] for line in output.splitlines() if line[1:3] == ". "], [str(i) for i in range(1, claim)], output)
        self.assertEqual((self.work.folder / "build/handout.zip").read_bytes(), before)

    def break_tool(self, tool):
        """Replaces a tool that must not be called by one that fails."""
        write({f"bin/{tool}": "#!/bin/sh\nexit 9\n"}, self.work.folder)
        (self.work.folder / "bin" / tool).chmod(0o755)
        self.addCleanup(os.environ.__setitem__, "PATH", os.environ["PATH"])
        os.environ["PATH"] = f"{self.work.folder}/bin:{os.environ['PATH']}"

    def test_five_claims_are_proved_and_the_handout_is_written(self):
        status, output = self.first
        self.assertEqual(status, 0, output)
        self.assertIn("a new salt for the hidden checks; keep this file, and keep it secret\n", output)
        self.assertIn("3. the solution scores all 30 points, with the nominal numbers and with those of 20 ids\n", output)
        self.assertIn("4. each of 2 wrong solutions scores its listed points\n5. no file contains a secret\n", output)
        handout = self.work.folder / "build/handout"
        self.assertIn("YOUR SOLUTION HERE", (handout / "src/square.cpp").read_text())
        self.assertEqual((handout / "sheet.pdf").read_bytes()[:5], b"%PDF-")
        packed = zipfile.ZipFile(self.work.folder / "build/handout.zip").infolist()
        self.assertEqual({entry.date_time for entry in packed}, {(1980, 1, 1, 0, 0, 0)})  # the zip does not depend on the day
        names = [entry.filename for entry in packed]
        self.assertEqual(len(names), len([path for path in handout.rglob("*") if path.is_file()]))
        self.assertTrue(all(name.startswith("handout/") for name in names))
        self.assertEqual((self.work.private / "salt.txt").stat().st_mode & 0o777, 0o600)

    def test_unchanged_claims_are_not_proved_again(self):
        for tool in ("cmake", "latexmk", "gnuplot"):
            self.break_tool(tool)
        self.assertEqual(self.prove()[0], 0)
        self.edit("wrong_solutions.toml", "return 2 * x;", "return 5 * x;")
        status, output = self.prove()
        self.assertEqual(status, 0, output)

    def test_1_fails_if_the_compiler_warns(self):
        self.edit("template/src/sum.cpp", "STUB: return 0;", "STUB: int unused; return 0;")
        self.fails(1, "the handout builds with warnings:(.|\n)*unused variable")

    def test_1_fails_if_ctest_does_not_list_a_check(self):
        self.edit("template/CMakeLists.txt", "    # EACH PUBLIC CHECK: @check@\n", "    sum-commutes\n")
        self.fails(1, "ctest of the handout does not list the public check 'square-even'")

    def test_2_fails_if_a_stub_scores(self):
        self.edit("template/src/sum.cpp", "STUB: return 0;", "STUB: return a + b;")
        self.fails(2, "the untouched handout scores 10 points, not 0")

    def test_3_fails_if_the_solution_does_not_score_all_points(self):
        self.edit("template/src/cube.cpp", "return x * square(x);", "return x * square(x) / x;")
        self.fails(3, "with the numbers of '' the solution scores 20 points(.|\n)*cube-right: 0 of 6: the cube is wrong")

    def test_4_fails_if_a_wrong_solution_does_not_score_its_listed_points(self):
        self.edit("wrong_solutions.toml", "points = 10", "points = 12")
        self.fails(4, "'doubled' scores 10 points instead of the listed 12. If these points are correct, \"prove --update\" writes them")
        status, output = self.prove("--update")
        self.assertEqual(status, 0, output)
        self.assertEqual((self.work.folder / "toy/wrong_solutions.toml").read_text(), (toy_course.TOY / "wrong_solutions.toml").read_text())

    def test_5_fails_if_a_file_contains_a_secret(self):
        self.edit("template/README.md", "# Toy", "# Toy\nThe check square-right is hidden.")
        self.fails(5, 'README.md contains "square-right" \\(the id of a hidden check\\)')

    def test_checks_in_the_code_must_be_listed(self):
        self.edit("assignment.toml", 'id = "sum-right"', 'id = "sum-wrong"')
        status, output = self.prove()
        self.assertEqual(status, 2, output)
        self.assertIn("the hidden check 'sum-right' of exercise 'sum' is not listed in assignment.toml", output)

    def test_a_folder_without_a_handout_is_not_overwritten(self):
        write({"handout/thesis.tex": "mine"}, self.work.folder / "elsewhere")
        status, output = self.prove("--build", self.work.folder / "elsewhere")
        self.assertEqual(status, 2)
        self.assertIn("this folder does not contain a handout; nothing was written", output)
        self.assertEqual((self.work.folder / "elsewhere/handout/thesis.tex").read_text(), "mine")


if __name__ == "__main__":
    if SANDBOX and os.geteuid() != 0:
        skip(f"nothing was proved: {bubblewrap_problem()}")
    for tool in ("cmake", "latexmk", "gnuplot"):
        if not shutil.which(tool):
            skip(f"{tool} is not installed")
    toy_course.main()
