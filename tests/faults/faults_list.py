# SPDX-License-Identifier: GPL-3.0-or-later
"""The faults: what each breaks, and what is to come of it."""

import os
import re
import shutil
import stat
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

from checkout import ROOT, environment, make

SECOND = "report/sections/second.tex"
CASE = ROOT / "report/ruggiero2001.toml"
FIGURE = "build/report/generated/figures/surface-gradient"


@dataclass
class Fault:
    name: str
    # Breaks something and returns variables for the make that follows.
    begin: Callable
    # What a user does before the next make, where the fault is not one that make mends.
    mend: Callable = lambda: None
    # What the line has to hold if the make fails; it may succeed if `may_pass`.
    said: str = ""
    may_pass: bool = True
    # Whether success gives a report of other sources, which must then say so itself.
    is_other: bool = False
    # Whether the PDF must be the same although what it is made from was touched.
    is_same_pdf: bool = False
    # What it has to say although it succeeds.
    warns: str = ""
    target: str = "report"
    # Something to do while the make runs; it gets the process.
    during: Callable | None = None
    is_fast: bool = False
    variables: dict = field(default_factory=dict)


# --- what was built is damaged -----------------------------------------------------------------------------------------

def emptied(path):
    path.write_bytes(b"")


def halved(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def flipped(path):
    text = bytearray(path.read_bytes())
    if text:
        text[len(text) // 3] ^= 1
    path.write_bytes(bytes(text))


def removed(path):
    path.unlink()


DAMAGED = [
    "build/report/report.pdf", "build/report/manifest.json", "build/report/generated.sha256",
    "build/report/state/compute", "build/report/state/draw", "build/report/state/typeset",
    "build/report/latex/report.pdf", "build/report/latex/report.aux", "build/report/latex/report.fdb_latexmk",
    "build/report/latex/report.log", "build/report/latex/report.fls", "build/report/latex/report.out",
    "build/report/latex/report.toc", "build/report/latex/as-left.sha256", "build/report/latex/restyled.tex",
    "build/report/latex/statements.tex", "build/report/latex/preamble/preamble.fmt",
    "build/report/latex/preamble/preamble.sha256", "build/report/generated/names.json",
    "build/report/generated/values.tex", "build/report/generated/literate.sty",
    "build/report/generated/tables/hertz.tex", "build/report/generated/figures/style.gp",
    f"{FIGURE}/surface-gradient.pdf", f"{FIGURE}/surface-gradient.tex", f"{FIGURE}/surface-gradient.gp",
    f"{FIGURE}/script.gp", f"{FIGURE}/files.tex", f"{FIGURE}/drawn.sha256",
    "build/release/halfspace-report", "build/release/report.linked", "build/release/report.compiled", "build/release/report.settings",
    "build/release/build.ninja", "build/release/CMakeFiles/rules.ninja", "build/release/CMakeCache.txt",
    "build/release/CMakeFiles/cmake.verify_globs", "build/release/generated/report/repository/repository.json",
    "build/release/generated/report/repository/repository.tex", "build/lock",
]
FAST_DAMAGE = {("report.pdf", flipped), ("generated.sha256", emptied)}


def damages():
    for name in DAMAGED:
        for how in (emptied, halved, flipped, removed):
            path = ROOT / name

            def begin(path=path, how=how):
                how(path)
                # What only LaTeX reads harms when LaTeX runs.
                return add_line(SECOND, "% typesets") if "/latex/" in str(path) and path.suffix != ".pdf" else {}

            is_fast = (path.name, how) in FAST_DAMAGE
            is_touched = "/latex/" in name and path.suffix != ".pdf"
            yield Fault(f"{name} {how.__name__}", begin, is_fast=is_fast, is_same_pdf=is_touched)
    yield Fault("the log of Ninja loses its last lines", lambda: cut("build/release/.ninja_log", 600))
    yield Fault("a folder of LaTeX is removed", lambda: gone("build/report/latex"))
    yield Fault("the generated files are removed", lambda: gone("build/report/generated"))
    yield Fault("the states are removed", lambda: gone("build/report/state"))
    yield Fault("a drawing at a width is emptied", lambda: emptied_below("build/report/latex/at-width", ".pdf"))
    yield Fault("a file of the user's lies among the generated ones", stray, mend=no_stray, said="mine.sty", may_pass=False)


def cut(name, n_bytes):
    path = ROOT / name
    path.write_bytes(path.read_bytes()[:-n_bytes])
    return {}


def gone(name):
    shutil.rmtree(ROOT / name)
    return {}


def emptied_below(folder, ending):
    for path in (ROOT / folder).rglob("*" + ending):
        path.write_bytes(b"")
    return {}


def stray():
    (ROOT / "build/report/generated/mine.sty").write_text("% mine\n")
    add_line("report/report.tex", "% asks for typesetting")
    return {}


def no_stray():
    (ROOT / "build/report/generated/mine.sty").unlink()
    restore("report/report.tex")


# --- sources -----------------------------------------------------------------------------------------------------------

SAVED = {}


def save(name):
    path = ROOT / name
    if name not in SAVED:
        SAVED[name] = (path.read_bytes(), path.stat())
    return path


def restore(name):
    text, status = SAVED.pop(name)
    path = ROOT / name
    path.write_bytes(text)
    os.chmod(path, stat.S_IMODE(status.st_mode))


def add_line(name, line, before=None):
    path = save(name)
    text = path.read_text()
    path.write_text(text.replace(before, f"{line}\n{before}", 1) if before else text + line + "\n")
    return {}


def replace(name, old, new):
    path = save(name)
    text = path.read_text()
    assert old in text, (name, old)
    path.write_text(text.replace(old, new, 1))
    return {}


def wrong_source(title, name, old, new, said, **more):
    return Fault(title, lambda: replace(name, old, new), mend=lambda: restore(name), said=said, may_pass=False, **more)


def mistakes():
    tex, second = "report/report.tex", "report/sections/second.tex"
    yield wrong_source("an unknown macro", second, "comes before", r"\nonsense", r"second\.tex:\d+.*ndefined", is_fast=True)
    yield wrong_source("a brace that is not closed", second, "before", r"\textbf{", r"(second|report)\.tex|aragraph|File ended")
    yield wrong_source("an unknown value", tex, r"\val{provenance.case}", r"\val{provenance.cas}", r"report\.tex:\d+:\d+.*provenance\.cas")
    yield wrong_source("an unknown figure", second, r"\fig{cylinder-pressure}", r"\fig{cylinder-presure}", r"second\.tex:\d+")
    yield wrong_source("a reference to nowhere", second, "sec:first", "sec:frist", r"sec:frist")
    yield wrong_source("a package that is not there", tex, r"\usepackage{lmodern}", r"\usepackage{nosuch}", r"report\.tex:\d+: .*nosuch\.sty")
    yield wrong_source("a missing file of the prose", tex, r"\input{sections/second}", r"\input{sections/third}", r"report\.tex:\d+:\d+: .*third")
    yield wrong_source("a box far too wide", second, "comes before", r"\hbox to 60cm{x}", r"Overfull")
    yield wrong_source("a script with an error", "figures/surface-gradient.gp", "plot", "plott", r"surface-gradient\.gp")
    yield wrong_source("a style with an error", "figures/style.gp", "set ", "sett ", r"style\.gp:\d+")
    yield wrong_source("a case that is no TOML", CASE.relative_to(ROOT), "[contact]", "[contact", r"ruggiero2001\.toml:\d+")
    yield wrong_source("a case with an unknown unit", CASE.relative_to(ROOT), 'unit = "GPa"', 'unit = "Gpaa"', r"toml:\d+:\d+")
    yield wrong_source("a list of CMake with an error", "report/CMakeLists.txt", "literate_add_paper", "literate_ad_paper",
                       r"CMake Error at report/CMakeLists\.txt:\d+")
    yield wrong_source("an include of LaTeX that is a broken picture", second, r"\fig{cylinder-pressure}",
                       r"\includegraphics{sections/broken.pdf}", r"broken\.pdf", during=None)
    yield Fault("a script of a figure that is missing", lambda: moved("figures/cylinder-pressure.gp"),
                mend=lambda: restore("figures/cylinder-pressure.gp"), said=r"cylinder-pressure", may_pass=False)
    yield Fault("a case that is not there", lambda: {}, target="report CASE=none.toml", said=r"none\.toml", may_pass=False)
    for name in ["a$b.toml", "a:b.toml", 'a"b.toml']:
        yield Fault(f"a case with the name {name!r}", lambda name=name: odd_case(name), mend=lambda name=name: (ROOT / name).unlink(),
                    is_other=True)
    for name in ["a;b.toml", "a|b.toml", "a\\b.toml", "a\nb.toml", "blank .toml "]:
        yield Fault(f"a case with the name {name!r}", lambda name=name: odd_case(name), mend=lambda name=name: (ROOT / name).unlink(),
                    said="CASE", may_pass=False)


def odd_case(name):
    (ROOT / name).write_text(CASE.read_text() + f"# another case than the paper's, {name!r}\n")
    return {"CASE": str(ROOT / name)}


def moved(name):
    save(name).unlink()
    return {}


# --- saved at the wrong moment, or with the wrong time stamp ------------------------------------------------------------

def while_file(name, action, n=1):
    """Runs the action when a file comes to be or changes for the n-th time."""
    def during(process):
        path = ROOT / name
        before = path.stat().st_mtime_ns if path.exists() else None
        while process.poll() is None:
            if path.exists() and path.stat().st_mtime_ns != before:
                time.sleep(0.25)
                action()
                return
            time.sleep(0.005)
    return during


def older(name, old, new):
    path = save(name)
    text = path.read_text()
    assert old in text
    status = path.stat()
    beside = path.with_name(path.name + ".beside")
    beside.write_text(text.replace(old, new, 1))
    os.utime(beside, ns=(status.st_atime_ns - 10**15, status.st_mtime_ns - 10**15))
    os.replace(beside, path)
    return {}


def moments():
    case = CASE.relative_to(ROOT)
    def recompute():
        return add_line(case, "# computes")
    state = "build/report/state/"
    yield Fault("the case is saved while it is computed from", recompute, mend=lambda: restore(case), is_other=True,
                during=while_file(state + "compute.unfinished", lambda: replace(case, "nodes = 91", "nodes = 93")))
    yield Fault("the case is saved while figures are drawn", recompute, mend=lambda: restore(case), is_other=True,
                during=while_file(state + "draw.unfinished", lambda: replace(case, "nodes = 91", "nodes = 93")))
    yield Fault("the case is saved while LaTeX runs", recompute, mend=lambda: restore(case), is_other=True,
                during=while_file(state + "typeset.unfinished", lambda: replace(case, "nodes = 91", "nodes = 93")))
    second = "report/sections/second.tex"
    yield Fault("the prose is saved while LaTeX runs", lambda: add_line(second, "One more."), mend=lambda: restore(second),
                is_other=True, during=while_file(state + "typeset.unfinished", lambda: add_line(second, "And another.")))
    yield Fault("the case is replaced by an older one", lambda: older(case, "nodes = 91", "nodes = 93"),
                mend=lambda: restore(case), is_other=True)
    yield Fault("the prose is replaced by an older one", lambda: older(second, "comes", "stands"),
                mend=lambda: restore(second), is_other=True)
    yield Fault("a script is replaced by an older one", lambda: older("figures/surface-gradient.gp", "plot", "set grid\nplot"),
                mend=lambda: restore("figures/surface-gradient.gp"), is_other=True)
    yield Fault("a case outside is replaced by an older one", outside, mend=lambda: shutil.rmtree("/tmp/outside faults"),
                is_other=True)


def outside():
    folder = Path("/tmp/outside faults")
    folder.mkdir(exist_ok=True)
    other = folder / "other.toml"
    shutil.copy(CASE, other)
    assert make("report", f"CASE={other}").status == 0
    other.write_text(other.read_text().replace("nodes = 91", "nodes = 93"))
    os.utime(other, (10**9, 10**9))
    return {"CASE": str(other)}


# --- clocks ------------------------------------------------------------------------------------------------------------

def dated(name, seconds):
    path = ROOT / name
    os.utime(path, (time.time() + seconds,) * 2)
    return {}


def clocks():
    for name in ["CMakeLists.txt", "report/CMakeLists.txt", "CMakePresets.json"]:
        yield Fault(f"{name} is dated in the future", lambda name=name: dated(name, 10**7), mend=lambda name=name: dated(name, 0),
                    said=name.replace(".", r"\.") + ".*future", may_pass=False, is_fast=name == "CMakeLists.txt")
    for name in ["report/ruggiero2001.toml", "report/sections/second.tex", "figures/style.gp"]:
        yield Fault(f"{name} is dated in the future", lambda name=name: dated(name, 10**7), mend=lambda name=name: dated(name, 0))
    if shutil.which("faketime"):
        for offset in ["-3y", "+3y", "-2h"]:
            yield Fault(f"the clock is set by {offset}", lambda offset=offset: with_clock(offset))


def with_clock(offset):
    add = subprocess.run(["faketime", "-f", offset, "env"], capture_output=True, text=True, check=True).stdout
    found = dict(line.split("=", 1) for line in add.splitlines() if line.startswith(("LD_PRELOAD=", "FAKETIME")))
    dated("report/sections/second.tex", 0)
    return found
