# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `grade` from end to end, with the toy assignment. grade_test.py ROOT JUDGE"""
import io
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
import zipfile

import toy_course
from toy_course import ARGUMENTS, COURSE, SOLUTION, Work, bubblewrap_problem, end_of, running, skip, write

SANDBOX = [] if not bubblewrap_problem() else ["--sandbox", "user"]
WORKSHEET = """Identifier,Name,Status,Grade,Maximum,Changeable
"Participant 11",Ada,,,30.00,Yes
"Participant 12",Bob,,,30.00,Yes
"Participant 13",Cleo,,5.00,30.00,Yes
"Participant 14",Dan,,5.00,30.00,Yes
"""


def zipped(files):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as packed:
        for name, text in files.items():
            packed.writestr(name, text)
    return stream.getvalue()


class Grade(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kit = Work(ARGUMENTS[0])  # its kit takes seconds to compile, so each test copies it
        cls.addClassCleanup(cls.kit.remove)
        write(SOLUTION, cls.kit.submissions / "ada")
        status, output = cls.kit.grade(*SANDBOX)
        if status != 0:
            raise AssertionError(output)

    def setUp(self):
        self.work = Work(ARGUMENTS[0])
        self.addCleanup(self.work.remove)
        shutil.copytree(self.kit.folder / "build/course", self.work.folder / "build/course")

    def grade(self, *options):
        return self.work.grade("--jobs", "2", *SANDBOX, *options)

    def fails(self, status, text, *options):
        """Requires that grading ends with this status and message, and that it changes no grades."""
        before = sorted(path.relative_to(self.work.folder) for path in self.work.output.rglob("*"))
        found, output = self.grade(*options)
        self.assertEqual(found, status, output)
        self.assertRegex(output, text)
        self.assertNotIn("Traceback", output)
        self.assertEqual(sorted(path.relative_to(self.work.folder) for path in self.work.output.rglob("*")), before)

    def test_a_class_gets_points_reasons_and_a_filled_moodle_file(self):
        crlf = {name: b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode() for name, text in SOLUTION.items()}
        carriage_return = {**SOLUTION, "src/cube.cpp": SOLUTION["src/cube.cpp"].replace("x * x * x", "1.\r0 * x * x * x")}
        del carriage_return["src/sum.cpp"]
        mac = {**{f"hw/{name}": text for name, text in SOLUTION.items()}, "__MACOSX/hw/src/._sum.cpp": "junk", "hw/.DS_Store": "junk"}
        write({"Ada A_11_assignsubmission_file_/hw.zip": zipped(crlf), "Bob B_12_assignsubmission_file_/hw.zip": zipped(carriage_return),
               "Cleo C_13_assignsubmission_file_hw.zip": zipped(mac), "Dan D_14_assignsubmission_file_hw.zip": b"damaged"}, self.work.submissions)
        write({"worksheet.csv": WORKSHEET}, self.work.folder)

        status, output = self.grade("--class", self.work.folder / "worksheet.csv")

        self.assertEqual(status, 1, output)
        self.assertIn("14: not graded: the zip is damaged: File is not a zip file\n", output)
        self.assertIn("3 of 4 submissions were graded\n", output)
        table = self.work.table()
        self.assertEqual({id: row["points"] for id, row in table.items()}, {"11": "30", "12": "10", "13": "30", "14": ""})
        self.assertEqual(list(table["11"]), ["id", "points", "square-even", "square-right", "sum-commutes", "sum-right", "cube-agrees", "cube-right"])
        self.assertEqual(table["12"]["sum-right"], "0")
        filled = (self.work.folder / "build/worksheet.csv").read_text()
        self.assertEqual([line.split(",")[3] for line in filled.splitlines()[1:]], ["30.00", "10.00", "30.00", "5.00"])

        feedback = (self.work.output / "12/feedback.txt").read_text()
        self.assertIn("  src/sum.cpp was not submitted\n", feedback)
        self.assertIn("  src/cube.cpp:2:34: error: expected ‘;’ before numeric constant\n", feedback)
        self.assertEqual((self.work.output / "14/feedback.txt").read_text(), "This submission was not graded: the zip is damaged: File is not a zip file\n")
        results = json.loads((self.work.output / "12/results.json").read_text())
        self.assertEqual((results["score"], results["stdout_visibility"], len(results["tests"])), (10, "hidden", 6))
        self.assertEqual([test["output"] for test in results["tests"] if "right" in test["name"]], ["", "", ""])

    def test_grading_some_submissions_again_keeps_the_results_of_the_others(self):
        write(SOLUTION, self.work.submissions / "ada")
        write({"src/sum.cpp": SOLUTION["src/sum.cpp"]}, self.work.submissions / "bob")
        (self.work.submissions / "cleo").symlink_to("ada")
        self.assertEqual(self.grade()[0], 1)
        self.assertEqual({id: row["points"] for id, row in self.work.table().items()}, {"ada": "30", "bob": "10", "cleo": ""})

        shutil.rmtree(self.work.submissions)
        write(SOLUTION, self.work.submissions / "bob")
        status, output = self.grade()

        self.assertEqual(status, 0, output)
        self.assertEqual({id: row["points"] for id, row in self.work.table().items()}, {"ada": "30", "bob": "30", "cleo": ""})

    def test_bad_input_exits_with_2_and_writes_nothing(self):
        write(SOLUTION, self.work.submissions / "ada")
        write({"worksheet.csv": WORKSHEET, "other.csv": "a,b\n1,2\n"}, self.work.folder)
        self.fails(2, "neither a Moodle grading worksheet nor a Canvas gradebook", "--class", self.work.folder / "other.csv")
        write(SOLUTION, self.work.submissions / "nobody")
        self.fails(2, "the id 'nobody' is in 0 rows instead of one", "--class", self.work.folder / "worksheet.csv")
        write({"thesis.tex": ""}, self.work.output)
        self.fails(2, "this folder contains 'thesis.tex', which is not a grade; nothing was written")
        shutil.rmtree(self.work.output)
        shutil.rmtree(self.work.submissions)
        write({"ada.zip": b"damaged"}, self.work.submissions)
        self.fails(2, "ada: not graded: the zip is damaged(.|\n)*no submission can be graded; nothing was written")
        self.fails(2, "invalid int value: 'many'", "--jobs", "many")
        self.fails(2, "none.csv: No such file or directory", "--class", self.work.folder / "none.csv")
        (self.work.private / "salt.txt").write_text("")
        self.fails(2, "there is no salt for the hidden checks; \"prove\" writes one")

    def test_a_failure_of_the_grader_gives_nobody_zero_points(self):
        write(SOLUTION, self.work.submissions / "ada")
        self.work.judge.write_text("#!/bin/sh\necho 'something is wrong' >&2\nexit 3\n")
        status, output = self.grade()
        self.assertEqual(status, 1)
        self.assertIn("ada: not graded: the grader failed: judge failed (3): something is wrong", output)
        self.assertEqual(self.work.table()["ada"]["points"], "")
        self.work.judge.unlink()
        self.assertEqual(self.grade()[0], 3)

    def test_a_salt_different_from_that_of_the_proof_is_reported(self):
        write(SOLUTION, self.work.submissions / "ada")
        self.assertIn("note: the handout was not proved here with this salt", self.grade()[1])
        sys.path.insert(0, str(COURSE))
        from build import hash_of
        write({"proved": hash_of((self.work.private / "salt.txt").read_bytes())}, self.work.folder / "build/course")
        self.assertNotIn("note", self.grade()[1])
        (self.work.private / "salt.txt").write_text("a different salt\n")
        self.assertIn("note: the handout was not proved here with this salt", self.grade()[1])

    def test_after_an_interrupt_no_job_runs_and_the_next_command_works(self):
        name = f"wait-{os.getpid()}"
        waiting = '#include <unistd.h>\n#include <sys/prctl.h>\ndouble square(double) { ::prctl(PR_SET_NAME, "@NAME@"); ::sleep(1000); return 1; }\n'
        write({**SOLUTION, "src/square.cpp": waiting.replace("@NAME@", name)}, self.work.submissions / "ada")
        command = [sys.executable, "-B", COURSE / "course.py", "grade", self.work.submissions, "--assignment", self.work.folder / "toy", "--build",
                   self.work.folder / "build", "--judge", self.work.judge, "--salt-file", self.work.private / "salt.txt"]
        # A shell starts background jobs with SIGINT ignored.
        process = subprocess.Popen(["env", "--default-signal=INT", *command, *SANDBOX], stderr=subprocess.PIPE, text=True)
        while not running(name):
            self.assertIsNone(process.poll())
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        self.assertNotIn("Traceback", process.communicate()[1])
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertTrue(end_of(name))
        write(SOLUTION, self.work.submissions / "ada")
        self.assertEqual(self.grade()[0], 0)


if __name__ == "__main__":
    if SANDBOX and os.geteuid() != 0:
        skip(f"no submission was graded: {bubblewrap_problem()}")
    toy_course.main()
