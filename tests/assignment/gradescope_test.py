# SPDX-License-Identifier: GPL-3.0-or-later
"""The zip for Gradescope grades submissions and contains no secrets but the salt. gradescope_test.py ROOT JUDGE"""
import ast
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import real_assignment
from real_assignment import ASSIGNMENT, PROJECT, ROOT, SOLUTION
from toy_course import ARGUMENTS, skip, write

import proof

READS_SALT = '''#include <fstream>
#include "assignment/given/student_functions.hpp"
namespace exercise {
double normal_gradient(const Material&, const TriangularLoad&, double x) {
  std::ofstream("@/results/results.json") << "{\\"score\\": 100}";
  return std::ifstream("@/source/salt").good() || std::ifstream("@/source/judge").good() ? -x : 0;
}
}
'''


class Gradescope(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.autograder = Path(tempfile.mkdtemp(prefix="course test "))
        cls.addClassCleanup(shutil.rmtree, cls.autograder)
        os.chmod(cls.autograder, 0o755)
        for name in ("results", "submission"):
            (cls.autograder / name).mkdir()
        write({"salt.txt": "a salt\n", "submission_metadata.json": json.dumps({"users": [{"email": "ada@uni.edu", "id": 1}]})}, cls.autograder)
        subprocess.run([sys.executable, "-B", ROOT / "src/course/course.py", "gradescope", "--judge", ARGUMENTS[0], "--salt-file",
                        cls.autograder / "salt.txt", "--build", cls.autograder / "build"], check=True, capture_output=True)
        with zipfile.ZipFile(cls.autograder / "build/gradescope.zip") as packed:
            packed.extractall(cls.autograder / "source")
            cls.modes = {info.filename: info.external_attr >> 16 & 0o777 for info in packed.infolist() if not info.is_dir()}
        # Gradescope keeps the permissions of the files.
        for name, mode in cls.modes.items():
            os.chmod(cls.autograder / "source" / name, mode)

    def run_there(self, command):
        done = subprocess.run([sys.executable, "-B", self.autograder / "source/course/gradescope.py", command], capture_output=True, text=True,
                              env={**os.environ, "AUTOGRADER": str(self.autograder)}, check=False)
        return done.returncode, done.stdout + done.stderr

    def graded(self, files):
        """Grades a submission. Returns the exit code, the output and the results."""
        shutil.rmtree(self.autograder / "submission")
        write(files, self.autograder / "submission")
        (self.autograder / "results/results.json").unlink(missing_ok=True)
        status, output = self.run_there("grade")
        results = self.autograder / "results/results.json"
        return status, output, json.loads(results.read_text()) if results.exists() else None

    def test_it_grades_and_a_submission_cannot_reach_salt_or_results(self):
        if os.geteuid() != 0:
            self.skipTest("only root can become an unprivileged user, as on Gradescope")
        self.assertEqual(self.run_there("setup"), (0, "building the handout\n"))

        status, output, results = self.graded(SOLUTION)
        self.assertEqual((status, results["score"]), (0, ASSIGNMENT.points), output)
        self.assertEqual(results["stdout_visibility"], "hidden")
        self.assertTrue(all(test["output"] == "" for test in results["tests"]))

        status, output, results = self.graded({**SOLUTION, "src/closed_form.cpp": READS_SALT.replace("@", str(self.autograder))})
        self.assertEqual((status, sum(test["score"] for test in results["tests"][:5])), (0, 0), output)
        self.assertGreater(results["score"], 60)
        self.assertIn("0 of 7  gradient-reference", output)
        self.assertNotIn("right to", json.dumps(results))

        status, output, results = self.graded({"thesis.pdf": "x"})
        self.assertEqual((status, results["score"]), (0, 0), output)
        self.assertIn("Nothing can be graded: none of the files src/closed_form.cpp", results["output"])

        (self.autograder / "source/judge").write_text("#!/bin/sh\nexit 3\n")
        status, output, results = self.graded(SOLUTION)
        self.assertEqual((status, results), (3, None))
        self.assertIn("the grader failed: judge failed (3)", output)

    def test_the_zip_contains_no_solution_and_no_source_of_a_hidden_check(self):
        source = self.autograder / "source"
        hidden = [*ROOT.glob("src/assignment/exercises/*_hidden.cpp"), *ROOT.glob("src/assignment/hidden/*.?pp")]
        public = [*ROOT.glob("src/assignment/exercises/*.hpp"), *ROOT.glob("src/assignment/given/*")]
        secrets = proof.secrets_of(ASSIGNMENT, PROJECT, hidden, public)
        for check in ASSIGNMENT.checks:
            secrets.pop(check.id, None)  # students see these ids with their points
        texts = {name: (source / name).read_bytes().decode("latin-1") for name in self.modes}
        self.assertEqual(proof.leaks(texts, secrets), [])
        self.assertEqual((self.modes["setup.sh"], self.modes["run_autograder"], self.modes["judge"], self.modes["salt"]), (0o755, 0o755, 0o755, 0o644))

    def test_the_judge_needs_no_library(self):
        output = subprocess.run(["ldd", self.autograder / "source/judge"], capture_output=True, text=True, check=False)
        self.assertIn("not a dynamic executable", output.stdout + output.stderr)

    def test_its_scripts_are_python_3_10(self):
        for path in (self.autograder / "source/course").glob("*.py"):
            tree = ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 10))
            imported = {name.name for node in tree.body if isinstance(node, ast.Import) for name in node.names}
            self.assertNotIn("tomllib", imported, path.name)


if __name__ == "__main__":
    if not Path(ARGUMENTS[0] + "-static").exists():
        skip("the static judge is not built")
    real_assignment.main()
