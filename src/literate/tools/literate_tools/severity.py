# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants faults in a copy of the project, one at a time, and computes. A fault turns a claim if it changes the verdict:
severity.csv and severity.tex beside the prose record this, and \\claimledger prints it. A claim that no fault turns could not
have failed. With --tests it runs the tests instead, and lists the faults that no test detects.

The list has one line for each fault: id | file | before | after | what is wrong [| test]. The text before must occur in the file
exactly once.

examples:
  literate severity build/mypaper.json
  literate severity build/mypaper.json --only quarter-angle
  literate severity build/mypaper.json --faults others.txt --build 'cmake -S . -B b && cmake --build b' \\
    --tests 'ctest --test-dir b -R "$TEST"'
"""

import csv
import io
import os
import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from literate_tools.common import Failure, git, parser, quiet_run, write_if_changed
from literate_tools.settings import Settings, configure, read_results, read_settings


@dataclass(frozen=True)
class Fault:
    """One line of the list."""

    id: str
    file: str
    before: str
    after: str
    wrong: str
    test: str = ""


def run(arguments: list[str]) -> int:
    """Plants the faults and records their effect. Returns 1 if a fault does not compile, or if no test detects it."""
    arguments_of = parser("severity", __doc__)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("--faults", type=Path, metavar="FILE", help="the list (the paper's FAULTS)")
    arguments_of.add_argument("--only", metavar="ID", help="plant only this fault, and record nothing")
    arguments_of.add_argument("--build", default="true", metavar="COMMAND", help="builds the tests, in the copy")
    arguments_of.add_argument("--tests", metavar="COMMAND", help="runs them; $TEST is the last field of the line")
    given = arguments_of.parse_args(arguments)
    settings = read_settings(given.settings)
    file = given.faults or Path(settings.faults)
    if not file.name:
        raise Failure("the paper has no FAULTS in literate_add_paper: give --faults")
    chosen = [fault for fault in read_faults(file) if given.only in (None, fault.id)]
    if not chosen:
        raise Failure(f"{settings.shown(file)}: there is no fault '{given.only}'" if given.only else f"{file}: it is empty")
    copy = settings.output / "severity" / "source"
    mirror(settings, copy)
    for fault in chosen:
        planted(copy, fault)  # fails for a wrong line before anything is built
    if given.tests:
        return against_tests(copy, chosen, given.build, given.tests)
    found = against_claims(settings, copy, chosen)
    if not given.only and not given.faults:
        record(settings, chosen, found)
    return 1 if "does not compile" in found.values() else 0


def read_faults(file: Path) -> list[Fault]:
    """Reads the list of faults."""
    faults = []
    for number, line in enumerate(file.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        fields = [field.strip() for field in re.split(r"(?<=\s)\|(?=\s|$)", line)]
        if len(fields) not in (5, 6) or not all(fields[:3]):
            raise Failure(f"{file.name}:{number}: needs id | file | before | after | what is wrong")
        faults.append(Fault(*fields))
    return faults


def mirror(settings: Settings, copy: Path) -> None:
    """Copies the project's tracked and new files, and removes all others. Equal files keep their time stamps."""
    listed = git(settings.source, "ls-files", "-z", "--cached", "--others", "--exclude-standard")
    paths = [settings.source / name for name in listed.split("\0")] if listed is not None else [
        path for path in settings.source.rglob("*") if not path.is_relative_to(settings.build)]
    files = {copy / path.relative_to(settings.source): path for path in paths if path.is_file()}
    for path in copy.rglob("*"):
        if path.is_file() and path not in files:
            path.unlink()
    for target, source in files.items():
        if not target.exists() or target.read_bytes() != source.read_bytes():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)


def planted(copy: Path, fault: Fault) -> str:
    """Returns the text of the file with the fault."""
    path = copy / fault.file
    if not path.is_file():
        raise Failure(f"fault '{fault.id}': there is no file {fault.file}")
    text = path.read_text()
    if (count := text.count(fault.before)) != 1:
        raise Failure(f"fault '{fault.id}': {fault.file} has “{fault.before}” {count} times, not once")
    return text.replace(fault.before, fault.after)


def against_claims(settings: Settings, copy: Path, faults: list[Fault]) -> dict[str, str]:
    """Returns, for each fault, the claims that it turns, or what else happens."""
    build, output = copy.parent / "build", copy.parent / "output"
    configure(settings, copy, build, output)
    quiet_run(["ninja", "-C", str(build), f"{settings.name}-results"], "computing without a fault")
    right = verdicts(output)
    found = {}
    for fault in faults:
        found[fault.id] = with_fault(copy, fault, lambda: turned(settings, build, output, right))
        print(f"{fault.id}: {found[fault.id]}", flush=True)
    return found


def with_fault(copy: Path, fault: Fault, action: Callable[[], str]) -> str:
    """Runs an action while the fault is in the file."""
    path = copy / fault.file
    right = path.read_text()
    path.write_text(planted(copy, fault))
    try:
        return action()
    finally:
        path.write_text(right)


def turned(settings: Settings, build: Path, output: Path, right: dict[str, str]) -> str:
    """Builds the results with a fault and returns the claims and checks whose verdict changes."""
    ran = subprocess.run(["ninja", "-C", str(build), f"{settings.name}-results"], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, errors="replace")
    if ran.returncode:
        # If the failed rule did not call `literate compute`, it was the compiler's.
        failed = ran.stdout[ran.stdout.find("FAILED:"):].splitlines()
        return "stops the computation" if any(" compute " in line for line in failed[:2]) else "does not compile"
    now = verdicts(output)
    names = [name for name in right if now.get(name) != right[name]] + [name for name in now if name not in right]
    return " ".join(names) if names else "nothing"


def verdicts(output: Path) -> dict[str, str]:
    """Returns the verdict of each claim, and of each check as «check:id»."""
    results = read_results(output / "generated" / "results.json")
    return {name: claim["verdict"] for name, claim in results["claims"].items()} | {
        f"check:{name}": str(check["passed"]) for name, check in results["checks"].items()}


def record(settings: Settings, faults: list[Fault], found: dict[str, str]) -> None:
    """Writes severity.csv and severity.tex beside the prose."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["fault", "file", "what is wrong", "turns"])
    table.writerows([fault.id, fault.file, fault.wrong, found[fault.id]] for fault in faults)
    claims = list(read_results(settings.generated / "results.json")["claims"])
    turning = {claim: [fault.id for fault in faults if claim in found[fault.id].split()] for claim in claims}
    lines = [f"\\LiterateTurned{{{claim}}}{{{', '.join(ids) or 'none'}}}\n" for claim, ids in turning.items()]
    write_if_changed(settings.document / "severity.csv", text.getvalue())
    if write_if_changed(settings.document / "severity.tex", "".join(lines)):
        (settings.output / "typeset.stamp").unlink(missing_ok=True)  # Ninja does not know a file that was not there
    idle = [claim for claim, ids in turning.items() if not ids]
    print(f"{len(faults)} faults turn {len(claims) - len(idle)} of {len(claims)} claims"
          + (f"; not turned: {', '.join(idle)}" if idle else ""))


def against_tests(copy: Path, faults: list[Fault], build: str, tests: str) -> int:
    """Runs the tests with each fault and lists the faults that none detects."""
    def outcome(test: str = "") -> str:
        for command, failure in ((build, "does not compile"), (tests, "noticed")):
            if subprocess.run(command, shell=True, cwd=copy, env=os.environ | {"TEST": test}, capture_output=True).returncode:
                return failure
        return "not noticed"
    if (without := outcome()) != "not noticed":
        raise Failure(f"without a fault the copy {'does not compile' if without != 'noticed' else 'fails its tests'}", 3)
    bad = 0
    for fault in faults:
        result = with_fault(copy, fault, lambda: outcome(fault.test))
        bad += result != "noticed"
        print(f"{fault.id}: {result}" + (f" ({fault.wrong})" if result != "noticed" else ""), flush=True)
    return 1 if bad else 0
