# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs gnuplot for one figure, in the folder of its data, and adds the author's file and line to its messages."""

import os
import re
import subprocess
import sys
from pathlib import Path

from literate_tools.common import Failure, date_back, file_time, tool
from literate_tools.settings import Settings, read_settings


def run(arguments: list[str]) -> int:
    """Draws the figure NAME of the paper's main case: literate draw SETTINGS NAME."""
    settings = read_settings(arguments[0])
    draw(settings, next(script for script in settings.scripts if script.stem == arguments[1]), settings.generated)
    return 0


def draw(settings: Settings, script: Path, generated: Path) -> None:
    """Writes figures/NAME/NAME.tex and .pdf. The program wrote data.gp there, which sets terminal, data and output."""
    name, shown = script.stem, settings.shown(script)
    folder = generated / "figures" / name
    folder.mkdir(parents=True, exist_ok=True)
    start = file_time(folder)
    outputs = [folder / f"{name}.tex", folder / f"{name}.pdf"]
    for output in outputs:
        output.unlink(missing_ok=True)
    if not (folder / "data.gp").exists():  # a case need not register every figure
        for output in outputs:
            output.touch()
        return
    style = script.with_name("style.gp")
    files = ["data.gp", *([str(style)] if style.exists() else []), str(script)]
    environment = os.environ | {"LC_ALL": "C.UTF-8", "TZ": "UTC"}
    ran = subprocess.run([tool("gnuplot", "gnuplot-nox"), "-d", *files], cwd=folder, env=environment,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    printed = with_places(ran.stdout, settings)
    print(printed, end="", file=sys.stderr)
    if ran.returncode or re.search(r"\bwarning\b", printed, re.IGNORECASE):
        raise Failure(f"{shown}: gnuplot {'failed' if ran.returncode else 'warned'}", 3)
    if not all(output.exists() and output.stat().st_size for output in outputs):
        raise Failure(f"{shown}: gnuplot wrote no {name}.tex and {name}.pdf; the script must not change terminal and output", 3)
    date_back(outputs, start)


def with_places(printed: str, settings: Settings) -> str:
    """Writes gnuplot's «"/home/…/period.gp" line 4: …» as figures/period.gp:4: …, without its empty lines."""
    def place(match: re.Match[str]) -> str:
        return f"{settings.shown(Path(match[1]))}:{match[2]}: "
    lines = [line for line in printed.splitlines() if line.strip()]
    return "".join(re.sub(r'^\s*"([^"]*)",? line (\d+): ', place, line) + "\n" for line in lines)
