# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what a teacher writes: assignment.toml, and the markers that divide a template into the handout and the solution."""
import dataclasses
import json
import tempfile
import unittest
from pathlib import Path

import toy_course
from toy_course import ROOT, TOY

import assignment
import template
from errors import BadInput

TEXT = (TOY / "assignment.toml").read_text(encoding="utf-8")


def error_of(text):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "assignment.toml")
        file.write_text(text, encoding="utf-8")
        try:
            assignment.read(file)
        except BadInput as error:
            return str(error).replace(f"{folder}/", "")
    return ""


class Errors(unittest.TestCase):
    def test_each_mistake_is_named_with_its_place(self):
        for before, after, error in (
                ('title = "Toy"\n', "", "assignment.toml: Assignment.__init__() missing 1 required positional argument: 'title'"),
                ('title = "Toy"', 'title = "Toy"\ngrace = 5', "assignment.toml: Assignment.__init__() got an unexpected keyword argument 'grace'"),
                ("processes = 16\n", "", "assignment.toml: limits: Limits.__init__() missing 1 required positional argument: 'processes'"),
                ('{id = "sum-right", points = 6', '{id = "sum-right", point = 6', "assignment.toml: check 'sum-right': Check.__init__() got an unexpected keyword argument 'point'"),
                ("points = 30", "points = 31", "assignment.toml: the points of all checks add up to 30, not 31"),
                ('builds_on = ["square"]', 'builds_on = ["sphere"]',
                 "assignment.toml: exercise 'cube' builds on 'sphere', which is not an earlier exercise"),
                ("points = 30", "points = ", "assignment.toml: Invalid value (at line 3, column 10)")):
            with self.subTest(after):
                self.assertEqual(error_of(TEXT.replace(before, after)), error)


class Contents(unittest.TestCase):
    def test_points_files_and_dependencies_are_read(self):
        toy = assignment.read(TOY / "assignment.toml")
        self.assertEqual([(exercise.file, exercise.points) for exercise in toy.exercise],
                         [("src/square.cpp", 10), ("src/sum.cpp", 10), ("src/cube.cpp", 10)])
        self.assertEqual(toy.exercises_behind(toy.exercise[2]), {"square"})

    def test_an_assignment_survives_the_way_through_json(self):
        toy = assignment.read(TOY / "assignment.toml")
        self.assertEqual(assignment.from_table(json.loads(json.dumps(dataclasses.asdict(toy))), ""), toy)


LISTS = {"EXERCISE": [{"id": "one", "number": 1}, {"id": "two", "number": 2}], "PUBLIC CHECK": []}


def divided(text, name="file.cpp"):
    return template.divide(text, name, LISTS)


class Markers(unittest.TestCase):
    def test_stubs_replace_the_solution(self):
        found = divided("int f() {\n  // BEGIN SOLUTION\n  // STUB: return 0;\n  return 42;\n\n  // END SOLUTION\n}\n")
        self.assertEqual(found.handout, "int f() {\n  // YOUR SOLUTION HERE\n  return 0;\n}\n")
        self.assertEqual(found.solution, "int f() {\n  return 42;\n\n}\n")
        self.assertEqual(found.secrets, [(4, "return 42;")])

    def test_every_comment_style_can_be_a_marker(self):
        for begin, end in (("//", ""), ("#", ""), ("%", ""), ("<!--", " -->")):
            with self.subTest(begin):
                found = divided(f"a\n{begin} BEGIN SOLUTION{end}\nb\n{begin} END SOLUTION{end}\n")
                self.assertEqual(found.handout, f"a\n{begin} YOUR SOLUTION HERE{end}\n")
                self.assertEqual(found.solution, "a\nb\n")

    def test_a_list_has_one_line_per_exercise(self):
        found = divided("x\n  // EACH EXERCISE: call(@id@, @number@);\n// EACH PUBLIC CHECK: none\n")
        self.assertEqual(found.handout, "x\n  call(one, 1);\n  call(two, 2);\n")
        self.assertEqual(found.solution, found.handout)

    def test_a_misplaced_marker_is_an_error_with_its_line(self):
        for text, error in (("// BEGIN SOLUTION\n", "f:1: BEGIN SOLUTION without END SOLUTION"),
                            ("\n// END SOLUTION\n", "f:2: the marker END SOLUTION is not expected here"),
                            ("// BEGIN SOLUTION\n// BEGIN SOLUTION\n", "f:2: the marker BEGIN SOLUTION is not expected here"),
                            ("// STUB: return 0;\n", "f:1: the marker STUB: is not expected here"),
                            ("// Begin-Solution\n", "f:1: this looks like a marker but is not one: // Begin-Solution"),
                            ("return 1; // END SOLUTION\n", "f:1: this looks like a marker but is not one: return 1; // END SOLUTION")):
            with self.subTest(text):
                with self.assertRaises(BadInput) as caught:
                    divided(text, "f")
                self.assertEqual(str(caught.exception), error)


class Project(unittest.TestCase):
    def test_it_contains_the_template_and_copies_of_the_provided_files(self):
        toy = assignment.read(TOY / "assignment.toml")
        files = template.project(toy, TOY, ROOT / "src")
        self.assertEqual(files["src/square.cpp"].handout.splitlines()[2:4], ["  // YOUR SOLUTION HERE", "  return 0;"])
        self.assertEqual(files["provided/judge/judge.cpp"].handout, (ROOT / "src/judge/judge.cpp").read_text(encoding="utf-8"))
        self.assertIn("1. The square, 10 points: `src/square.cpp`\n2. The sum", files["README.md"].handout)
        self.assertIn("    square-even\n    sum-commutes\n", files["CMakeLists.txt"].handout)


if __name__ == "__main__":
    toy_course.main()
