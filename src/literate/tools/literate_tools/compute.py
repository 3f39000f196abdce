# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program of a paper, or its script and literate-results, which writes the folder generated/."""

import os
import signal
import subprocess
import sys
from pathlib import Path

from literate_tools.common import ENGINE, Failure, date_back, file_time, sha256, write_if_changed
from literate_tools.settings import Settings, read_settings


def run(arguments: list[str]) -> int:
    """Computes the paper's main case. A failed claim ends the build only after the PDF."""
    settings = read_settings(arguments[0])
    settings.generated.mkdir(parents=True, exist_ok=True)
    start = file_time(settings.output)
    compute(settings, settings.case, settings.generated)
    for script in settings.scripts:
        write_inputs(settings.generated / "figures" / script.stem)
    date_back([*settings.generated.glob("*.*"), *settings.generated.glob("figures/*/inputs.txt")], start)
    return 0


def write_inputs(folder: Path) -> None:
    """Writes the checksums of the files that gnuplot reads for one figure. Ninja cannot know their names in advance."""
    files = [*folder.glob("data.gp"), *sorted(folder.glob("*.csv"))]
    write_if_changed(folder / "inputs.txt", "".join(f"{sha256(file)} {file.name}\n" for file in files))


def compute(settings: Settings, case: Path, folder: Path) -> int:
    """Computes one case into a folder. Returns 1 if a check or claim failed; the folder is complete then."""
    folder.mkdir(parents=True, exist_ok=True)
    named = settings.shown(case)  # as messages name it
    if not settings.script:
        return finish(call([*settings.program, "compute", named, str(folder)], settings), folder)
    registered = folder.parent / "registered.json"
    registered.unlink(missing_ok=True)
    code = call([*settings.script, named, str(registered)], settings)
    if code == 2:  # bad input; the script printed its message
        sys.exit(2)
    if code:
        raise Failure(f"{script_name(settings)} ended with {ending(code)}", 3)
    if not registered.exists():
        raise Failure(f"{script_name(settings)} did not write the file named by its second argument", 3)
    return finish(call([settings.results_program, str(registered), str(folder), case.name], settings), folder)


def finish(code: int, folder: Path) -> int:
    """Accepts the exit codes 0 and 1, after which the folder is complete. For others the program printed a message."""
    if code < 0:
        raise Failure(f"{ending(code)} ended the program", 3)
    if code > 1:
        sys.exit(code)
    if not (folder / "results.json").exists():
        raise Failure(f"the program wrote no results and ended with {ending(code)}", 3)
    return code


def call(command: list[str], settings: Settings) -> int:
    """Runs one command in the project's folder, with a fixed locale and time zone."""
    environment = os.environ | {"LC_ALL": "C.UTF-8", "TZ": "UTC", "PYTHONDONTWRITEBYTECODE": "1", "PYTHONHASHSEED": "0"}
    others = os.environ.get("PYTHONPATH")
    environment["PYTHONPATH"] = f"{ENGINE / 'python'}{f':{others}' if others else ''}"
    try:
        with subprocess.Popen(command, cwd=settings.source, env=environment) as running:
            return wait(running, bool(settings.script))
    except FileNotFoundError:
        raise Failure(f"{command[0]}: there is no such program", 3) from None
    except PermissionError:
        raise Failure(f"{command[0]}: this is not a program that can be run", 3) from None


def wait(running: subprocess.Popen[bytes], is_script: bool) -> int:
    """Waits for a command and returns its exit code. For a script, a terminal shows the elapsed seconds."""
    seconds = 0
    while True:
        try:
            code = running.wait(1 if is_script and sys.stderr.isatty() else None)
        except subprocess.TimeoutExpired:
            seconds += 1
            print(f"\r{seconds} s ", end="", file=sys.stderr, flush=True)
            continue
        print("\r\x1b[K" if seconds else "", end="", file=sys.stderr, flush=True)
        return code


def ending(code: int) -> str:
    """Names an exit code or a signal."""
    return f"exit code {code}" if code >= 0 else f"signal {signal.Signals(-code).name}"


def script_name(settings: Settings) -> str:
    """Returns the script's file: the last word of its command that is a file."""
    files = [Path(word) for word in settings.script if Path(word).is_file()]
    return settings.shown(files[-1]) if files else settings.script[0]
