# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a PDF in which latexdiff marks the changes of the prose, including those of the printed values."""

import io
import os
import re
import shutil
import subprocess
import tarfile
from dataclasses import replace
from pathlib import Path

from literate_tools.common import Failure, git, tool
from literate_tools.settings import Settings, read_results
from literate_tools.typeset import run_latex
from literate_tools.uses import without_comments


def write_marked_pdf(settings: Settings, since: str, earlier: Path) -> None:
    """Writes NAME.changes.pdf; `earlier` is the folder with the results of that commit."""
    tool("latexdiff")
    folder = settings.output / "marked"
    shutil.rmtree(folder, ignore_errors=True)
    prose_of_commit(settings, since, folder / "old")
    shutil.copytree(settings.document, folder / "new", ignore=shutil.ignore_patterns(".git", "build"))
    for state, generated in (("old", earlier), ("new", settings.generated)):
        expand_all(folder / state, generated)
    marked = subprocess.run(["latexdiff", "--type=CFONT", "--flatten", "--append-safecmd=LiteratePrinted", f"old/{settings.main}",
                             f"new/{settings.main}"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if marked.returncode:
        raise Failure(f"latexdiff failed:\n{marked.stderr.decode(errors='replace')}", 3)
    (folder / "new" / "marked.tex").write_bytes(b"\\providecommand\\LiteratePrinted[1]{#1}%\n" + marked.stdout)
    os.symlink(settings.generated, folder / "generated")
    # The settings of the paper with a different folder.
    pdf = run_latex(replace(settings, name=f"{settings.name}.changes", document=folder / "new", main="marked.tex", output=folder))
    os.replace(pdf, settings.output / pdf.name)
    print(settings.output / pdf.name)


def prose_of_commit(settings: Settings, since: str, folder: Path) -> None:
    """Writes the document's folder of a commit."""
    root, below = git(settings.document, "rev-parse", "--show-toplevel"), git(settings.document, "rev-parse", "--show-prefix")
    archive = subprocess.run(["git", "archive", f"{since}:{below.rstrip('/')}"], cwd=root, capture_output=True)
    if archive.returncode:
        raise Failure(f"{since} has no folder {below}: {archive.stderr.decode(errors='replace').strip()}")
    with tarfile.open(fileobj=io.BytesIO(archive.stdout)) as tar:
        tar.extractall(folder)


def expand_all(document: Path, generated: Path) -> None:
    """Replaces values and flags in all .tex files of a folder by their printed text."""
    values = printed_values((generated / "values.tex").read_text())
    flags = {name: flag["value"] for name, flag in read_results(generated / "results.json")["flags"].items()}
    for path in document.rglob("*.tex"):
        path.write_text(expand(path.read_text(errors="surrogateescape"), values, flags), errors="surrogateescape")


def printed_values(text: str) -> dict[str, str]:
    """Returns the printed text of each «key» and «key[digits]» in values.tex."""
    values = {}
    for line in text.splitlines():
        command, *given = braced(line)
        if command == r"\LiterateValue":
            values[given[0]] = given[1]
        elif command == r"\LiterateRounded":
            values[f"{given[0]}[{given[1]}]"] = given[2]
    return values


def expand(text: str, values: dict[str, str], flags: dict[str, bool]) -> str:
    """Returns a text with each \\val replaced by its value and each \\ifflag by the branch that is taken."""
    text = without_comments(text)
    while match := re.search(r"\\ifflag\s*\{([^{}]*)\}", text):
        _, yes, no = braced(text[match.end():], 2)
        taken = yes if flags.get(match[1]) else no
        length = text.index("{", match.end())
        length = closing(text, text.index("{", closing(text, length)))
        text = text[:match.start()] + taken + text[length:]

    def value(match: re.Match) -> str:
        printed = values.get(f"{match[2]}[{match[1]}]" if match[1] else match[2], values.get(match[2]))
        return match[0] if printed is None else rf"\LiteratePrinted{{{printed}}}"
    return re.sub(r"\\val\s*(?:\[(\d+)\])?\s*\{([^{}]*)\}", value, text)


def braced(text: str, most: int = 9) -> list[str]:
    """Returns the text before the first brace, and the arguments in braces that follow."""
    at = text.find("{")
    parts = [text[:at].strip()]
    while 0 <= at < len(text) and text[at] == "{" and len(parts) <= most:
        end = closing(text, at)
        parts.append(text[at + 1:end - 1])
        at = end + len(text[end:]) - len(text[end:].lstrip())
    return parts


def closing(text: str, at: int) -> int:
    """Returns the position after the brace that closes the one at `at`."""
    depth = 0
    for match in re.compile(r"\\.|[{}]", re.S).finditer(text, at):
        depth += {"{": 1, "}": -1}.get(match[0], 0)
        if depth == 0:
            return match.end()
    raise Failure("a brace is not closed")
