# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the names that the document used, which LaTeX recorded, and those in its text."""

import os
import re
from dataclasses import dataclass
from pathlib import Path

from literate_tools.common import Failure
from literate_tools.settings import Settings

# The commands of literate.sty that take a name, and the part of results.json with this name.
NAMED = {"val": "values", "rawval": "values", "tab": "tables", "fig": "figures", "claim": "claims", "statement": "claims",
         "ifflag": "flags"}
NAME = re.compile(rf"\\({'|'.join(NAMED)})\s*(?:\[[^\]]*\])?\s*\{{([^{{}}]*)\}}")


@dataclass(frozen=True)
class Use:
    """One use of a name, with its place relative to the project."""

    kind: str
    name: str
    place: str


def read_uses(settings: Settings) -> list[Use]:
    """Returns the distinct uses in NAME.uses, in the order of the document."""
    path = settings.latex / f"{settings.name}.uses"
    if not path.exists():
        raise Failure(f"{path}: there is no such file; build the paper first")
    lines = [line.split("\t") for line in path.read_text(errors="replace").splitlines()]
    lines = [fields for fields in lines if len(fields) == 4]
    statements = {name: (file, line) for kind, name, file, line in lines if kind == "statement"}
    found: dict[Use, None] = {}
    for kind, name, file, line in lines:
        if file == "statement":  # a sentence that the ledger prints
            file, line = statements.get(line, ("", "0"))
        found[Use(kind, name, f"{shown(settings, file)}:{line}")] = None
    return list(found)


def shown(settings: Settings, file: str) -> str:
    """Returns the path of a file that LaTeX read, relative to the project. The main file has no name here."""
    name = file.strip("/").removeprefix("./") or settings.main
    path = settings.document / name
    if not path.suffix:
        path = path.with_suffix(".tex")
    return settings.shown(Path(os.path.normpath(path)))


def document_texts(settings: Settings) -> dict[Path, str]:
    """Returns the texts of the document without comments: the files that LaTeX read, and those that they include in branches
    of \\ifflag that are not taken."""
    from literate_tools.typeset import recorded
    files = [path for path in recorded(settings) if path.is_relative_to(settings.source) and path.suffix == ".tex"
             and not path.is_relative_to(settings.output)]
    texts: dict[Path, str] = {}
    while files:
        path = files.pop(0)
        if path not in texts and path.is_file():
            texts[path] = without_comments(path.read_text(errors="replace"))
            names = re.findall(r"\\(?:input|include)\s*\{([^{}]+)\}", texts[path])
            files += [(settings.document / name).with_suffix(".tex") for name in names]
    return dict(sorted(texts.items()))


def without_comments(text: str) -> str:
    """Returns LaTeX with blanks in place of comments."""
    return re.sub(r"(?<!\\)((?:\\\\)*)%.*", lambda match: match[1] + " " * (len(match[0]) - len(match[1])), text)


def names_in(text: str) -> list[tuple[str, str, int]]:
    """Returns command, name and line of each use in a text without comments."""
    return [(match[1], match[2], text.count("\n", 0, match.start()) + 1) for match in NAME.finditer(text)]
