# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by the tests of src/course: the toy assignment, a working folder, and the command line."""
import csv
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
ARGUMENTS = sys.argv[2:]
COURSE = ROOT / "src/course"
TOY = Path(__file__).resolve().parent / "toy"
sys.path.insert(0, str(COURSE))

SOLUTION = {"src/square.cpp": '#include "assignment.hpp"\ndouble square(double x) { return x * x; }\n',
            "src/sum.cpp": '#include "assignment.hpp"\ndouble sum(double a, double b) { return a + b; }\n',
            "src/cube.cpp": '#include "assignment.hpp"\ndouble cube(double x) { return x * x * x; }\n'}


def main():
    """Runs the tests of the calling file, without the arguments in ARGUMENTS."""
    unittest.main(argv=sys.argv[:1], verbosity=2)


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def running(name):
    """Returns how many processes of this machine have this name."""
    count = 0
    for file in Path("/proc").glob("[0-9]*/comm"):
        try:
            count += file.read_text() == f"{name}\n"
        except OSError:
            pass  # it has ended meanwhile
    return count


def end_of(name, seconds=60):
    """Waits until no process has this name. Returns False if one still runs after so many seconds."""
    until = time.monotonic() + seconds
    while running(name) and time.monotonic() < until:
        time.sleep(0.1)
    return running(name) == 0


def bubblewrap_problem(command=()):
    """Returns the reason why bubblewrap cannot start a sandbox here; empty if it can."""
    try:
        done = subprocess.run([*command, "bwrap", "--unshare-user-try", "--unshare-pid", "--unshare-net", "--ro-bind", "/", "/", "true"],
                              capture_output=True, text=True, check=False)
    except OSError as error:
        return str(error)
    return "" if done.returncode == 0 else done.stderr.strip() or "bubblewrap fails"


def require_bubblewrap(command=()):
    """Skips the tests if bubblewrap does not work. In continuous integration it must work."""
    problem = bubblewrap_problem(command)
    if problem and os.environ.get("CI") != "true":
        skip(f"bubblewrap does not work: {problem}")


def write(files, folder):
    for name, text in files.items():
        path = Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())


class Work:
    """A folder with the toy assignment, its judge and a salt, and the commands of the course."""

    def __init__(self, judge=None, prefix=()):
        self.prefix = list(prefix)  # makes commands run as a different user
        self.folder = Path(tempfile.mkdtemp(prefix="course test "))
        os.chmod(self.folder, 0o755)
        shutil.copytree(TOY, self.folder / "toy")
        self.private = self.folder / "private"
        self.private.mkdir()
        (self.private / "salt.txt").write_text("a salt\n")
        self.judge = self.private / "judge"
        if judge:
            shutil.copy(judge, self.judge)
        self.submissions = self.private / "submissions"
        self.output = self.folder / "build/grades"

    def give_to(self, user):
        subprocess.run(["chown", "-R", f"{user}:{user}", self.folder], check=True)

    def remove(self):
        shutil.rmtree(self.folder)

    def course(self, command, *options):
        """Runs a command of the course. Returns its exit code and its output."""
        done = subprocess.run([*self.prefix, sys.executable, "-B", COURSE / "course.py", command, "--assignment", self.folder / "toy",
                               "--build", self.folder / "build", "--judge", self.judge, "--salt-file", self.private / "salt.txt", *options],
                              capture_output=True, text=True, cwd="/", check=False)
        return done.returncode, done.stdout + done.stderr

    def grade(self, *options):
        return self.course("grade", self.submissions, *options)

    def table(self):
        """Reads grades.csv: {id: {column: text}}."""
        with open(self.output.with_name("grades.csv"), encoding="utf-8", newline="") as file:
            return {row["id"]: row for row in csv.DictReader(file)}
