# SPDX-License-Identifier: GPL-3.0-or-later
"""Grades the submissions in attacks.cpp as one class. Each must score the points in its first line and harm no other.

attacks_test.py ROOT JUDGE MODE: MODE "root" and "user" grade with bubblewrap as root and as an ordinary user, "container" as
root without bubblewrap. "quick" grades with bubblewrap as the current user, and only submissions that take no time.
"""
import os
import re
import socket
import subprocess
import unittest
from pathlib import Path

import toy_course
from toy_course import ARGUMENTS, SOLUTION, Work, end_of, require_bubblewrap, skip

JUDGE, MODE = ARGUMENTS
ORDINARY = 61000
SLOW = {"answers_late", "hangs_at_start", "hangs_at_one_place", "never_ends", "sleeps", "forks", "compiles_without_end", "takes_memory", "fills_the_disk"}
SECTION = re.compile(r"// == (\w+) ([\d.]+) ([\d.]+) ([\d.]+): .*\n((?:(?!// == ).*\n)*)")
TEXT = Path(__file__).with_name("attacks.cpp").read_text(encoding="utf-8")
SECTIONS = SECTION.findall(TEXT)
FIXTURES = {name: TEXT[:TEXT.index("// == ")] + text for name, *_, text in SECTIONS}
if MODE == "quick":
    FIXTURES = {name: text for name, text in FIXTURES.items() if name not in SLOW}
if MODE == "container":
    del FIXTURES["uses_the_network"]  # a container may have a network


class Attacks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        prefix = ["setpriv", f"--reuid={ORDINARY}", f"--regid={ORDINARY}", "--clear-groups", "--"] if MODE == "user" else []
        cls.work = Work(JUDGE, prefix)
        cls.addClassCleanup(cls.work.remove)
        earlier = cls.work.output / "earlier/feedback.txt"
        toy_course.write({"feedback.txt": "earlier\n"}, earlier.parent)
        listener = socket.create_server(("127.0.0.1", 0))
        cls.addClassCleanup(listener.close)
        cls.port = listener.getsockname()[1]
        words = {"@SALT@": cls.work.private / "salt.txt", "@JUDGE@": cls.work.judge, "@GRADES@": earlier,
                 "@RESULTS@": cls.work.output / "earlier/results.json", "@PORT@": cls.port,
                 "@NEIGHBOUR@": cls.work.submissions / "honest/src/square.cpp"}
        for name, text in FIXTURES.items():
            for word, value in words.items():
                text = text.replace(word, str(value))
            toy_course.write({**SOLUTION, "src/square.cpp": text}, cls.work.submissions / name)
        for name in ("honest", "zz_honest"):
            toy_course.write(SOLUTION, cls.work.submissions / name)
        toy_course.write({"CMakeLists.txt": "message(FATAL_ERROR)", "Makefile": "all:\n\tfalse\n", "src/assignment.hpp": "#error\n",
                          "provided/main.cpp": "int main() {}\n", "provided/checks.cpp": "int main() {}\n",
                          ".github/workflows/checks.yml": "on: push\n", "src/square.cpp": "double square(double) { return 1; }\n"},
                         cls.work.submissions / "edits_the_project")
        os.chmod(cls.work.private, 0o700)
        if MODE == "user":
            cls.work.give_to(ORDINARY)
        bystander = subprocess.Popen([*prefix, "sleep", "3600"])
        cls.addClassCleanup(bystander.wait)
        cls.addClassCleanup(bystander.kill)
        cls.bystander = bystander
        sandbox = ["--sandbox", "user"] if MODE == "container" else []
        cls.status, cls.output = cls.work.grade("--jobs", "2", *sandbox)
        if cls.status not in (0, 1) or "Traceback" in cls.output:
            raise AssertionError(cls.output)
        cls.table = cls.work.table()
        if MODE == "container":
            Path("/tmp/large").unlink(missing_ok=True)

    def points(self, name):
        row = self.table[name]
        return [sum(float(row[check] or -99) for check in row if check.startswith(exercise)) for exercise in ("square", "sum", "cube")]

    def test_every_submission_is_graded(self):
        self.assertEqual(self.status, 0, self.output)

    def test_each_submission_scores_the_listed_points(self):
        self.assertEqual(len(SECTIONS), 37)
        for name, *points, _ in SECTIONS:
            if name in FIXTURES:
                with self.subTest(name):
                    self.assertEqual(self.points(name), [float(number) for number in points], self.feedback(name))

    def test_edited_files_of_the_project_have_no_effect(self):
        self.assertEqual(self.points("edits_the_project"), [0, 0, 0])
        self.assertIn("src/sum.cpp was not submitted", self.feedback("edits_the_project"))

    def test_other_submissions_and_processes_are_unharmed(self):
        self.assertEqual([self.points("honest"), self.points("zz_honest")], [[10, 10, 10]] * 2)
        self.assertIsNone(self.bystander.poll())
        self.assertEqual((self.work.output / "earlier/feedback.txt").read_text(), "earlier\n")

    def test_nothing_is_left_behind(self):
        self.assertTrue(end_of(f"left-{self.port}"))
        self.assertFalse((self.work.output / "earlier/results.json").exists())

    def test_feedback_names_crashes_and_time_limits(self):
        self.assertIn("crashed (SIGABRT)", self.feedback("crashes_at_one_place"))
        self.assertIn("multiple definition of `main'", self.feedback("defines_main"))
        if "never_ends" in FIXTURES:
            # On a busy machine the question's time may end first.
            self.assertRegex(self.feedback("never_ends"), "used up its processor time|did not answer in time")
            self.assertIn("did not answer in time", self.feedback("sleeps"))

    def test_feedback_contains_no_message_of_a_hidden_check(self):
        for name in FIXTURES:
            self.assertNotIn("the square is right", self.feedback(name))
        self.assertIn("the square is right: does not hold in 1 of 4 cases (x = -2)",
                      (self.work.output / "nan_at_one_place/teacher.txt").read_text(encoding="utf-8"))

    def feedback(self, name):
        return (self.work.output / name / "feedback.txt").read_text(encoding="utf-8")


if __name__ == "__main__":
    if MODE != "quick" and os.geteuid() != 0:
        skip("only root can become a different user")
    if MODE == "user":
        require_bubblewrap(["setpriv", f"--reuid={ORDINARY}", f"--regid={ORDINARY}", "--clear-groups", "--"])
    elif MODE != "container":
        require_bubblewrap()
    toy_course.main()
