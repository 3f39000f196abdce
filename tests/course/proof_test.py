# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a proof that need no compiler: wrong solutions and leaks."""
import tempfile
import unittest
from pathlib import Path

import toy_course
from toy_course import ROOT, TOY

import assignment
import proof
import template
from errors import BadInput

TOY_ASSIGNMENT = assignment.read(TOY / "assignment.toml")
PROJECT = template.project(TOY_ASSIGNMENT, TOY, ROOT / "src")
SOLUTION = {exercise.file: PROJECT[exercise.file].solution.encode() for exercise in TOY_ASSIGNMENT.exercise}
LIST = (TOY / "wrong_solutions.toml").read_text(encoding="utf-8")


class WrongSolutions(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "list").write_text(text, encoding="utf-8")
            return proof.read_wrong_solutions(Path(folder, "list"), SOLUTION)

    def test_each_wrong_solution_is_the_solution_with_its_changes(self):
        (doubled, files), _ = self.read(LIST)
        self.assertEqual((doubled.id, doubled.points), ("doubled", 10))
        self.assertIn(b"return 2 * x;", files["src/square.cpp"])
        self.assertEqual(files["src/sum.cpp"], SOLUTION["src/sum.cpp"])

    def test_the_text_to_replace_must_occur_once(self):
        for before, after, error in (("return x * x;", "return x * y;", "'doubled': 'before' occurs 0 times in src/square.cpp instead of once"),
                                     ('"return x * x;"', '"x"', "'before' occurs 3 times in src/square.cpp instead of once"),
                                     ("src/square.cpp", "src/sphere.cpp", "'before' occurs 0 times in src/sphere.cpp instead of once"),
                                     ("points = 10\n", "", "missing 1 required positional argument: 'points'")):
            with self.subTest(after), self.assertRaisesRegex(BadInput, error):
                self.read(LIST.replace(before, after, 1))

    def test_new_points_change_nothing_else_in_the_list(self):
        text = LIST + '\n[[wrong]]\nid = "odd"\ndescription = ""\npoints = 1\nafter = """\npoints = 2\n"""\n'
        points = {"doubled": 10, "no-cube": 20, "odd": 1}
        self.assertEqual(proof.with_points(text, points), text)
        self.assertEqual(proof.with_points(text, {**points, "no-cube": 7.25, "odd": 3}),
                         text.replace("points = 20", "points = 7.25").replace("points = 1\n", "points = 3\n"))


class Leaks(unittest.TestCase):
    def test_secrets_are_found_in_texts_and_file_names_despite_different_white_space(self):
        secrets = {"return answer * answer;": "src/x.cpp:3", "x-reference": "the id of a hidden check", "x_hidden.cpp": "a file of hidden checks"}
        for name, text in (("README.md", "so:  return answer *\n  answer;"), ("sheet.pdf", "the check x-reference"), ("src/x_hidden.cpp", "")):
            self.assertEqual(len(proof.leaks({name: text}, secrets)), 1, name)
        self.assertEqual(proof.leaks({"src/x.cpp": "return answer;"}, secrets), [])

    def test_lines_of_the_solution_and_lines_only_in_hidden_checks_are_secret(self):
        project = {"src/x.cpp": template.divide("// BEGIN SOLUTION\n  const double y = hidden(x);\n  short;\n// END SOLUTION\n", "x", {})}
        with tempfile.TemporaryDirectory() as folder:
            hidden, public = Path(folder, "x_hidden.cpp"), Path(folder, "x_checks.hpp")
            hidden.write_text("#include \"everything_there_is.hpp\"\n  return tally.outcome() + 0;\n  compare(with, the_reference);\n")
            public.write_text("return tally.outcome() + 0;\n")
            found = proof.secrets_of(TOY_ASSIGNMENT, project, [hidden], [public])
        self.assertEqual(found, {"const double y = hidden(x);": "src/x.cpp:2", "compare(with, the_reference);": "x_hidden.cpp:3",
                                 "x_hidden.cpp": "a file of hidden checks", "square-right": "the id of a hidden check",
                                 "sum-right": "the id of a hidden check", "cube-right": "the id of a hidden check"})


if __name__ == "__main__":
    toy_course.main()
