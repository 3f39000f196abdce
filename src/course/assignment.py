# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads report/assignment/assignment.toml: the exercises, checks, points and limits."""
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from errors import BadInput

Kind = TypeVar("Kind")


@dataclass(frozen=True)
class Check:
    id: str
    points: float
    visibility: str  # "public": students have its code; "hidden": students see only its points
    description: str  # what it tests, for students

    @property
    def is_public(self) -> bool:
        return self.visibility == "public"


@dataclass(frozen=True)
class Exercise:
    id: str  # its file is src/ID.cpp
    title: str
    builds_on: list[str]  # ids of earlier exercises whose functions its checks also call
    check: list[Check]

    @property
    def file(self) -> str:
        return f"src/{self.id}.cpp"

    @property
    def points(self) -> float:
        return round(sum(check.points for check in self.check), 2)


@dataclass(frozen=True)
class Limits:
    compile_seconds: int  # of processor time, for one file
    run_seconds: int  # of processor time, for all questions of an exercise
    submission_seconds: int  # by the clock, for compiling and for all questions
    memory_mb: int  # of one process
    processes: int
    file_kb: int  # size of one submitted file


@dataclass(frozen=True)
class Assignment:
    title: str
    due: str  # printed on the sheet as it is
    points: float
    provided: list[str]  # patterns of files below src that are copied into the handout
    not_secret: list[str]  # lines of the solution that the handout may contain
    limits: Limits
    exercise: list[Exercise]

    @property
    def checks(self) -> list[Check]:
        return [check for exercise in self.exercise for check in exercise.check]

    def exercises_behind(self, exercise: Exercise) -> set[str]:
        """Returns the ids of all exercises that this one builds on, directly or indirectly."""
        behind = set(exercise.builds_on)
        for earlier in reversed(self.exercise):
            if earlier.id in behind:
                behind.update(earlier.builds_on)
        return behind


def dataclass_from(kind: type[Kind], table: dict[str, Any], where: str | Path) -> Kind:
    """Makes a dataclass from a table that has exactly its fields as keys."""
    try:
        return kind(**table)
    except TypeError as error:  # it names the key that is missing or unknown
        raise BadInput(f"{where}: {error}") from None


def from_table(table: dict[str, Any], where: str | Path) -> Assignment:
    """Makes an Assignment from a table read from TOML or JSON. Raises BadInput for wrong keys or points that do not add up."""
    exercises: list[Exercise] = []
    for entry in table.get("exercise", []):
        checks = [dataclass_from(Check, check, f"{where}: check '{check.get('id', '?')}'") for check in entry.get("check", [])]
        exercise = dataclass_from(Exercise, entry | {"check": checks}, f"{where}: exercise '{entry.get('id', '?')}'")
        unknown = set(exercise.builds_on) - {earlier.id for earlier in exercises}
        if unknown:
            raise BadInput(f"{where}: exercise '{exercise.id}' builds on '{unknown.pop()}', which is not an earlier exercise")
        exercises.append(exercise)
    limits = dataclass_from(Limits, table.get("limits", {}), f"{where}: limits")
    assignment = dataclass_from(Assignment, table | {"exercise": exercises, "limits": limits}, where)
    total = round(sum(exercise.points for exercise in exercises), 2)
    if total != assignment.points:
        raise BadInput(f"{where}: the points of all checks add up to {total:g}, not {assignment.points:g}")
    return assignment


def read_toml(file: Path) -> dict[str, Any]:
    import tomllib  # not at the top, because Python 3.10 on Gradescope does not have it
    try:
        return tomllib.loads(Path(file).read_text(encoding="utf-8"))
    except ValueError as error:
        raise BadInput(f"{file}: {error}") from None


def read(file: Path) -> Assignment:
    return from_table(read_toml(file), file)
