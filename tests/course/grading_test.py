# SPDX-License-Identifier: GPL-3.0-or-later
"""How points follow from the judge's outcomes, and what students and teachers can read."""
import json
import unittest

import toy_course
from toy_course import TOY

import assignment
from grading import Graded, capped, feedback_text, results_json, teacher_text

TOY_ASSIGNMENT = assignment.read(TOY / "assignment.toml")
SQUARE = TOY_ASSIGNMENT.exercise[0]


def points(public, hidden):
    results = capped(SQUARE, {"square-even": (public, "" if public == 1 else "not even"), "square-right": (hidden, "" if hidden == 1 else "not right")})
    return [result.points for result in results], results[0].message


class Points(unittest.TestCase):
    def test_public_checks_earn_at_most_the_fraction_of_hidden_ones(self):
        note = "{} of 4 points, limited to the fraction that the hidden checks of this exercise earn"
        for public, hidden, expected, message in ((1, 1, [4, 6], ""), (1, 0, [0, 0], note.format(4)), (1, 0.5, [2, 3], note.format(4)),
                                                  (0.5, 0.75, [2, 4.5], "not even"), (0.5, 0.25, [1, 1.5], "not even; " + note.format(2)),
                                                  (1, 1 / 3, [1.33, 2], note.format(4)), (1, 0.9375, [3.75, 5.63], note.format(4))):
            with self.subTest(public=public, hidden=hidden):
                self.assertEqual(points(public, hidden), (expected, message))


class Feedback(unittest.TestCase):
    graded = Graded(capped(SQUARE, {"square-even": (0.5, "not even"), "square-right": (0.5, "not right")}), {"src/sum.cpp": "a \x1b[31m‮ message"})

    def test_students_see_only_the_points_of_a_hidden_check(self):
        results = results_json(TOY_ASSIGNMENT, self.graded)
        self.assertEqual([(test["score"], test["max_score"], test["output"]) for test in results["tests"]], [(2, 4, "not even"), (3, 6, "")])
        feedback = feedback_text(TOY_ASSIGNMENT, self.graded)
        self.assertIn("  3 of 6  the square of four numbers (square-right)\n", feedback)
        self.assertIn("      not even\n", feedback)
        self.assertNotIn("not right", feedback + json.dumps(results))
        self.assertEqual(teacher_text(self.graded), "3 of 6  square-right  not right\n")

    def test_control_characters_in_compiler_messages_are_replaced(self):
        self.assertIn("  a ?[31m? message\n", feedback_text(TOY_ASSIGNMENT, self.graded))


if __name__ == "__main__":
    toy_course.main()
