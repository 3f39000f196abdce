# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs Ninja in the folder build/ and prints what matters: one changing line on a terminal, and the messages of a failed rule
without its command.

examples:
  literate build mypaper
  literate build mypaper-figures --folder /tmp/build
"""

import re
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

from literate_tools.common import parser, tool

NOISE = re.compile(r"ninja: (build stopped|Entering directory|no work to do)"
                   r"|\[\d+/\d+\] (Re-checking globbed|look up the commit)")


def run(arguments: list[str]) -> int:
    """Returns Ninja's exit code: 1 if anything failed."""
    arguments_of = parser("build", __doc__)
    arguments_of.add_argument("targets", nargs="*", help="what to build (everything)")
    arguments_of.add_argument("--folder", type=Path, default=Path("build"), help="CMake's folder (build)")
    given = arguments_of.parse_args(arguments)
    ninja = [tool("ninja", "ninja-build"), "-C", str(given.folder)]
    # CMake runs again if a script is new or a CMakeLists.txt changed. Only its errors matter.
    cmake = subprocess.run([*ninja, "build.ninja"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if cmake.returncode:
        show(cmake.stdout.splitlines(), on_terminal=False)
        return cmake.returncode
    # Rules that print while they run, such as long computations, write to standard error.
    with subprocess.Popen([*ninja, *given.targets], stdout=subprocess.PIPE, text=True, errors="replace") as running:
        show(running.stdout or (), sys.stdout.isatty())
    return running.returncode


def show(lines: Iterable[str], on_terminal: bool) -> None:
    """Prints Ninja's output line by line."""
    status, is_command = False, False
    for line in lines:
        line = line.rstrip("\n")
        if is_command or NOISE.match(line):
            is_command = False
        elif line.startswith("FAILED: "):
            is_command = True  # its command is the next line
        else:
            is_status = on_terminal and re.match(r"\[\d+/\d+\] ", line)
            print("\r\x1b[K" * status + line, end="" if is_status else "\n", flush=True)
            status = bool(is_status)
    if status:
        print("\r\x1b[K", end="", flush=True)
