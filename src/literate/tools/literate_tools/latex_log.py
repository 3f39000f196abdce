# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads errors and warnings from LaTeX's log, with the file and line where the author can fix them."""

import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from literate_tools.common import nearest
from literate_tools.settings import Settings, read_results

COMMANDS = ("val", "rawval", "tab", "fig", "claim", "statement", "quoted", "ifflag", "claimledger", "attachdata", "papercase",
            "papercommit", "paperday")
MOST_ERRORS = 10
PARTS = {"value": "values", "flag": "flags", "table": "tables", "figure": "figures", "claim": "claims"}


@dataclass(frozen=True)
class Error:
    """An error of LaTeX. The file is absolute, or None if LaTeX gives none."""

    file: Path | None
    line: int
    message: str
    is_in_auxiliary_file: bool  # the file is in OUTPUT/latex


def log_of(settings: Settings) -> str:
    """Returns the log of the last run; empty if LaTeX did not start."""
    path = settings.latex / f"{settings.name}.log"
    return path.read_text(errors="replace") if path.exists() else ""


def errors(settings: Settings) -> list[Error]:
    """Returns the distinct errors in the log, in order."""
    found: dict[Error, None] = {}
    lines = log_of(settings).splitlines()
    for number, line in enumerate(lines):
        placed = re.match(r"(.+?):(\d+): (?! *==>|Emergency)(.*)", line)
        bare = re.match(r"! (?! *==>|Emergency)(.*)", line)
        if not (match := placed or bare):
            continue
        message = match.groups()[-1].removeprefix("Package literate Error: ").removesuffix(".")
        if bare:  # for a missing file LaTeX prints the place only when it stops
            placed = next(filter(None, (re.match(r"(.+?):(\d+): Emergency stop", later) for later in lines[number:])), None)
        file = Path(os.path.realpath(settings.document / placed[1])) if placed else None
        if file and not file.is_file():
            continue
        if message.startswith("Undefined control sequence"):  # its name ends the next line
            name = re.search(r"\\([A-Za-z@]+|.) ?$", lines[number + 1] if number + 1 < len(lines) else "")
            message = f"undefined command {name[0].strip()}" if name else message
        error = Error(file, int(placed[2]) if placed else 0, message, bool(file and file.is_relative_to(settings.latex)))
        found.setdefault(error)
    return list(found)


def report(settings: Settings, all_errors: list[Error]) -> list[str]:
    """Returns the messages for the author. Further errors on the line of an unknown name are consequences of it, and omitted."""
    unknown = {(error.file, error.line) for error in all_errors if error.message.startswith("unknown ")}
    kept = [error for error in all_errors
            if error.message.startswith("unknown ") or (error.file, error.line) not in unknown]
    results = read_results(settings.generated / "results.json")
    lines = [f"{place(settings, results, error)}{error.message}{suggestion(results, error.message)}" for error in kept]
    lines = list(dict.fromkeys(lines))
    commands = {f"undefined command \\{name}" for name in COMMANDS}
    if not uses_package(settings) and any(error.message in commands for error in all_errors):
        lines = [f"{first_command(settings)}: \\usepackage{{literate}} is missing"]
    more = len(lines) - MOST_ERRORS
    return lines[:MOST_ERRORS] + ([f"and {more} more errors, which may follow from these"] if more > 0 else [])


def place(settings: Settings, results: dict[str, Any], error: Error) -> str:
    """Returns where to fix an error: a line of the prose, or the line of code that registered the printed entry."""
    if error.file is None:
        return f"{settings.shown(settings.document / settings.main)}: "
    if not error.file.is_relative_to(settings.generated):
        return f"{settings.shown(error.file)}:{error.line}: "
    kind, name = error.file.parent.name, error.file.stem
    if kind == "tables" and name in results["tables"]:
        return f"{results['tables'][name]['place']}: table '{name}': "
    for script in settings.scripts:
        if error.file.parent.parent.name == "figures" and script.stem == name:
            return f"{settings.shown(script)}: figure '{name}': "
    lines = error.file.read_text().splitlines()[:error.line]  # an entry begins above its criteria
    keys = (re.match(r"\\Literate(?:Value|Rounded|Entry)\{([^}]*)\}", line) for line in reversed(lines))
    key = next(filter(None, keys), None)
    found = key and (results["values"].get(key[1]) or results["claims"].get(key[1]))
    return f"{found['place']}: '{key[1]}': " if key and found else f"{settings.shown(error.file)}:{error.line}: "


def suggestion(results: dict[str, Any], message: str) -> str:
    """Returns the nearest known name for a message «unknown value 'x'»."""
    found = re.fullmatch(r"unknown (\w+) '(.*)'", message)
    return nearest(found[2], list(results[PARTS[found[1]]])) if found and found[1] in PARTS else ""


def uses_package(settings: Settings) -> bool:
    """Returns True if the last run read literate.sty."""
    fls = settings.latex / f"{settings.name}.fls"
    return fls.exists() and "literate.sty" in fls.read_text(errors="replace")


def first_command(settings: Settings) -> str:
    """Returns the place of the first command of literate.sty in the main file."""
    main = settings.document / settings.main
    for number, line in enumerate(main.read_text(errors="replace").splitlines(), 1):
        if re.search(rf"\\({'|'.join(COMMANDS)})\b", line.partition("%")[0]):
            return f"{settings.shown(main)}:{number}"
    return settings.shown(main)


def warnings(settings: Settings) -> list[str]:
    """Returns the last run's warnings about visible defects: «??», repeated labels, missing characters, wide lines."""
    file, outer = settings.main, []
    found: dict[str, None] = {}
    for line in log_of(settings).splitlines():
        if line.startswith("literate: reading "):
            outer.append(file)
            file = line.removeprefix("literate: reading ").removeprefix("/").removeprefix("./")
        elif line.startswith("literate: read") and outer:
            file = outer.pop()
        elif match := re.match(r"(?:LaTeX|Package \w+) Warning: (Reference|Citation) [`'](.*?)'.* undefined.* line (\d+)", line):
            found[f"{shown(settings, file)}:{match[3]}: undefined {match[1].lower()} '{match[2]}'"] = None
        elif match := re.match(r"LaTeX Warning: Label `(.*?)' multiply defined", line):
            found[f"{settings.shown(settings.document / settings.main)}: label '{match[1]}' is defined more than once"] = None
        elif match := re.match(r"Missing character: There is no (\S+)", line):
            found[f"{shown(settings, file)}: the font has no character {match[1]}"] = None
        elif match := re.match(r"Overfull \\hbox \(([\d.]+)pt too wide\).* lines? (\d+)", line):
            if float(match[1]) > 1:
                found[f"{place_of_line(settings, file, int(match[2]))}a line is {match[1]}pt too wide"] = None
    return list(found)


def place_of_line(settings: Settings, file: str, line: int) -> str:
    """Returns where to fix a line that LaTeX read. Generated lines are fixed in the code."""
    if not file.startswith("generated/"):
        return f"{shown(settings, file)}:{line}: "
    return place(settings, read_results(settings.generated / "results.json"), Error(settings.output / file, line, "", False))


def shown(settings: Settings, file: str) -> str:
    """Returns the path of a file that LaTeX read, relative to the project."""
    path = settings.document / file
    if not path.is_file() and path.with_name(path.name + ".tex").is_file():
        path = path.with_name(path.name + ".tex")
    return settings.shown(Path(os.path.normpath(path)))


def bibtex_warnings(settings: Settings) -> list[str]:
    """Returns the warnings of BibTeX, such as a missing entry."""
    text = (settings.latex / f"{settings.name}.blg").read_text(errors="replace")
    return [f"bibtex: {line.removeprefix('Warning--')}" for line in text.splitlines() if line.startswith("Warning--")]
