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

from errors import BadInput

MARKER = re.compile(r"(?P<indent>\s*)(?P<sign>//|#|%|<!--) ?(?P<words>BEGIN SOLUTION|END SOLUTION|STUB:|EACH [A-Z ]+:) ?"
                    r"(?P<rest>.*?)(?P<end> ?-->)?$")
LOOKS_LIKE_A_MARKER = re.compile(r"\b(begin|end)[ _-]+solutions?\b", re.IGNORECASE)


@dataclass
class Divided:
    """A file of the template: its text in the handout and in the solution."""
    handout: str = ""
    solution: str = ""
    secrets: list = field(default_factory=list)  # the lines of the solution, (line number, text)


def divide(text, name, lists):
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
        if words == "BEGIN SOLUTION":
            if begin_line:
                raise BadInput(f"{name}:{number}: BEGIN SOLUTION inside the solution that begins in line {begin_line}")
            begin_line = number
            result.handout += f"{indent}{sign} YOUR SOLUTION HERE{' -->' if sign == '<!--' else ''}\n"
        elif words == "END SOLUTION":
            if not begin_line:
                raise BadInput(f"{name}:{number}: END SOLUTION without BEGIN SOLUTION")
            begin_line = None
        elif words == "STUB:":
            if not begin_line:
                raise BadInput(f"{name}:{number}: STUB outside a solution")
            result.handout += f"{indent}{rest}\n"
        else:
            for entry in lists.get(words[5:-1], []):
                expanded = f"{indent}{expand(rest, entry, f'{name}:{number}')}\n"
                result.handout += expanded
                result.solution += expanded
    if begin_line:
        raise BadInput(f"{name}:{begin_line}: BEGIN SOLUTION without END SOLUTION")
    return result


def expand(text, entry, where):
    """Replaces each @word@ in a text by its entry."""
    def replaced(match):
        if match[1] not in entry:
            raise BadInput(f"{where}: @{match[1]}@ is not a word of this list")
        return str(entry[match[1]])
    return re.sub(r"@(\w+)@", replaced, text)


def project(assignment, folder, sources):
    """Makes the students' project, {name: Divided}: the files of the template and copies of the provided files."""
    exercises = [{"id": exercise.id, "file": exercise.file, "number": number, "title": exercise.title,
                  "points": f"{exercise.points:g}"} for number, exercise in enumerate(assignment.exercise, 1)]
    lists = {"EXERCISE": exercises,
             "PUBLIC CHECK": [{"check": check.id} for check in assignment.checks if check.is_public]}
    files = {}
    for path in sorted((folder / "template").rglob("*")):
        if path.is_file():
            files[path.relative_to(folder / "template").as_posix()] = divide(read_text(path), path, lists)
    for pattern in assignment.provided:
        for path in sorted(sources.glob(pattern)):
            text = read_text(path)
            files[f"provided/{path.relative_to(sources).as_posix()}"] = Divided(text, text)
    for exercise in assignment.exercise:
        if exercise.file not in files:
            raise BadInput(f"{folder / 'template' / exercise.file}: the file of exercise '{exercise.id}' does not exist")
    return files


def read_text(path):
    try:
        return Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeError) as error:
        raise BadInput(f"{path}: {error}") from None
