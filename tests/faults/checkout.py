# SPDX-License-Identifier: GPL-3.0-or-later
"""A copy of the checkout that may be broken: small report, the program as it is built, in its own place.

The copy is mounted over the checkout in a mount namespace of this process, so that every path in the build folder holds and
nothing is compiled.
"""

import hashlib
import os
import re
import shutil
import signal
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
# What a make is given at most, so that one that hangs is found out.
LIMIT = 300
ANNOUNCED = ["build/report/report.pdf", "build/report/manifest.json"]
# Built, but not for the report.
UNNEEDED = {"tests", "Testing", "halfspace", "halfspace-judge", "compile_commands.json"}


def run(*command, **options):
    return subprocess.run(command, check=True, **options)


def make_copy(folder):
    """Copies the checkout and what is built of the report into an empty folder, and gives it the small report."""
    folder.mkdir(parents=True)
    for entry in ROOT.iterdir():
        if entry.name != "build":
            run("cp", "-a", entry, folder)
    (folder / "build/release").mkdir(parents=True)
    for entry in (ROOT / "build/release").iterdir():
        if entry.name not in UNNEEDED and not entry.name.endswith(".unfinished"):
            run("cp", "-a", entry, folder / "build/release")
    shutil.rmtree(folder / "report/sections")
    (folder / "report/sections").mkdir()
    shutil.copy(HERE / "small.tex", folder / "report/report.tex")
    shutil.copy(HERE / "second.tex", folder / "report/sections/second.tex")
    (folder / "report/quotations.toml").write_text("")
    shutil.copy(HERE / "small.toml", folder / "report/ruggiero2001.toml")


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else None


@dataclass
class Outcome:
    """How a make ended."""

    status: int
    errors: str  # on standard error; or, if there is nothing, what it printed, as of a compiler

    def lines(self):
        """What it said on standard error, without warnings and make's own words."""
        lines = [line.strip() for line in self.errors.splitlines()]
        others = ("make: ***", "configure ", "compile ", "compute ", "draw ", "typeset ")
        return [line for line in lines if line and not line.startswith(others) and ": warning: " not in line]

    def said(self):
        """The line that tells the cause."""
        lines = [line for line in self.lines() if not line.endswith("; made again")] or self.lines()
        return lines[0] if lines else ""


def environment(**added):
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("MAKE", "MFLAGS", "GIT_", "CASE", "CALLER"))}
    return {**kept, "LC_ALL": "C", **added}


def start(*arguments, env=None, hears_interrupts=True):
    """Starts a make in a process group of its own; one that a script starts in the background hears no interrupts."""
    hears = "--default-signal=INT" if hears_interrupts else "--ignore-signal=INT"
    printed = tempfile.TemporaryFile("w+", errors="replace")
    process = subprocess.Popen(
        ["env", hears, "make", *arguments], cwd=ROOT, env=env or environment(), text=True, errors="replace",
        stdin=subprocess.DEVNULL, stdout=printed, stderr=subprocess.PIPE,
        start_new_session=True)
    process.printed = printed
    return process


def end(process):
    """Waits for a make; one that hangs is killed with its group, and has the status None."""
    try:
        _, errors = process.communicate(timeout=LIMIT)
        status = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        _, errors = process.communicate()
        status = None
    outcome = Outcome(status, errors)
    if status != 0 and not outcome.said():
        process.printed.seek(0)
        outcome = Outcome(status, process.printed.read())
    process.printed.close()
    return outcome


def make(*arguments, env=None):
    return end(start(*arguments, env=env))


def announced(case=None):
    """The SHA-256 of what the report is, of the paper's case or of another one."""
    return [sha256(path) for path in (announced_of(case) if case else [ROOT / name for name in ANNOUNCED])]


def is_whole_pdf():
    path = ROOT / ANNOUNCED[0]
    if not path.is_file():
        return False
    text = path.read_bytes()
    return text.startswith(b"%PDF-") and text.rstrip().endswith(b"%%EOF")


def announced_of(case):
    """Where PDF and manifest of a case are: another case than the paper's has a folder of its own."""
    if Path(case).samefile(ROOT / "report/ruggiero2001.toml"):
        return [ROOT / name for name in ANNOUNCED]
    name = "-" + Path(case).stem
    folder = re.sub(r"[^\w.-]", "_", name, flags=re.ASCII)
    if folder != name:
        folder += "-" + run("cksum", input=name + "\n", capture_output=True, text=True).stdout.split()[0]
    return [ROOT / name.replace("report/", f"report{folder}/", 1) for name in ANNOUNCED]


def tells_its_case(case):
    """Whether PDF and manifest name the SHA-256 of the case that is there now."""
    digest = sha256(case)
    pdf, manifest = announced_of(case)
    text = run("pdftotext", pdf, "-", capture_output=True, text=True).stdout
    return digest in re.sub(r"\s", "", text) and digest in manifest.read_text()


def running_tools():
    """What a make started and did not end: processes that work in this copy."""
    names = []
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            inside = (entry / "fd/200").samefile(ROOT / "build/lock")
            words = (entry / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if inside:
            names.append(words[0].decode(errors="replace"))
    return names
