# SPDX-License-Identifier: GPL-3.0-or-later
"""The grader on Gradescope: makes its zip, and runs there (with Python 3.10).

Gradescope unpacks the zip in /autograder/source, runs setup.sh once as root, and runs run_autograder for each submission. A
submission runs as a user who can neither read the judge and the salt nor write results.
"""
import dataclasses
import json
import os
import sys
import tempfile
from pathlib import Path

from assignment import Assignment, from_table
from build import Kit, write_zip
from errors import BadInput, Disproved, ToolFailure
from grading import Grader, Judge, results_json, teacher_text
from sandbox import User
from submission import Submission, folder_members

MODULES = ["assignment", "build", "errors", "grading", "gradescope", "sandbox", "submission"]
HERE = Path(__file__).resolve().parent
AUTOGRADER = Path(os.environ.get("AUTOGRADER", "/autograder"))

SETUP = """#!/bin/sh
# Gradescope runs this once, as root.
set -eu
cd "$(dirname "$0")"
apt-get update
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends g++ cmake make pkg-config libeigen3-dev libgsl-dev \\
  python3
[ "$(uname -m)" = x86_64 ] || { echo 'setup.sh: the judge runs on x86-64 only' >&2; exit 3; }
python3 course/gradescope.py setup
"""
RUN = """#!/bin/sh
# Gradescope runs this for each submission, as root.
exec python3 /autograder/source/course/gradescope.py grade
"""


def pack(assignment: Assignment, handout: dict[str, str], judge: Judge, output: Path) -> None:
    """Writes the zip."""
    write_zip({"setup.sh": SETUP, "run_autograder": RUN,
               **{f"course/{name}.py": (HERE / f"{name}.py").read_bytes() for name in MODULES},
               "assignment.json": json.dumps(dataclasses.asdict(assignment)),
               "judge": judge.program.read_bytes(), "salt": judge.salt_file.read_bytes(),
               **{f"handout/{name}": text for name, text in handout.items() if name.endswith((".cpp", ".hpp", ".txt"))}}, output)


def setup(source: Path) -> None:
    """Compiles the kit, which submissions may read. They may read nothing else."""
    handout = source / "handout"
    texts = {path.relative_to(handout).as_posix(): path.read_text(encoding="utf-8") for path in handout.rglob("*.*")}
    Kit.built(AUTOGRADER / "kit", texts, os.cpu_count() or 1)
    os.chmod(source / "judge", 0o700)
    os.chmod(source, 0o700)


def grade(source: Path) -> None:
    """Grades /autograder/submission. If the grader itself fails, it writes no results, so that nobody gets zero points."""
    results = AUTOGRADER / "results"
    os.chmod(source, 0o700)
    os.chmod(results, 0o700)
    assignment = from_table(json.loads((source / "assignment.json").read_text(encoding="utf-8")), "assignment.json")
    metadata = json.loads((AUTOGRADER / "submission_metadata.json").read_text(encoding="utf-8"))
    student = next((user["email"] for user in metadata.get("users", []) if user.get("email")), "")
    kit = Kit(AUTOGRADER / "kit")
    sandbox = User(kit.folder, assignment.limits)
    sandbox.require()
    try:
        submitted = Submission(student, folder_members(AUTOGRADER / "submission")).read_files(assignment)
    except BadInput as error:
        found = {"score": 0, "output": f"Nothing can be graded: {error}"}
    else:
        with tempfile.TemporaryDirectory() as store:
            os.chmod(store, 0o755)
            graded = Grader(assignment, kit, sandbox, Judge(source / "judge", source / "salt"), store).grade(submitted, student)
        print(teacher_text(graded))  # Gradescope shows standard output to the teacher only
        found = results_json(assignment, graded)
    (results / "results.json").write_text(json.dumps(found), encoding="utf-8")


if __name__ == "__main__":
    os.umask(0o022)  # submissions run as a different user
    try:
        {"setup": setup, "grade": grade}[sys.argv[1]](HERE.parent)
    except (BadInput, Disproved, ToolFailure, OSError) as error:
        print(f"the grader failed: {error}", file=sys.stderr)
        sys.exit(3)
