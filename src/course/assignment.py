# SPDX-License-Identifier: GPL-3.0-or-later
"""The assignment as report/assignment/assignment.toml describes it: exercises, checks, points, limits."""
import dataclasses
from dataclasses import dataclass
from pathlib import Path

from errors import BadInput


@dataclass(frozen=True)
class Check:
    id: str
    points: float
    visibility: str  # "public": students have its code; "hidden": they are told its points only
    says: str  # what it tests, for students

    @property
    def is_public(self):
        return self.visibility == "public"


@dataclass(frozen=True)
class Exercise:
    id: str  # its file is src/ID.cpp
    title: str
    builds_on: list  # ids of earlier exercises, whose functions its checks ask for too
    check: list

    @property
    def file(self):
        return f"src/{self.id}.cpp"

    @property
    def points(self):
        return round(sum(check.points for check in self.check), 2)


@dataclass(frozen=True)
class Limits:
    compile_seconds: int  # of processor time, for one file
    run_seconds: int  # of processor time, for all questions of an exercise
    submission_seconds: int  # that compiling, and questions without an answer, may take in all
    memory_mb: int  # of one process
    processes: int
    file_kb: int  # size of one submitted file


@dataclass(frozen=True)
class Assignment:
    title: str
    due: str  # as the sheet prints it
    points: float
    provided: list  # patterns of files below src of which the handout gets copies
    not_secret: list  # lines of the solution that anybody would write
    limits: Limits
    exercise: list

    @property
    def checks(self):
        return [check for exercise in self.exercise for check in exercise.check]

    def exercises_behind(self, exercise):
        """The ids of the exercises on which this one builds, directly or not."""
        behind = set(exercise.builds_on)
        for earlier in reversed(self.exercise):
            if earlier.id in behind:
                behind.update(earlier.builds_on)
        return behind


def made(kind, table, where):
    """A dataclass of a table with exactly its keys."""
    names = {field.name for field in dataclasses.fields(kind)}
    for key in table.keys() - names:
        raise BadInput(f"{where}: there is no key '{key}'")
    for key in names - table.keys():
        raise BadInput(f"{where}: the key '{key}' is missing")
    return kind(**table)


def from_table(table, where):
    """The assignment of a table as TOML or JSON give it. Points must add up; ids must be unique."""
    exercises = []
    for entry in table.get("exercise", []):
        checks = [made(Check, check, f"{where}: check '{check.get('id', '?')}'") for check in entry.get("check", [])]
        exercise = made(Exercise, entry | {"check": checks}, f"{where}: exercise '{entry.get('id', '?')}'")
        unknown = set(exercise.builds_on) - {earlier.id for earlier in exercises}
        if unknown:
            raise BadInput(f"{where}: exercise '{exercise.id}' builds on '{unknown.pop()}', which is no earlier exercise")
        exercises.append(exercise)
    limits = made(Limits, table.get("limits", {}), f"{where}: limits")
    assignment = made(Assignment, table | {"exercise": exercises, "limits": limits}, where)
    total = round(sum(exercise.points for exercise in exercises), 2)
    if total != assignment.points:
        raise BadInput(f"{where}: the checks have {total:g} points together, not {assignment.points:g}")
    return assignment


def read_toml(file):
    """The table of a TOML file. (Python 3.10, on Gradescope, has no tomllib; there is no TOML either.)"""
    import tomllib
    try:
        return tomllib.loads(Path(file).read_text(encoding="utf-8"))
    except OSError as error:
        raise BadInput(f"{file}: {error.strerror}") from None
    except (UnicodeError, tomllib.TOMLDecodeError) as error:
        raise BadInput(f"{file}: {error}") from None


def read(file):
    return from_table(read_toml(file), file)
