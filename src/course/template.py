# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the students' project from template files that contain the solution between markers.

A marker is a comment on a separate line (//, #, % or <!-- -->):

    // BEGIN SOLUTION             in the handout, "YOUR SOLUTION HERE" and the stubs replace the lines up to END SOLUTION
    // STUB: return 0;
    // END SOLUTION
    // EACH EXERCISE: @file@      one line per exercise, with @id@, @file@, @number@, @title@, @points@
    // EACH PUBLIC CHECK: @check@ one line per public check
"""
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from assignment import Assignment
from errors import BadInput

MARKER = re.compile(r"(?P<indent>\s*)(?P<sign>//|#|%|<!--) ?(?P<words>BEGIN SOLUTION|END SOLUTION|STUB:|EACH [A-Z ]+:) ?"
                    r"(?P<rest>.*?)(?P<end> ?-->)?$")
LOOKS_LIKE_A_MARKER = re.compile(r"\b(begin|end)[ _-]+solutions?\b", re.IGNORECASE)


@dataclass
class Divided:
    """A file of the template: its text in the handout and in the solution."""
    handout: str = ""
    solution: str = ""
    secrets: list[tuple[int, str]] = field(default_factory=list)  # the lines of the solution, (line number, text)


def divide(text: str, name: str | Path, lists: dict[str, list[dict[str, Any]]]) -> Divided:
    """Divides a file at its markers. `lists` contains the words for EACH lines: {"EXERCISE": [{"id": …}, …]}."""
    result = Divided()
    begin_line = None
    for number, line in enumerate(text.splitlines(keepends=True), 1):
        marker = MARKER.fullmatch(line.rstrip("\r\n"))
        if not marker:
            if LOOKS_LIKE_A_MARKER.search(line):
                raise BadInput(f"{name}:{number}: this looks like a marker but is not one: {line.strip()}")
            result.solution += line
            if not begin_line:
                result.handout += line
            elif line.strip():
                result.secrets.append((number, line.strip()))
            continue
        indent, sign, words, rest = marker["indent"], marker["sign"], marker["words"], marker["rest"]
        if words in ("END SOLUTION", "STUB:") and not begin_line or words == "BEGIN SOLUTION" and begin_line:
            raise BadInput(f"{name}:{number}: the marker {words} is not expected here")
        if words == "BEGIN SOLUTION":
            begin_line = number
            result.handout += f"{indent}{sign} YOUR SOLUTION HERE{' -->' if sign == '<!--' else ''}\n"
        elif words == "END SOLUTION":
            begin_line = None
        elif words == "STUB:":
            result.handout += f"{indent}{rest}\n"
        else:
            for entry in lists.get(words[5:-1], []):
                expanded = indent + re.compile(r"@(\w+)@").sub(lambda word: str(entry[word[1]]), rest) + "\n"
                result.handout += expanded
                result.solution += expanded
    if begin_line:
        raise BadInput(f"{name}:{begin_line}: BEGIN SOLUTION without END SOLUTION")
    return result


def project(assignment: Assignment, folder: Path, sources: Path) -> dict[str, Divided]:
    """Makes the students' project, {name: Divided}: the files of the template and copies of the provided files."""
    exercises = [{"id": exercise.id, "file": exercise.file, "number": number, "title": exercise.title,
                  "points": f"{exercise.points:g}"} for number, exercise in enumerate(assignment.exercise, 1)]
    lists: dict[str, list[dict[str, Any]]] = {
        "EXERCISE": exercises, "PUBLIC CHECK": [{"check": check.id} for check in assignment.checks if check.is_public]}
    files = {}
    for path in sorted((folder / "template").rglob("*")):
        if path.is_file():
            files[path.relative_to(folder / "template").as_posix()] = divide(path.read_text(encoding="utf-8"), path, lists)
    for pattern in assignment.provided:
        for path in sorted(sources.glob(pattern)):
            text = path.read_text(encoding="utf-8")
            files[f"provided/{path.relative_to(sources).as_posix()}"] = Divided(text, text)
    for exercise in assignment.exercise:
        if exercise.file not in files:
            raise BadInput(f"{folder / 'template' / exercise.file}: the file of exercise '{exercise.id}' does not exist")
    return files
