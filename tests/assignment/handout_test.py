# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of the assignment are consistent; these tests need no compiler."""
import unittest

import real_assignment
from real_assignment import ASSIGNMENT, FOLDER, PROJECT, ROOT, WRONG

HANDOUT = {name: file.handout for name, file in PROJECT.items()}


class Handout(unittest.TestCase):
    def test_every_list_contains_each_exercise(self):
        for exercise in ASSIGNMENT.exercise:
            self.assertIn("YOUR SOLUTION HERE", HANDOUT[exercise.file])
            for name, line in (("CMakeLists.txt", f"  {exercise.file}\n"), ("README.md", f"| `{exercise.file}` | "), ("provided/main.cpp", f"  if (task == {exercise.id}::task) return {exercise.id}::answer(inputs);\n"),
                               ("provided/checks.cpp", f'{{"{exercise.id}", {exercise.id}::public_checks(), {{}}}},')):
                self.assertIn(line, HANDOUT[name])

    def test_it_does_not_name_hidden_checks_or_wrong_solutions(self):
        hidden = [check.id for check in ASSIGNMENT.checks if not check.is_public]
        for name, text in HANDOUT.items():
            for secret in [*hidden, *(wrong.description for wrong in WRONG), *(wrong.id for wrong in WRONG if "-" in wrong.id)]:
                self.assertNotIn(secret, text, name)

    def test_the_workflow_is_an_ordinary_one(self):
        workflow = HANDOUT[".github/workflows/checks.yml"]
        self.assertRegex(workflow, r"cmake -B build\n.*cmake --build build.*\n.*ctest --test-dir build")


class Points(unittest.TestCase):
    def test_public_checks_have_at_most_forty_points(self):
        self.assertLessEqual(sum(check.points for check in ASSIGNMENT.checks if check.is_public), 40)

    def test_every_exercise_has_two_wrong_solutions_and_each_costs_points(self):
        for exercise in ASSIGNMENT.exercise:
            self.assertGreaterEqual(sum(change["file"] == exercise.file for wrong in WRONG for change in wrong.change), 2)
        self.assertGreaterEqual(len(WRONG), 25)
        for wrong in WRONG:
            self.assertLess(wrong.points, ASSIGNMENT.points, wrong.id)

    def test_solutions_without_theory_score_nothing(self):
        for wrong in WRONG:
            if wrong.id in ("constants", "no-formula"):
                self.assertEqual(wrong.points, 0)
                self.assertGreaterEqual(len(wrong.change), 4)


class Guide(unittest.TestCase):
    def test_it_is_short_and_begins_with_the_warning_about_public_copies(self):
        lines = (FOLDER / "INSTRUCTORS.md").read_text(encoding="utf-8").splitlines()
        self.assertLessEqual(len(lines), 150)
        self.assertIn("contains the solution and the hidden checks, so a public copy", lines[2])

    def test_every_file_that_it_names_exists(self):
        text = (FOLDER / "INSTRUCTORS.md").read_text(encoding="utf-8")
        for name in ("report/assignment/template", "report/assignment/assignment.toml", "report/assignment/sheet.tex",
                     "report/assignment/wrong_solutions.toml", "src/assignment", "src/course/course.py", "src/assignment/exercises",
                     "src/assignment/hidden/reference.cpp", "tests/assignment/programs.hpp"):
            self.assertIn(name, text)
            self.assertTrue((ROOT / name).exists(), name)


if __name__ == "__main__":
    real_assignment.main()
