#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""examples_test.py SOURCE_DIR LITERATE PROGRAM: the manual's examples make a paper that typesets, and print what the
manual says. PROGRAM is made of the C++ among them (program.cpp.in), the paper of the others."""

import pathlib
import re
import subprocess
import sys
import tempfile

from claims import claim, failed, finish
from manual import Manual, codes, filled

source, literate, program = map(pathlib.Path, sys.argv[1:])
here = source / "tests/literate/manual"
readme = (source / "src/literate/README.md").read_text()
manual = Manual(readme)


def runs(*command, folder):
    done = subprocess.run(list(map(str, command)), cwd=folder, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    return done.returncode, done.stdout + done.stderr


PIXEL = bytes.fromhex(  # a PNG of one white pixel
    "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de"
    "0000000c49444154789c63f8ffff3f0005fe02fe0def46b80000000049454e44ae426082")


def write_paper(paper, latex):
    """What the examples stand in: the template, with the manual's figure, quotation and prose instead of its own."""
    (paper / "case.toml").write_text('# 90 in\nangle = 90\nlength = {value = 39.4, unit = "in"}\n')
    (paper / "figures/period.gp").write_text(manual.example("Figures: gnuplot") + "\n")
    (paper / "paper/quotations.toml").write_text(manual.example("Quotations: toml") + "\n")
    (paper / "paper/mypaper.tex").write_text(latex)
    (paper / "paper/pictures").mkdir()
    (paper / "paper/pictures/rig.png").write_bytes(PIXEL)
    (paper / "octave").mkdir()
    (paper / "octave/run.m").write_text("x = 1\n")
    (paper / "octave/results.json").write_text(
        '{"script": "run.m", "values": {"from-octave": {"value": 2.385, "abs_error": 1e-4, "unit": "m"}}}\n')
    (paper / "measure.py").write_text("print(1)\n")
    (paper / "measured.csv").write_text("x (m),u (mm),abs_error\n1.5,2.385,0.001\n")


def restyled_prints(text):
    """What restyled.tex prints of each «key[options]», as plain text."""
    return {key + options: plain.replace("\\%", "%")
            for key, options, plain in re.findall(r"\\LiterateRestyled\{(.*?)\}\{(\[.*\])\}\{.*\}\{(.*?)\}$", text, re.M)}


with tempfile.TemporaryDirectory() as scratch:
    paper = pathlib.Path(scratch) / "mypaper"
    words = manual.example("literate: sh").split("\n")[0].split(" ")
    claim("the manual's first command is of literate", words[0] == "literate")
    status, said = runs(literate, *words[1:], folder=scratch)
    claim("the manual's first command writes a paper", status == 0 and paper.is_dir(), said)
    template, used_by_prose = filled((here / "manual.tex.in").read_text(), manual, "%")
    write_paper(paper, template)

    (paper / "manual.settings").write_text(
        f"name=manual\nroot=.\ndocument=paper\nmain=mypaper.tex\ncase=case.toml\nfigures=figures\noutput=.\n"
        f"engine={source / 'src/literate'}\n")
    status, said = runs(program, "compute", "manual.settings", folder=paper)
    claim("the program of the examples computes, and prints what the manual says", status == 0, said)
    if failed:
        finish()  # all else follows from it
    status, said = runs(program, "draw", "manual.settings", folder=paper)
    claim("the figure of the examples is drawn", status == 0, said)
    status, said = runs(program, "typeset", "manual.settings", folder=paper)
    claim("the commands of the manual typeset", status == 0, said)

    status, said = runs(program, "page", "manual.settings", folder=paper)
    claim("the commands of the manual are known to the page", status == 0, said)

    prints = restyled_prints((paper / "latex/restyled.tex").read_text())
    for cells in manual.tables["Restyling: option"]:
        command, wanted = codes(cells[0])[0], re.split(r"[;,] | of a | for a ", cells[1])[0]
        if found := re.fullmatch(r"\\val(\[.*\])\{(.*)\}", command):
            printed = prints.get(found[2] + found[1])
            claim(f"{command} prints {wanted}", printed == wanted, printed)

    # The errors that the manual shows
    (paper / "paper/more.tex").write_text(r"It is \val[digits=6]{period}." "\n")
    status, said = runs(program, "typeset", "manual.settings", folder=paper)
    shown = re.search(r"`mypaper.tex:12:7: (\\val\[digits=6\].*?)`", readme.replace("\n", " "))[1]
    claim("digits that the error does not support end with 2 and the message of the manual",
          status == 2 and f"paper/more.tex:1:7: {shown}" in said, said)

    status, said = runs(program, "--help", folder=paper)
    stages = set(re.findall(r"^  (\w+) ", said.split("Subcommands:")[1], re.M))
    named = set(codes(re.search(r"has the stages (.*?)\.", readme.replace("\n", " "))[1]))
    claim("the manual names the stages", stages == named, f"{stages} {named}")

# Nothing that a reader would copy is left out.
_, used_by_program = filled((here / "program.cpp.in").read_text(), manual, "//")
used = used_by_program | used_by_prose | {"Figures: gnuplot", "Quotations: toml", "literate: sh"}
elsewhere = {"Install: sh", "Install: cmake", "The smallest paper: cmake", "The smallest paper: cpp",
             "The smallest paper: latex",  # package_test.sh
             "Numbers from elsewhere: cmake"}  # run_script_test.sh
for name, _ in manual.fences:
    claim(f"the example «{name}» is tried", name in used | elsewhere)
tried = " ".join((template + (here / "program.cpp.in").read_text()).split())
for code in codes(manual.prose):
    if re.match(r"\\(val|rawval|tab|fig|excerpt|statement|claim|quoted)\b.*\{|\w+(\.\w+)*\(.*\)(\.\w+\(.*\))*$", code):
        claim(f"`{code}` is tried", " ".join(code.split()) in tried)

finish()
