# SPDX-License-Identifier: GPL-3.0-or-later
"""The errors that end a command, each with a message for the user, and the way to call a tool and to report progress."""
import os
import subprocess
import sys
from pathlib import Path


class BadInput(Exception):
    """An argument or an input file is wrong: exit code 2."""


class ToolFailure(Exception):
    """A tool or the grader itself failed: exit code 3. This never costs a student points."""


class Disproved(Exception):
    """A claim about the handout does not hold: exit code 1."""


def run_tool(words: list[str], folder: str | Path, failure: type[Exception] = ToolFailure, /, **environment: str) -> str:
    """Runs a tool in a folder. Returns what it prints; raises `failure` with the end of it if the tool fails."""
    try:
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True, errors="replace", check=False,
                              env={**os.environ, "TMPDIR": str(folder), **environment})
    except OSError as error:
        raise ToolFailure(f"{words[0]}: {error.strerror}; run \"make setup course\"") from None
    output = done.stdout + done.stderr
    if done.returncode != 0:
        raise failure(f"{' '.join(words)} fails:\n{output.strip()[-3000:]}")
    return output


def progress(what: str, done: int = 0, total: int = 0) -> None:
    print(what + (f": {done} of {total}" if total else ""), file=sys.stderr)
