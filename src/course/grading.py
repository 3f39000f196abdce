# SPDX-License-Identifier: GPL-3.0-or-later
"""Grades a submission: the judge runs the public checks and then the hidden checks on the program of each exercise.

Numbers that are merely consistent with each other pass most public checks. So a public check earns at most the fraction of
its points that the hidden checks of its exercise earn.
"""
import json
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from assignment import Assignment, Check, Exercise
from build import Builder, Kit, hash_of, printable
from errors import BadInput, ToolFailure
from sandbox import Sandbox

GRACE = 3  # seconds for the questions of an exercise after the submission has used up its time
Outcomes = dict[str, tuple[float, str]]  # {check id: (share, message)}


@dataclass
class Result:
    check: Check
    points: float
    message: str  # the message of a hidden check is for the teacher only


@dataclass
class Graded:
    results: list[Result]
    errors: dict[str, str]  # {file: why it was left out}

    @property
    def points(self) -> float:
        return round(sum(result.points for result in self.results), 2)


class Judge:
    """The judge's program, and the salt that determines the numbers of the hidden checks; by default they are nominal."""

    def __init__(self, program: str | Path, salt_file: str | Path = "/dev/null") -> None:
        self.program, self.salt_file = Path(program).resolve(), Path(salt_file)
        if not self.program.exists():
            raise ToolFailure(f"{program} does not exist; \"make course DO=…\" compiles it")
        self.key = hash_of(self.program.read_bytes(), self.salt_file.read_bytes())

    def numbers(self) -> list[list[str]]:
        """Returns the nominal numbers, lists of name, value and unit."""
        return [line.split() for line in self.call("--numbers", "").splitlines()]

    def call(self, *words: str | Path) -> str:
        # The judge must end when this process ends; the student's program then ends too.
        command: list[str | Path] = ["setpriv", "--pdeathsig", "KILL", self.program, *words]
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
        if done.returncode not in (0, 1):
            raise ToolFailure(f"{self.program.name} failed ({done.returncode}): {done.stderr.strip()}")
        return done.stdout

    def ask(self, exercise: Exercise, visibility: str, student: str, seconds: float, command: list[str]) -> Outcomes:
        """Returns {check id: (share, message)} of a program, whose answers may take so many seconds together."""
        origin: list[str | Path] = ["--student", student] if visibility == "public" else ["--salt", self.salt_file]
        rows = self.call("--exercise", exercise.id, *origin, "--seconds", f"{seconds:.3f}", "--", *command).splitlines()
        outcomes = {id: (float(share), message) for id, share, message in (row.split("\t") for row in rows)}
        listed = {check.id for check in exercise.check if check.visibility == visibility}
        for id in sorted(listed ^ outcomes.keys()):
            problem = "has no code" if id in listed else "is not listed in assignment.toml"
            raise BadInput(f"the {visibility} check '{id}' of exercise '{exercise.id}' {problem}")
        return outcomes


class Grader:
    """Grades submissions. A store caches programs and outcomes: a proof keeps it, and grading deletes it."""

    def __init__(self, assignment: Assignment, kit: Kit, sandbox: Sandbox, judge: Judge, store: str | Path) -> None:
        self.assignment, self.sandbox, self.judge = assignment, sandbox, judge
        self.builder = Builder(assignment, kit, sandbox, store)

    def grade(self, files: dict[str, bytes], student: str = "") -> Graded:
        """Grades a submission's files, {name: bytes}, with the numbers that follow from the student's id."""
        end = time.monotonic() + self.assignment.limits.submission_seconds
        programs, errors = self.builder.build(files)
        graded = Graded([], errors)
        for exercise in self.assignment.exercise:
            outcomes: Outcomes = {}
            if exercise.file in errors:
                outcomes = {check.id: (0, f"{exercise.file} is missing, or does not compile or link") for check in exercise.check}
            else:
                for visibility in ("public", "hidden"):
                    seconds = max(end - time.monotonic(), GRACE)
                    outcomes |= self.outcomes_of(exercise, visibility, student, seconds, programs[exercise.id])
            graded.results += capped(exercise, outcomes)
        return graded

    def outcomes_of(self, exercise: Exercise, visibility: str, student: str, seconds: float, folder: Path) -> Outcomes:
        """Returns what Judge.ask returns for the program in a folder. Runs the judge unless the store has the outcome."""
        key = hash_of(self.judge.key, exercise, visibility, student if visibility == "public" else "", folder.name)
        file = self.builder.store / f"{key}.json"
        if file.exists():
            outcomes: Outcomes = json.loads(file.read_text(encoding="utf-8"))
            return outcomes
        command = self.sandbox.command(["sh", "-c", "exec ./program 2> /dev/null"], folder, self.assignment.limits.run_seconds)
        try:
            outcomes = self.judge.ask(exercise, visibility, student, seconds, command)
        finally:
            self.sandbox.clean()
        if not any(share for share, _ in outcomes.values()):
            self.sandbox.require()  # a sandbox that fails must not cost points
        file.write_text(json.dumps(outcomes), encoding="utf-8")
        return outcomes


def capped(exercise: Exercise, outcomes: Outcomes) -> list[Result]:
    """Computes the points of an exercise's checks from {check id: (share, message)}, rounded to hundredths."""
    def in_hundredths(points: float) -> float:
        return round(points + 1e-9, 2)

    results = []
    for check in exercise.check:
        share, message = outcomes[check.id]
        results.append(Result(check, in_hundredths(share * check.points), message))
    hidden = [result for result in results if not result.check.is_public]
    reached = sum(result.points for result in hidden) / sum(result.check.points for result in hidden) if hidden else 1
    for result in results:
        most = in_hundredths(reached * result.check.points)
        if result.check.is_public and result.points > most:
            note = (f"{result.points:g} of {result.check.points:g} points, limited to the fraction that the hidden checks of this "
                    "exercise earn")
            result.message = f"{result.message}; {note}" if result.message else note
            result.points = most
    return results


def results_json(assignment: Assignment, graded: Graded) -> dict[str, Any]:
    """Returns the results in Gradescope's format. Of a hidden check, students see only the points."""
    tests = [{"name": f"{result.check.id}: {result.check.description}", "score": result.points, "max_score": result.check.points,
              "output": result.message if result.check.is_public else "", "visibility": "visible"} for result in graded.results]
    output = "\n\n".join(graded.errors.values()) or f"{graded.points:g} of {assignment.points:g} points"
    return {"score": graded.points, "output": output, "stdout_visibility": "hidden", "tests": tests}


def feedback_text(assignment: Assignment, graded: Graded) -> str:
    """Returns the same results as text."""
    lines = [f"{assignment.title}: {graded.points:g} of {assignment.points:g} points"]
    for exercise in assignment.exercise:
        results = [result for result in graded.results if result.check in exercise.check]
        lines.append(f"\n{exercise.title}: {sum(result.points for result in results):g} of {exercise.points:g}")
        error = graded.errors.get(exercise.file, "")
        lines += [f"  {line}" for line in error.splitlines()]
        for result in results:
            lines.append(f"  {result.points:g} of {result.check.points:g}  {result.check.description} ({result.check.id})")
            if result.check.is_public and result.message and not error:
                lines.append(f"      {result.message}")
    return printable("\n".join(lines)) + "\n"


def teacher_text(graded: Graded) -> str:
    """Returns the messages of the hidden checks, for the teacher only."""
    return "".join(f"{result.points:g} of {result.check.points:g}  {result.check.id}  {result.message}".rstrip() + "\n"
                   for result in graded.results if not result.check.is_public)
