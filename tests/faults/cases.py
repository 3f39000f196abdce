# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged case files: mutations that know what a case is made of, from a seed."""

import random
import re
import subprocess
import tempfile
from pathlib import Path

from checkout import ROOT
from result import Result

NUMBERS = ["0", "-1", "1e308", "-1e308", "1e-308", "1e400", "nan", "inf", "-inf", "0.5", "1", "2", "1000000000000", '"1"', "true",
           "[]", "{}", "1e-9", "1e9", "0.4999999", "-0.0", "3.5"]
UNITS = ['"m"', '"in"', '"psi"', '"GPa"', '"N"', '"N/m"', '"K"', '"degC"', '"in @ 1"', '"in from 3"', '"lg(re 1 mm)"', '""', '"mm^2"',
         '"furlong"', '"nonsense"', '"1"', "3", '"m" ', '"µm"', '"inch^-1"']
KEYS = ["title", "units", "datum", "young", "poisson", "peak_pressure", "half_width", "first", "step", "count", "load", "nodes", "radius",
        "width", "height", "sides", "density", "order", "refine", "source"]


def mutated(text, chance):
    """One or two mutations of a case; says which."""
    what = []
    for _ in range(chance.choice([1, 1, 1, 2])):
        lines = text.splitlines()
        settings = [i for i, line in enumerate(lines) if "=" in line and not line.lstrip().startswith("#")]
        tables = [i for i, line in enumerate(lines) if line.startswith("[")]
        i = chance.choice(settings)
        kind = chance.choice(["number", "number", "number", "unit", "unit", "remove", "double", "rename", "table", "no table", "byte", "cut",
                              "type", "swap", "text"])
        if kind == "number":
            lines[i] = re.sub(r"(=\s*)(-?\d[\d.e+-]*)", lambda m: m[1] + chance.choice(NUMBERS), lines[i], count=1)
            if "value" in lines[i]:
                lines[i] = re.sub(r"(value = )[^,]*", lambda m: m[1] + chance.choice(NUMBERS), lines[i], count=1)
        elif kind == "unit":
            lines[i] = re.sub(r'(unit = )"[^"]*"', lambda m: m[1] + chance.choice(UNITS), lines[i])
        elif kind == "remove":
            lines.pop(i)
        elif kind == "double":
            lines.insert(i, lines[i])
        elif kind == "rename":
            lines[i] = re.sub(r"^\s*\w+", chance.choice(KEYS + ["nonsense"]), lines[i])
        elif kind == "table":
            j = chance.choice(tables)
            lines[j] = chance.choice(["[nonsense]", "[half_space]", "[[contact]]", "[contact.body3]", "[", "[block]"])
        elif kind == "no table":
            lines.pop(chance.choice(tables))
        elif kind == "byte":
            j = chance.randrange(len(lines[i]) or 1)
            lines[i] = lines[i][:j] + chance.choice("\x00\x07é\"'=[]{},#\\\t") + lines[i][j + 1:]
        elif kind == "cut":
            lines = lines[:i] + [lines[i][: len(lines[i]) // 2]]
        elif kind == "type":
            lines[i] = re.sub(r"=.*", "= " + chance.choice(['"text"', "1", "true", "[1, 2]", "{value = 1}", "2001-04-23", '{unit = "m"}']), lines[i])
        elif kind == "swap":
            j = chance.choice(settings)
            lines[i], lines[j] = lines[j], lines[i]
        elif kind == "text":
            lines[i] = re.sub(r'"[^"]*"', lambda m: chance.choice(['"' + "x" * 400 + '"', '"😀"', r'"\\input{x}"', '"%&$#_{}"', '""', '" "']), lines[i], count=1)
        what.append(f"{kind} in line {i + 1}")
        text = "\n".join(lines) + "\n"
    return text, ", ".join(what)


def write_settings(folder, case):
    """Writes to the folder what a stage has to know to compute the report from the case there."""
    file = folder / "report.settings"
    file.write_text(f"name=report\nroot={ROOT}\ndocument={ROOT}/report\nmain=report.tex\ncase={case}\nfigures={ROOT}/figures\n"
                    f"output={folder}\n")
    return file


def try_case(number, seed, original):
    """Computes from one damaged case: it is either accepted or refused with its place."""
    chance = random.Random(f"{seed} case {number}")
    text, what = mutated(original, chance)
    with tempfile.TemporaryDirectory(prefix="fault case ") as folder:
        case = Path(folder) / "case.toml"
        case.write_text(text)
        try:
            done = subprocess.run([ROOT / "build/release/halfspace-report", "compute", write_settings(Path(folder), case)], capture_output=True, text=True, errors="replace", timeout=120)
            status, errors = done.returncode, done.stderr
        except subprocess.TimeoutExpired:
            status, errors = None, ""
        begun = (Path(folder) / "generated").exists()
    lines = [line for line in errors.splitlines() if ": warning: " not in line]
    said = lines[0] if lines else ""
    place = re.search(r"case\.toml:\d+:\d+: \S", said)
    if status == 0:
        verdict = "good" if not re.search(r"\bnan\b", errors) else "false"
    elif status == 2:
        verdict = "good" if place and len(lines) == 1 and not begun else "no place"
    elif status == 1:
        verdict = "good" if re.search(r"(check|claim) \S+", said) else "no place"
    else:
        verdict = "hung" if status is None else "no cause"
    return Result(f"case {number}: {what}", status, said.replace(folder, ""), True, True, verdict)
