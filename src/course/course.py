#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves the handout of the course assignment, grades submissions, and packs a grader for Gradescope."""
import argparse
import csv
import json
import os
import secrets
import shutil
import signal
import sys
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

sys.dont_write_bytecode = True  # leaves nothing in the checkout

import assignment as assignments
import gradescope
import sheet
import template
from build import Kit, hash_of, write, write_zip
from class_file import ClassFile
from errors import BadInput, Disproved, ToolFailure, progress
from grading import Graded, Grader, Judge, feedback_text, results_json, teacher_text
from proof import Proof, secrets_of
from sandbox import SANDBOXES
from submission import submissions_in

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = """examples:
  course.py prove                                      build/handout, build/handout.zip
  course.py grade submissions.zip --class marks.csv    build/grades.csv, build/marks.csv, build/grades/ID/feedback.txt
  course.py gradescope                                 build/gradescope.zip

exit codes: 0 success, 1 a claim does not hold or a submission was not graded, 2 bad input, 3 a tool failed"""


class Course:
    """What all commands use: the assignment, the students' project, and the folders for results."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.folder: Path = options.assignment
        self.build: Path = options.build.resolve()
        self.work = self.build / "course"
        self.assignment = assignments.read(self.folder / "assignment.toml")
        self.project = template.project(self.assignment, self.folder, ROOT / "src")
        self.handout = {name: file.handout for name, file in self.project.items()}
        self.salt_file: Path = options.salt_file.resolve()
        self.judge_file: Path = options.judge.resolve()
        self.work.mkdir(parents=True, exist_ok=True)

    def require_salt(self) -> None:
        if not self.salt_file.exists() or not self.salt_file.read_bytes():
            raise BadInput(f"{self.salt_file}: there is no salt for the hidden checks; \"prove\" writes one")

    def secrets(self) -> dict[str, str]:
        checks = [*ROOT.glob("src/assignment/hidden/*.?pp"), *ROOT.glob("src/assignment/exercises/*.?pp")]
        hidden = [path for path in checks if "hidden" in path.as_posix()]
        return secrets_of(self.assignment, self.project, hidden, [path for path in checks if path not in hidden])


def prove(options: argparse.Namespace) -> int:
    course = Course(options)
    output = course.build / "handout"
    if output.exists() and not (output / "src").is_dir():
        raise BadInput(f"{output}: this folder does not contain a handout; nothing was written")
    if not course.salt_file.exists():
        course.salt_file.write_text(secrets.token_hex(16) + "\n", encoding="utf-8")
        course.salt_file.chmod(0o600)
        print(f"{course.salt_file}: a new salt for the hidden checks; keep this file, and keep it secret")
    judge = Judge(course.judge_file, course.salt_file)
    proof = Proof(course, judge, SANDBOXES[options.sandbox], options.jobs)
    inputs = sheet.inputs(course.assignment, judge, course.folder)
    pdf = proof.sheet(inputs, sheet.typeset)
    proof.prove(course.secrets(), inputs, options.update)

    files: dict[str, str | bytes] = {**course.handout, "sheet.pdf": pdf}
    replace_folder(output, files)
    packed = course.build / "handout.zip"
    write_zip({f"handout/{name}": content for name, content in files.items()}, packed)
    (course.work / "proved").write_text(hash_of(course.salt_file.read_bytes()), encoding="utf-8")
    print(f"{os.path.relpath(output)}\n{os.path.relpath(packed)}")
    return 0


def grade(options: argparse.Namespace) -> int:
    course = Course(options)
    course.require_salt()
    output = course.build / "grades"
    for entry in sorted(output.iterdir()) if output.exists() else []:
        if not (entry / "feedback.txt").exists():
            raise BadInput(f"{output}: this folder contains '{entry.name}', which is not a grade; nothing was written")
    class_file = ClassFile(options.class_file, course.assignment) if options.class_file else None

    submitted, problems = read_submissions(options.submissions, course.assignment)
    if class_file:
        for id in submitted:
            class_file.row_of(id)
    for id, problem in problems.items():
        print(f"{id}: not graded: {problem}", file=sys.stderr)
    if not submitted:
        raise BadInput(f"{options.submissions}: no submission can be graded; nothing was written")
    proved = course.work / "proved"
    if not proved.exists() or proved.read_text() != hash_of(course.salt_file.read_bytes()):
        print("note: the handout was not proved here with this salt; grade the whole class with the same salt", file=sys.stderr)

    output.mkdir(exist_ok=True)
    output.chmod(0o700)  # hides it from submissions in the sandbox "user"
    for id, graded in grade_all(course, options, submitted):
        if isinstance(graded, BaseException):
            problems[id] = f"the grader failed: {graded}"
            print(f"{id}: not graded: {problems[id]}", file=sys.stderr)
        else:
            replace_folder(output / id, {"results.json": json.dumps(results_json(course.assignment, graded), indent=1),
                                         "feedback.txt": feedback_text(course.assignment, graded),
                                         "teacher.txt": teacher_text(graded)})
    for id, problem in problems.items():
        replace_folder(output / id, {"feedback.txt": f"This submission was not graded: {problem}\n"})

    table = course.build / "grades.csv"
    marks = write_table(course.assignment, output, table)
    written = [output, table]
    if class_file:
        written.append(course.build / options.class_file.name)
        new_marks = {id: points for id in submitted if (points := marks[id]) is not None}
        written[-1].write_text(class_file.filled(new_marks), encoding="utf-8", newline="")
    n_submissions = len(submitted.keys() | problems.keys())
    print(f"{n_submissions - len(problems)} of {n_submissions} submissions were graded", *map(os.path.relpath, written), sep="\n")
    return 1 if problems else 0


def read_submissions(source: Path, assignment: assignments.Assignment) -> tuple[dict[str, dict[str, bytes]], dict[str, str]]:
    """Returns the files of each submission, {id: {name: bytes}}, and why a submission cannot be graded, {id: reason}."""
    submitted, problems = {}, {}
    for submission in submissions_in(source):
        try:
            submitted[submission.id] = submission.read_files(assignment)
        except BadInput as error:
            problems[submission.id] = str(error)
    return submitted, problems


def grade_all(course: Course, options: argparse.Namespace,
              submitted: dict[str, dict[str, bytes]]) -> Iterator[tuple[str, Graded | BaseException]]:
    """Grades submissions in parallel. Yields each id with its Graded, or with the exception that the grader raised."""
    judge = Judge(course.judge_file, course.salt_file)
    kit = Kit.built(course.work / "kit", course.handout, options.jobs)
    sandbox_class = SANDBOXES[options.sandbox]
    sandbox_class(kit.folder, course.assignment.limits).require()
    scratch = course.work / "scratch"
    shutil.rmtree(scratch, ignore_errors=True)  # what an interrupted command has left

    def grade_one(id: str) -> Graded:
        (scratch / id).mkdir(parents=True)
        sandbox = sandbox_class(kit.folder, course.assignment.limits)
        graded = Grader(course.assignment, kit, sandbox, judge, scratch / id).grade(submitted[id], id)
        shutil.rmtree(scratch / id, ignore_errors=True)
        return graded

    progress("graded", 0, len(submitted))
    with ThreadPoolExecutor(options.jobs) as pool:
        waiting = {pool.submit(grade_one, id): id for id in submitted}
        for number, future in enumerate(as_completed(waiting), 1):
            progress("graded", number, len(submitted))
            yield waiting[future], future.exception() or future.result()


def replace_folder(folder: Path, files: Mapping[str, str | bytes]) -> None:
    """Replaces a folder by one with these files."""
    new = folder.with_name(f".{folder.name}.new")
    shutil.rmtree(new, ignore_errors=True)
    write(files, new)
    shutil.rmtree(folder, ignore_errors=True)
    new.rename(folder)


def write_table(assignment: assignments.Assignment, output: Path, table: Path) -> dict[str, float | None]:
    """Writes the points of each student with a folder in `output` to a table. Returns them, {id: points or None}."""
    marks = {}
    with open(table, "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["id", "points", *(check.id for check in assignment.checks)])
        for folder in sorted(path for path in output.iterdir() if not path.name.startswith(".")):
            results = folder / "results.json"
            found = json.loads(results.read_text(encoding="utf-8")) if results.exists() else {"score": None, "tests": []}
            scores = {test["name"].split(":")[0]: f"{test['score']:g}" for test in found["tests"]}
            marks[folder.name] = found["score"]
            points = "" if found["score"] is None else f"{found['score']:g}"
            rows.writerow([folder.name, points, *(scores.get(check.id, "") for check in assignment.checks)])
    return marks


def pack_for_gradescope(options: argparse.Namespace) -> int:
    course = Course(options)
    course.require_salt()
    output = course.build / "gradescope.zip"
    gradescope.pack(course.assignment, course.handout, Judge(f"{course.judge_file}-static", course.salt_file), output)
    print(f"{os.path.relpath(output)}\n"
          "Upload it as the autograder, with the default base image. It contains the salt: give it to nobody else.")
    return 0


def parser() -> argparse.ArgumentParser:
    shared = argparse.ArgumentParser(add_help=False)
    shared.add_argument("--assignment", type=Path, default=ROOT / "report/assignment", metavar="FOLDER",
                        help="folder of the assignment (report/assignment)")
    shared.add_argument("--build", type=Path, default=ROOT / "build", metavar="FOLDER", help="folder for results (build)")
    shared.add_argument("--judge", type=Path, default=ROOT / "build/release/halfspace-judge", metavar="PROGRAM",
                        help="the compiled judge")
    shared.add_argument("--salt-file", type=Path, default=ROOT / "salt.txt", metavar="FILE",
                        help="the salt, which determines the numbers of the hidden checks (salt.txt)")
    jobs = argparse.ArgumentParser(add_help=False)
    jobs.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N",
                      help="number of parallel jobs (one per processor)")
    jobs.add_argument("--sandbox", choices=SANDBOXES, default="bubblewrap",
                      help="'user' is for root in a container that contains nothing else")

    commands = argparse.ArgumentParser(description=__doc__, epilog=EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter)
    chosen = commands.add_subparsers(required=True, metavar="COMMAND")
    command = chosen.add_parser("prove", parents=[shared, jobs], help="write the handout and prove that it is correct")
    command.add_argument("--update", action="store_true", help="write the points that the wrong solutions score into their list")
    command.set_defaults(run=prove)
    command = chosen.add_parser("grade", parents=[shared, jobs], help="grade submissions")
    command.add_argument("submissions", type=Path, help="a folder of folders or zips, or the zip that Moodle or Canvas gives")
    command.add_argument("--class", dest="class_file", type=Path, metavar="FILE",
                         help="the Moodle worksheet or Canvas gradebook to fill")
    command.set_defaults(run=grade)
    command = chosen.add_parser("gradescope", parents=[shared], help="pack a grader for Gradescope")
    command.set_defaults(run=pack_for_gradescope)
    return commands


def main() -> int:
    options = parser().parse_args()
    os.umask(0o022)  # a job runs as a different user
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # ends this process at once, and with it its jobs
    try:
        return int(options.run(options))
    except (BadInput, ToolFailure, Disproved) as error:
        print(error, file=sys.stderr)
        return {BadInput: 2, ToolFailure: 3, Disproved: 1}[type(error)]
    except OSError as error:  # a file or folder of the user cannot be read or written
        print(f"{error.filename}: {error.strerror}" if error.filename else error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
