# SPDX-License-Identifier: GPL-3.0-or-later
"""Helpers that several verbs share: failures, files, other programs."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

TYPE_CHECKING = False  # Rules start faster without these modules.
if TYPE_CHECKING:
    from argparse import ArgumentParser
    from typing import Any

ENGINE = Path(__file__).resolve().parent.parent.parent  # with literate.sty, tools/, python/ and template/


class Failure(Exception):
    """Ends the verb with a message and an exit code: 1 for a failed comparison, 2 for bad input, 3 for a failed tool."""

    def __init__(self, message: str, code: int = 2) -> None:
        super().__init__(message)
        self.code = code


def nearest(name: str, known: list[str]) -> str:
    """Returns «, did you mean 'x'?» with the most similar known name, or an empty text."""
    from difflib import get_close_matches
    found = get_close_matches(name, known, n=1, cutoff=0.6)
    return f", did you mean '{found[0]}'?" if found else ""


def warn(message: str) -> None:
    """Prints a line on standard error, and continues."""
    print(message, file=sys.stderr, flush=True)


def write_if_changed(path: Path, text: str) -> bool:
    """Writes a file by renaming a complete one. A file that already has this text keeps its time stamp; then returns False."""
    data = text.encode()
    try:
        if path.read_bytes() == data:
            return False
    except FileNotFoundError:
        path.parent.mkdir(parents=True, exist_ok=True)
    write_bytes(path, data)
    return True


def write_bytes(path: Path, data: bytes) -> None:
    """Writes a file by renaming a complete one into place."""
    part = path.with_name(f".{path.name}.part")
    try:
        part.write_bytes(data)
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


def file_time(folder: Path) -> int:
    """Returns the time stamp of a file written into this folder now, in nanoseconds."""
    probe = folder / ".now"
    probe.touch()
    return probe.stat().st_mtime_ns


def date_back(paths: list[Path], start: int) -> None:
    """Sets the time stamp of files written after `start` to `start`. A source saved while the rule ran is then newer than the
    result, and Ninja runs the rule again."""
    for path in paths:
        if path.stat().st_mtime_ns > start:
            os.utime(path, ns=(start, start))


def sha256(path: Path) -> str:
    """Returns the SHA-256 of a file as hexadecimal digits."""
    import hashlib
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def tool(name: str, package: str = "") -> str:
    """Returns the path of a program. Fails with the name of its Debian package if it is not installed."""
    found = shutil.which(name)
    if not found:
        raise Failure(f"{name} is not installed (Debian package {package or name})", 3)
    return found


def git(folder: Path, *arguments: str) -> str | None:
    """Returns the output of git, or None if it fails: no repository, no commit, no git."""
    try:
        run = subprocess.run(["git", "--no-optional-locks", *arguments], cwd=folder, capture_output=True, text=True,
                             errors="surrogateescape")
    except FileNotFoundError:
        return None
    return run.stdout.strip() if run.returncode == 0 else None


def quiet_run(command: list[str], what: str, **options: Any) -> None:
    """Runs a long command, and prints its output only if it fails."""
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                         **options)
    if run.returncode:
        raise Failure(f"{run.stdout.rstrip()}\n{what} failed", 3)


def parser(verb: str, docstring: str | None) -> ArgumentParser:
    """Returns an argument parser whose help is the docstring of the verb's module, with the examples at the end."""
    from argparse import ArgumentParser, RawDescriptionHelpFormatter
    what, _, examples = (docstring or "").partition("\nexamples:")
    return ArgumentParser(f"literate {verb}", description=what.strip(), epilog=f"examples:{examples}".rstrip(),
                          formatter_class=RawDescriptionHelpFormatter, allow_abbrev=False)
