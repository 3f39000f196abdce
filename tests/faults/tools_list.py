# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of the tools, of the disk and of two makes at once."""

import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from checkout import HERE, ROOT, end, environment, start
from faults_list import Fault, add_line, emptied, restore

DRAWN = "build/report/generated/figures/surface-gradient/drawn.sha256"
SECOND = "report/sections/second.tex"


def fake(tool, script):
    """A folder for the front of PATH in which a shell script is the tool; $REAL is the real one."""
    folder = Path(tempfile.mkdtemp(prefix="fault tool "))
    path = folder / tool
    path.write_text(f'#!/bin/bash\nREAL={shutil.which(tool)}\n{script}\n')
    path.chmod(0o755)
    return {"PATH": f"{folder}:{os.environ['PATH']}"}


def without(*tools):
    """A PATH in which these tools are not to be found."""
    folder = Path(tempfile.mkdtemp(prefix="fault path "))
    for place in os.environ["PATH"].split(":"):
        for entry in Path(place).iterdir() if Path(place).is_dir() else []:
            link = folder / entry.name
            if entry.name not in tools and not link.is_symlink():
                link.symlink_to(entry)
    return {"PATH": str(folder)}


def draws():
    """Has make draw a figure."""
    emptied(ROOT / DRAWN)


def gnuplot(title, script, said, **more):
    def begin():
        draws()
        # Asked for its version it answers as ever.
        return fake("gnuplot", f'if [[ $* == *--version* ]]; then exec "$REAL" "$@"; fi\n{script}') | more.get("variables", {})
    return Fault(title, begin, said=said, may_pass=False, is_fast=more.get("is_fast", False))


def latex(title, script, said, **more):
    def begin():
        add_line(SECOND, "% typesets")
        return fake("pdflatex", f'if [[ $* == *--version* || $* == *-ini* ]]; then exec "$REAL" "$@"; fi\n{script}') | \
            more.get("variables", {})
    return Fault(title, begin, mend=lambda: restore(SECOND), said=said, may_pass=more.get("may_pass", False), is_same_pdf=True)


def tools():
    figure = r"surface-gradient"
    yield gnuplot("gnuplot fails without a word", "exit 3", figure + r".*status 3")
    yield gnuplot("gnuplot is killed", "kill -9 $$", figure + r".*signal 9")
    yield gnuplot("gnuplot does nothing and succeeds", "exit 0", figure)
    for ending in ["pdf", "tex"]:
        halve = f'"$REAL" "$@" || exit; for f in *.{ending}; do truncate -s $(($(stat -c %s "$f") / 2)) "$f"; done'
        yield gnuplot(f"gnuplot leaves half a .{ending} and succeeds", halve, figure + r".*not whole", is_fast=ending == "pdf")
        empty = f'"$REAL" "$@" || exit; for f in *.{ending}; do : >"$f"; done'
        yield gnuplot(f"gnuplot leaves an empty .{ending} and succeeds", empty, figure)
    yield gnuplot("gnuplot warns", 'echo "line 0: warning: something" >&2; exit 1', figure + ".*something")
    yield gnuplot("gnuplot hangs", "sleep 1000", figure + r".*TIMEOUT", variables={"TIMEOUT": "5"}, is_fast=True)
    yield gnuplot("gnuplot floods", "yes | head -c 30000000; exit 1", figure)
    tex = r"report\.tex|LaTeX"
    yield latex("pdflatex fails without a word", "exit 3", tex)
    yield latex("pdflatex is killed", "kill -9 $$", tex)
    yield latex("pdflatex does nothing and succeeds", "exit 0", tex)
    yield latex("pdflatex leaves half a PDF and succeeds",
                '"$REAL" "$@"; s=$?; f=build/report/latex/report.pdf; cd "' + str(ROOT) +
                '"; truncate -s $(($(stat -c %s $f) / 2)) $f; exit $s', tex)
    yield latex("pdflatex hangs", "sleep 1000", tex + ".*TIMEOUT", variables={"TIMEOUT": "4"})
    yield latex("pdflatex says !pdfTeX error",
                'printf "%s\\n" "!pdfTeX error: pdflatex (file x.pdf): cannot read" >"' + str(ROOT) +
                '/build/report/latex/report.log"; exit 1', r"pdfTeX error.*x\.pdf")
    yield latex("pdflatex fails once", 'f=$(dirname "$0")/failed; if [[ ! -e $f ]]; then : >"$f"; exit 1; fi; exec "$REAL" "$@"', tex,
                may_pass=True)
    yield Fault("the checkout is no repository", lambda: renamed(".git", ".no-git"), mend=lambda: renamed(".no-git", ".git"),
                warns="warning: the commit of .* is unknown", is_same_pdf=True)
    for tool in ["gnuplot", "latexmk", "pdflatex", "ninja", "cmake", "g++"]:
        yield Fault(f"{tool} is not in PATH", lambda tool=tool: without(tool), said=tool.replace("+", r"\+"), may_pass=False)
    yield Fault("git is not in PATH", lambda: without("git"), said="git", may_pass=False)
    yield Fault("setpriv is not in PATH", lambda: without("setpriv"))
    yield Fault("pdftocairo is not in PATH", lambda: without("pdftocairo"), target="html", said="poppler-utils", may_pass=False)
    yield Fault("TIMEOUT is no number", lambda: draws() or {"TIMEOUT": "soon"}, said="TIMEOUT.*soon", may_pass=False)
    yield Fault("a manifest of 200000 brackets", brackets, mend=lambda: (ROOT / "odd.json").unlink(), said=r"odd\.json", may_pass=False,
                target="verify MANIFEST=odd.json")
    yield Fault("the build folder is a file", build_is_a_file, mend=build_is_a_folder, said="build", may_pass=False)


def renamed(old, new):
    (ROOT / old).rename(ROOT / new)
    return {}


def brackets():
    (ROOT / "odd.json").write_text("[" * 200000)
    return {}


def build_is_a_file():
    (ROOT / "build").rename(ROOT / "kept build")
    (ROOT / "build").write_text("")
    return {}


def build_is_a_folder():
    (ROOT / "build").unlink()
    (ROOT / "kept build").rename(ROOT / "build")


# --- the disk ------------------------------------------------------------------------------------------------------------

LIBRARY = Path(tempfile.gettempdir()) / f"failing_write_{os.getpid()}.so"


def failing_write():
    if not LIBRARY.exists():
        subprocess.run(["gcc", "-shared", "-fPIC", "-O1", "-o", LIBRARY, HERE / "failing_write.c", "-ldl"], check=True)
    return LIBRARY


def writes():
    reason = {"ENOSPC": "No space left on device", "EIO": "Input/output error"}
    for stage in ["compute", "draw", "typeset"]:
        for kind in ["ENOSPC", "EIO", "short"]:
            for at in [1, 2, 3, 5, 8, 20]:
                def begin(stage=stage, kind=kind, at=at):
                    add_line({"compute": "report/ruggiero2001.toml", "draw": "figures/style.gp", "typeset": SECOND}[stage],
                             {"typeset": "% again"}.get(stage, "# again"))
                    return {"LD_PRELOAD": str(failing_write()), "FAULT_PROGRAM": "halfspace-report", "FAULT_STAGE": stage,
                            "FAULT_AT": str(at), "FAULT_KIND": kind}

                def mend(stage=stage):
                    restore({"compute": "report/ruggiero2001.toml", "draw": "figures/style.gp", "typeset": SECOND}[stage])

                yield Fault(f"write {at} of {stage} fails: {kind}", begin, mend=mend, said=reason.get(kind, "nothing"),
                            may_pass=True, is_fast=stage == "compute" and kind == "ENOSPC" and at == 2, is_other=True)


# --- two makes -----------------------------------------------------------------------------------------------------------

def parent_of(process):
    """The number of a process's parent, or none if the process has ended or the number is yet to be written."""
    if not process:
        return None
    try:
        return int(Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[1])
    except (FileNotFoundError, ProcessLookupError):
        return None


def second_make(process):
    """Starts a second make as soon as the first has the lock; keeps what it said."""
    while process.poll() is None and parent_of((ROOT / "build/lock").read_text().strip()) != process.pid:
        time.sleep(0.01)
    second = end(start("report"))
    SECOND_SAID.append(second)


SECOND_SAID = []


def at_once():
    yield Fault("two makes at once", lambda: add_line(SECOND, "% typesets"), mend=lambda: restore(SECOND), during=second_make, is_same_pdf=True, is_fast=True)
