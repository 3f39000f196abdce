# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by the tests of the real assignment."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "course"))
import toy_course  # adds src/course to the path
from toy_course import ROOT

import assignment
import template
from proof import read_wrong_solutions

FOLDER = ROOT / "report/assignment"
ASSIGNMENT = assignment.read(FOLDER / "assignment.toml")
PROJECT = template.project(ASSIGNMENT, FOLDER, ROOT / "src")
SOLUTION = {exercise.file: PROJECT[exercise.file].solution.encode() for exercise in ASSIGNMENT.exercise}
WRONG = [wrong for wrong, _ in read_wrong_solutions(FOLDER / "wrong_solutions.toml", SOLUTION)]
main = toy_course.main
