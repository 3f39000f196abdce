# SPDX-License-Identifier: GPL-3.0-or-later
"""A mistake in assignment.toml is an error of one line."""
import dataclasses
import json
import tempfile
import unittest
from pathlib import Path

import toy_course
from toy_course import TOY

import assignment
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


if __name__ == "__main__":
    toy_course.main()
