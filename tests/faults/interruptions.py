# SPDX-License-Identifier: GPL-3.0-or-later
"""Interruptions at random instants of each stage."""

import os
import random
import signal
import time

from checkout import ROOT, end, is_whole_pdf, make, running_tools, sha256, start
from faults_list import add_line, restore
from result import Result

STAGES = {"configure": ("report/CMakeLists.txt", "# configures"), "compute": ("report/ruggiero2001.toml", "# computes"),
          "draw": ("figures/style.gp", "# draws"), "typeset": ("report/sections/second.tex", "Typesets.")}
SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGKILL]


def begins(stage):
    """Whether the stage is running, by what it leaves on disk."""
    return (ROOT / f"build/report/state/{stage}.unfinished").exists()


def duration(stage, reference):
    """How long the stage takes here."""
    name, line = STAGES[stage]
    add_line(name, line)
    process, begin, last = start("report"), None, None
    started = time.monotonic()
    while process.poll() is None:
        if stage == "configure" or begins(stage):
            begin = begin or time.monotonic()
            last = time.monotonic()
        time.sleep(0.01)
    end(process)
    restore(name)
    assert make("report").status == 0
    return max(0.3, (last or started) - (begin or started))


def interrupt(stage, seconds, number, reference, seed):
    """Interrupts one make in one stage; the next plain one has to give the reference."""
    chance = random.Random(f"{seed} {stage} {number}")
    sent, to_group, hears_interrupts = SIGNALS[number % 3], number // 3 % 2 == 1, number // 6 % 2 == 0
    name, line = STAGES[stage]
    add_line(name, line)
    process = start("report", hears_interrupts=hears_interrupts)
    while process.poll() is None and stage != "configure" and not begins(stage):
        time.sleep(0.002)
    after = chance.uniform(0, seconds)
    time.sleep(after)
    is_late = process.poll() is not None
    if not is_late:
        (os.killpg if to_group else os.kill)(process.pid, sent)
    first = end(process)
    left = running_tools()
    for _ in range(60):  # what got the signal may take a moment to go
        left = running_tools()
        if not left:
            break
        time.sleep(0.05)
    survived = is_whole_pdf()
    restore(name)
    second = make("report")
    from checkout import announced
    same = second.status == 0 and announced() == reference
    to = ("the group" if to_group else "make") + ("" if hears_interrupts else " in the background")
    title = f"{sent.name} to {to} {after:.2f} s into {stage}"
    verdict = "stuck" if not same else "the PDF was lost" if not survived else "left running" if left and sent != signal.SIGKILL else "good"
    said = second.said() if not same else (" ".join(left) if left else "")
    return Result(title + (" (had ended)" if is_late else ""), first.status, said, survived, same, verdict)
